#include "tactile/effect.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "tactile/detail/tact.h"

namespace thaum::tactile {
namespace {

constexpr std::size_t max_effects = 1000;
constexpr std::size_t longest_caption = 32;  // longest caption that an effect may have (letters)

/// Curve that rises from 0 to 1; smooth if `smooth` is true, else straight.
double eased(double x, bool smooth) { return smooth ? x * x * (3 - 2 * x) : x; }

double positive(const ConfigTable& table, const char* key, double most) {
    return table.number(key, {1e-6, most});
}

BodyPoint read_point(const ConfigTable& table) {
    BodyPoint point;
    point.part = static_cast<Part>(table.choice("part", part_names()));
    point.at = table.vector("at_m", {-2.5, 2.5});
    return point;
}

void read_force(const ConfigTable& root, Effect& effect) {
    effect.method = static_cast<Method>(root.choice("method", {"impact", "vibration", "both"}));
    const auto amplitude = root.table("amplitude_mm");
    effect.weakest = amplitude.number("weakest", {0, 10}) * 1e-3;
    effect.strongest = amplitude.number("strongest", {0, 10}) * 1e-3;
    if (effect.weakest > effect.strongest)
        amplitude.report("weakest", "'weakest' must not be above 'strongest'");
    effect.wavelength = root.number("wavelength_ms", {1, 200}) * 1e-3 * skin_speed;
    effect.stiffness = root.number("stiffness_n_per_m", {1, 1e5}, 5000);
    effect.damping = root.number("damping_n_s_per_m", {0, 100}, 0);
}

void read_envelope(const ConfigTable& table, Envelope& envelope) {
    if (table.has("swell_ms")) {
        envelope.attack = envelope.decay = positive(table, "swell_ms", 5000) / 2;
        envelope.smooth = true;
        return;
    }
    envelope.attack = table.number("attack_ms", {0, 5000});
    envelope.hold = table.number("hold_ms", {0, 5000});
    envelope.decay = table.number("decay_ms", {0, 5000});
    if (envelope.length() < 1)
        table.report("decay_ms", "the envelope is empty: its three times must sum to 1 ms");
}

void read_pattern(const ConfigTable& table, Effect& effect) {
    effect.pattern =
        static_cast<Pattern>(table.choice("kind", {"single", "spread", "sweep", "heartbeat", "clip"}));
    effect.sigma_cells = {table.number("across_cells", {0.2, 100}, 0.7),
                          table.number("up_cells", {0.2, 100}, 0.7)};
    switch (effect.pattern) {
        case Pattern::single: break;
        case Pattern::spread:
            effect.speed = table.number("speed_m_per_s", {0.01, 100});
            effect.reach = table.number("reach_m", {0.01, 5});
            break;
        case Pattern::sweep:
            effect.length_ms = positive(table, "length_ms", 10'000);
            effect.to = read_point(table.table("to"));
            break;
        case Pattern::heartbeat:
            effect.length_ms = positive(table, "length_ms", 10'000);
            effect.slowest_hz = table.number("slowest_hz", {0.2, 3});
            effect.fastest_hz = table.number("fastest_hz", {0.2, 3});
            if (effect.slowest_hz > effect.fastest_hz)
                table.report("slowest_hz", "'slowest_hz' must not be above 'fastest_hz'");
            break;
        case Pattern::clip:
            effect.clip_file = table.string("file");
            if (!effect.clip_file.ends_with(".tact") || effect.clip_file.find('/') != std::string::npos)
                table.report("file", "'file' must be the name of a .tact file in the folder of the effect");
            break;
    }
}

void read_places(const ConfigTable& root, Effect& effect) {
    const auto places = root.tables("places");
    for (const auto& table : places) effect.places.push_back(read_point(table));
    if (places.size() > 2) root.report("places", "'places' must have at most two entries");
    if (effect.pattern == Pattern::sweep && places.size() > 1)
        root.report("places", "a sweep begins at one place: give one entry");
}

}  // namespace

const std::vector<std::string_view>& purpose_names() {
    static const std::vector<std::string_view> names{"impact",  "blast",  "fall",  "walk",    "magic",
                                                     "warning", "recoil", "fluid", "texture", "music"};
    return names;
}

double Envelope::at(double ms) const {
    if (!(ms >= 0) || ms >= length()) return 0;
    if (ms < attack) return eased(ms / attack, smooth);
    const double down = ms - attack - hold;
    return down <= 0 ? 1 : eased(1 - down / decay, smooth);
}

double Envelope::peak(double from, double to) const {
    if (to < 0 || from >= length()) return 0;
    if (to < attack) return at(to);
    return from <= attack + hold ? 1 : at(from);
}

double Effect::level(double strength) const {
    // The force on the skin is |F_r| = A (k (1 + sin a) + B w max(0, cos a)), with amplitude A, stiffness k,
    // damping B, angular frequency w and the angle a of the grating. While a runs through a period, |F_r|
    // goes from 0 to A times `greatest`.
    const double w = 2 * pi * carrier();
    const double greatest = stiffness + std::sqrt(stiffness * stiffness + damping * w * damping * w);
    return std::min(1.0, amplitude(strength) * greatest / (2 * full_force));
}

double Effect::duration_ms() const {
    switch (pattern) {
        case Pattern::single: break;
        case Pattern::spread: return envelope.length() + 1000 * reach / speed;
        case Pattern::sweep: return length_ms;
        case Pattern::heartbeat: return length_ms + envelope.length() + second_beat_ms;
        case Pattern::clip: return static_cast<double>(clip_frame_ticks * clip.size());
    }
    return envelope.length();
}

Signal signal(const Effect& effect, double strength, double ms) {
    const Grating grating{effect.amplitude(strength), effect.wavelength};
    const double shape = effect.envelope.at(ms);
    const vec2 p(ms * 1e-3 * skin_speed, 0);  // position (m) as the skin moves along the grating
    const double deepening = slope(grating, p.x) * skin_speed;
    const double push =
        reaction(effect.stiffness, effect.damping, impact_depth(grating, p), deepening) * shape / full_force;
    const double drag = reaction(effect.stiffness, effect.damping, vibration_depth(grating, p), deepening) *
                        shape / full_force;
    const vec2 n = normal(grating, p.x);
    switch (effect.method) {
        case Method::impact: return {push, 0};
        case Method::vibration: return {drag * n.y, drag * n.x};
        case Method::both: break;
    }
    return {(push + drag * n.y) / 2, drag * n.x / 2};
}

Expected<Effect> read_effect(const Config& file, std::string name) {
    Effect effect;
    effect.name = std::move(name);
    const auto root = file.root();
    effect.description = root.string("description");
    if (effect.description.empty())
        root.report("description", "'description' must not be empty: say what happens");
    effect.caption = root.string("caption", "");
    if (effect.caption.size() > longest_caption)
        root.report("caption", text("the caption must have at most ", longest_caption, " letters"));
    effect.important = root.boolean("important", false);
    effect.purpose = static_cast<Purpose>(root.choice("purpose", purpose_names()));
    effect.priority = static_cast<int>(root.integer("priority", {0, 9}));
    read_force(root, effect);
    read_pattern(root.table("pattern"), effect);
    if (effect.pattern != Pattern::clip) read_envelope(root.table("envelope"), effect.envelope);
    read_places(root, effect);
    if (auto checked = file.check(); !checked) return std::move(checked.error());
    return effect;
}

std::optional<std::uint32_t> EffectBank::find(std::string_view name) const {
    const auto found =
        std::lower_bound(effects.begin(), effects.end(), name,
                         [](const Effect& effect, std::string_view wanted) { return effect.name < wanted; });
    if (found == effects.end() || found->name != name) return std::nullopt;
    return static_cast<std::uint32_t>(found - effects.begin());
}

namespace {

Expected<Effect> load_effect(const std::filesystem::path& path) {
    auto content = read_text_file(path, 1U << 16U);
    if (!content) return std::move(content.error());
    const auto file = Config::parse(*content, path.string(), 1);
    if (!file) return file.error();
    auto effect = read_effect(*file, path.stem().string());
    if (!effect || effect->pattern != Pattern::clip) return effect;
    const auto clip = path.parent_path() / effect->clip_file;
    const auto json = read_text_file(clip, max_tact_bytes);
    if (!json)
        return fail(text(path.string(), ": 'file': ", json.error().message,
                         near_file(clip.stem().string(), path.parent_path(), ".tact")));
    auto imported = import_tact(*json);
    if (!imported) return fail(text(clip.string(), ": ", imported.error().message));
    effect->clip = std::move(imported->clip.frames);
    return effect;
}

}  // namespace

Expected<EffectBank> load_effects(const std::filesystem::path& folder) {
    const auto files = files_in(folder, ".toml");
    if (!files) return files.error();
    if (files->size() > max_effects)
        return fail(text(folder.string(), ": ", files->size(), " effects: keep at most ", max_effects));
    EffectBank bank;
    for (const auto& path : *files) {
        auto effect = load_effect(path);
        if (effect)
            bank.effects.push_back(std::move(*effect));
        else
            bank.faulty.push_back({path.stem().string(), std::move(effect.error())});
    }
    std::sort(bank.effects.begin(), bank.effects.end(),
              [](const Effect& a, const Effect& b) { return a.name < b.name; });
    return bank;
}

}  // namespace thaum::tactile
