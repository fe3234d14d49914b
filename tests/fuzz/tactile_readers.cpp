// Fuzzes the readers of tactile layouts, effects and .tact files. Whatever is accepted must play within the
// mixer's limits.
#include <algorithm>
#include <memory>

#include "core/file.h"
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "tactile/detail/tact.h"
#include "tactile/mixer.h"
#include "unit/tact_writer.h"

namespace thaum::fuzz {
namespace {

using tactile::Where;

std::vector<std::string> files_in(const std::filesystem::path& folder, const char* ending) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ending) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());  // sorted, because the order of a directory listing is undefined
    std::vector<std::string> result;
    for (const auto& file : files) {
        if (auto content = read_text_file(file, 1U << 20U)) result.push_back(std::move(*content));
    }
    return result;
}

/// Plays all effects of a bank for a second. Returns the first fault in the frames; empty: none.
std::string fault_when_played(const tactile::Layout& layout, const tactile::EffectBank& bank) {
    const auto mixer = std::make_unique<tactile::TactileMixer>(layout, bank);
    for (Tick tick = 0; tick < 1000; tick += tactile::frame_ticks) {
        for (std::uint32_t e = 0; e < bank.effects.size() && tick % 96 == 0; ++e) {
            mixer->start(e, Where::from({1, 0, static_cast<double>(tick) / 500 - 1}), 1, tick);
            mixer->drive(1 + e, e, Where::own(), 0.5, tick);
        }
        double sum = 0;
        for (const float a : mixer->mix(tick).amplitude) {
            if (!(a >= 0 && a <= 1)) return "an amplitude outside of 0 to 1";
            sum += static_cast<double>(a) * a;
        }
        if (!(sum <= 1.5)) return text("a sum of energies of ", sum);
    }
    return "";
}

Outcome outcome_of_playing(const tactile::Layout& layout, const tactile::EffectBank& bank) {
    return {.accepted = true, .fault = fault_when_played(layout, bank)};
}

const std::filesystem::path tactile_folder = std::filesystem::path(THAUM_SOURCE_DIR) / "assets/tactile";

Outcome read_layout_file(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "layout.toml", 1);
    if (!config) return {.refusal = config.error().message};
    const auto layout = tactile::read_layout(*config);
    if (!layout) return {.refusal = layout.error().message};
    static const auto bank = tactile::load_effects(tactile_folder / "effects");
    return bank ? outcome_of_playing(*layout, *bank) : Outcome{.fault = bank.error().message};
}

Outcome read_effect_file(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "effect.toml", 1);
    if (!config) return {.refusal = config.error().message};
    auto effect = tactile::read_effect(*config, "effect");
    if (!effect) return {.refusal = effect.error().message};
    static const auto layout = tactile::load_layout(tactile_folder / "layouts/x40.toml");
    return layout ? outcome_of_playing(*layout, {{std::move(*effect)}})
                  : Outcome{.fault = layout.error().message};
}

Outcome read_tact(const std::string& input, const Places&) {
    auto imported = tactile::import_tact(input);
    if (!imported) return {.refusal = imported.error().message};
    const auto again = tactile::import_tact(tactile::tact_of(imported->clip));
    if (!again) return {.fault = again.error().message};
    if (again->clip != imported->clip) return {.fault = "the clip differs after it was written and read"};
    static const auto layout = tactile::load_layout(tactile_folder / "layouts/pad.toml");
    if (!layout) return {.fault = layout.error().message};
    tactile::Effect effect{.name = "clip", .strongest = 1e-3, .wavelength = 12e-3, .stiffness = 5000};
    effect.pattern = tactile::Pattern::clip;
    effect.clip = std::move(imported->clip.frames);
    return outcome_of_playing(*layout, {{std::move(effect)}});
}

std::vector<std::string> layout_files(const Places&) { return files_in(tactile_folder / "layouts", ".toml"); }
std::vector<std::string> effect_files(const Places&) { return files_in(tactile_folder / "effects", ".toml"); }
std::vector<std::string> tact_files(const Places&) { return files_in(tactile_folder / "effects", ".tact"); }

}  // namespace

const Reader layout_reader{"layout", layout_files, mutate_text, read_layout_file};
const Reader effect_reader{"effect", effect_files, mutate_text, read_effect_file};
const Reader tact_reader{"tact", tact_files, mutate_text, read_tact};

}  // namespace thaum::fuzz
