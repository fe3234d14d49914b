// Fuzzes the reader of saved states of the fluid lab: an accepted state must be a fluid that can continue.
#include "core/hash.h"
#include "fuzz/fuzz.h"
#include "game/data/match_data.h"
#include "game/lab/lab_file.h"

namespace thaum::fuzz {
namespace {

// Sizes (bytes) of a saved fluid's first part, before the data, and of its hash, at the end.
constexpr std::size_t head = 20, hash_size = 8;

std::string text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const game::LabData& lab_data() {
    static const auto data = game::load_lab_data(std::filesystem::path(THAUM_SOURCE_DIR) / "assets");
    return *data;
}

std::vector<std::string> saved_labs(const Places&) {
    std::vector<std::string> seeds;
    for (const bool bowl : {true, false}) {
        auto settings = game::lab_settings(lab_data());
        settings.cells = 15;
        settings.bowl = bowl;
        settings.solver = bowl ? fluid::Solver::thaum : fluid::Solver::classic;
        auto lab = game::make_lab(lab_data().rules, settings);
        if (!lab) return {};
        Jobs jobs(0);
        for (int i = 0; i < 3; ++i)
            game::step_lab(*lab, {.ladle = vec3(0.1 * i, -0.3, 0), .pours = {{0, 0.01, vec3(0, -0.3, 0)}}},
                           jobs);
        seeds.push_back(text_of(game::save_lab(*lab)));
    }
    return seeds;
}

/// In half of the mutants, length and checksum are corrected, so that the code behind those checks is
/// reached.
std::string mutate_lab(const std::vector<std::string>& seeds, Random& random) {
    const auto& seed = seeds[random.below(seeds.size())];
    if (random.below(2) == 0 || seed.size() <= head + hash_size) return mutate_bytes(seeds, random);
    auto body = seed.substr(head, seed.size() - head - hash_size);
    // There are few settings among many samples, so mostly settings are mutated.
    const auto settings = std::min<std::size_t>(body.size(), 500);
    const auto from = random.below(3) == 0 ? body.size() - settings : 0;
    body = body.substr(0, from) + mutate_bytes({body.substr(from, settings)}, random) +
           body.substr(from + settings);
    std::string out = seed.substr(0, 12);
    const std::uint64_t length = body.size();
    out.append(reinterpret_cast<const char*>(&length), sizeof length);
    out += body;
    const auto hash = hash_bytes(std::as_bytes(std::span(out)));
    out.append(reinterpret_cast<const char*>(&hash), sizeof hash);
    return out;
}

Outcome read_saved(const std::string& input, const Places&) {
    auto lab = game::restore_lab(std::as_bytes(std::span(input)), lab_data().rules);
    if (!lab) return {.refusal = lab.error().message};
    Jobs jobs(0);
    for (int i = 0; i < 2; ++i) game::step_lab(*lab, {.ladle = vec3(0.2 * i, -0.3, 0.1)}, jobs);
    if (game::save_lab(*lab).empty()) return {.fault = "it cannot be saved again"};
    return {.accepted = true};
}

}  // namespace

const Reader lab_reader{"lab", saved_labs, mutate_lab, read_saved};

}  // namespace thaum::fuzz
