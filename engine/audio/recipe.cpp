#include "audio/recipe.h"

#include <algorithm>

#include "audio/detail/oscillator.h"
#include "core/config.h"
#include "core/text.h"

namespace thaum::audio {
namespace {

constexpr std::int64_t recipe_version = 1;
constexpr double longest_s = 16, longest_one_shot_s = 1.5, max_grains = 4000, max_work = 4e7;
constexpr Range hz_range{20, 20'000};
constexpr std::size_t max_parts = 16, max_partials = 16, max_notes = 200;

/// Values of the whole sound that are needed to read its parts.
struct Whole {
    double seconds{};
    bool loops{};
};

Envelope read_envelope(const ConfigTable& table, const Whole& whole) {
    Envelope envelope;
    envelope.start = table.number("start", {0, whole.seconds}, 0);
    envelope.attack = table.number("attack", {0.0005, longest_s}, 0.002);
    envelope.hold = table.number("hold", {0, longest_s}, 0);
    envelope.decay = table.number("decay", {0.005, longest_s}, 0);
    envelope.level = table.number("level", {0, 4}, 1);
    envelope.tremolo_hz = table.number("tremolo_hz", {0.05, 100}, 0);
    envelope.tremolo = table.number("tremolo", {0, 1}, 0);
    if (whole.loops && envelope.decay == 0 && (table.has("start") || table.has("attack")))
        table.report("",
                     "a part without 'decay' lasts as long as the loop, so it has no 'start' or 'attack'");
    return envelope;
}

Pitch read_pitch(const ConfigTable& table, const Envelope& envelope, const Whole& whole) {
    Pitch pitch;
    pitch.hz = table.number("hz", hz_range);
    pitch.sweep_to = table.number("sweep_to", hz_range, pitch.hz);
    pitch.sweep_s =
        table.number("sweep_s", {0.001, longest_s}, std::max(0.001, whole.seconds - envelope.start));
    pitch.vibrato_hz = table.number("vibrato_hz", {0.05, 400}, 0);
    pitch.vibrato = table.number("vibrato", {0, 36}, 0);
    if (whole.loops && envelope.decay == 0 && pitch.sweep_to != pitch.hz)
        table.report("sweep_to", "a part that lasts as long as the loop cannot sweep; use 'vibrato'");
    return pitch;
}

std::vector<Partial> read_partials(const ConfigTable& table) {
    const auto ratios = table.numbers("ratios", {0.05, 100}, max_partials, {1});
    const auto ones = std::vector<double>(ratios.size(), 1.0);
    const auto levels = table.numbers("levels", {-4, 4}, max_partials, ones);
    const auto decays = table.numbers("decays", {0.01, 1}, max_partials, ones);
    std::vector<Partial> partials;
    if (ratios.size() != levels.size() || ratios.size() != decays.size()) {
        table.report("ratios", "'ratios', 'levels' and 'decays' must have equally many numbers");
        return partials;
    }
    for (std::size_t i = 0; i < ratios.size(); ++i) partials.push_back({ratios[i], levels[i], decays[i]});
    return partials;
}

/// Reports a fault if a partial (a sine wave of a tone) lies above the range of hearing.
void check_highest(const ConfigTable& table, double hz, const std::vector<Partial>& partials) {
    for (const auto& partial : partials) {
        if (hz * partial.ratio <= hz_range.high) continue;
        table.report("ratios",
                     text("a partial of ", hz * partial.ratio, " Hz is above ", hz_range.high, " Hz"));
        return;
    }
}

Tone read_tone(const ConfigTable& table, const Whole& whole) {
    Tone tone;
    tone.envelope = read_envelope(table, whole);
    tone.pitch = read_pitch(table, tone.envelope, whole);
    tone.partials = read_partials(table);
    check_highest(table, std::max(tone.pitch.hz, tone.pitch.sweep_to), tone.partials);
    return tone;
}

Noise read_noise(const ConfigTable& table, const Whole& whole) {
    Noise noise;
    noise.envelope = read_envelope(table, whole);
    noise.pitch = read_pitch(table, noise.envelope, whole);
    noise.filter = static_cast<NoiseFilter>(table.choice("filter", {"low", "band", "high"}));
    noise.sharpness = table.number("sharpness", {0.3, 60}, 0.7);
    return noise;
}

Grains read_grains(const ConfigTable& table, const Whole& whole) {
    Grains grains;
    grains.envelope = read_envelope(table, whole);
    grains.rate = table.number("rate", {0.5, 2000});
    grains.rate_to = table.number("rate_to", {0.5, 2000}, grains.rate);
    grains.even = table.number("even", {0, 1}, 0);
    grains.low_hz = table.number("low_hz", hz_range);
    grains.high_hz = table.number("high_hz", {grains.low_hz, hz_range.high}, grains.low_hz);
    grains.ring = table.number("ring", {0.0005, 2});
    grains.glide = table.number("glide", {-36, 36}, 0);
    grains.spread = table.number("spread", {0, 1}, 0.5);
    if (std::max(grains.rate, grains.rate_to) * whole.seconds > max_grains)
        table.report("rate", text("the part would have more than ", max_grains, " grains"));
    return grains;
}

Score read_score(const ConfigTable& table, const Whole& whole) {
    Score score;
    score.envelope = read_envelope(table, whole);
    if (score.envelope.decay == 0) table.report("", "a score needs 'decay': how long a note rings on");
    if (score.envelope.hold != 0)
        table.report("hold", "a note holds for its 'beats', so a score has no 'hold'");
    score.partials = read_partials(table);
    score.vibrato_hz = table.number("vibrato_hz", {0.05, 400}, 0);
    score.vibrato = table.number("vibrato", {0, 36}, 0);
    score.beats_per_minute = table.number("beats_per_minute", {20, 400});
    const double last_beat = whole.seconds * score.beats_per_minute / 60;
    const auto notes = table.tables("notes");
    if (notes.empty() || notes.size() > max_notes)
        table.report("notes", text("a score has 1 to ", max_notes, " notes"));
    for (std::size_t i = 0; i < std::min(notes.size(), max_notes); ++i) {
        Note note;
        note.beat = notes[i].number("beat", {0, last_beat});
        note.beats = notes[i].number("beats", {0.01, last_beat});
        note.key = notes[i].number("key", {16, 120});
        note.level = notes[i].number("level", {0, 4}, 1);
        score.notes.push_back(note);
        check_highest(notes[i], hz_of_key(note.key), score.partials);
    }
    return score;
}

Part read_part(const ConfigTable& table, const Whole& whole) {
    switch (table.choice("kind", {"tone", "noise", "grains", "score"})) {
        case 0: return read_tone(table, whole);
        case 1: return read_noise(table, whole);
        case 2: return read_grains(table, whole);
        default: return read_score(table, whole);
    }
}

void read_whole(const ConfigTable& root, Recipe& recipe) {
    recipe.description = root.string("description");
    if (recipe.description.empty() || recipe.description.size() > 100)
        root.report("description", "the description must have 1 to 100 letters");
    recipe.caption = root.string("caption", "");
    if (recipe.caption.size() > 32) root.report("caption", "the caption must have at most 32 letters");
    recipe.important = root.boolean("important", false);
    recipe.group = static_cast<SoundGroup>(root.choice("group", {"effects", "music", "interface"}));
    recipe.loops = root.boolean("loops", false);
    recipe.near_m = root.number("near_m", {0.1, 100}, 1.5);
    recipe.reach_m = root.number("reach_m", {recipe.near_m, 1000}, 40);
    recipe.seconds = root.number("seconds", {0.05, recipe.loops ? longest_s : longest_one_shot_s});
    recipe.level = root.number("level", {0.01, 0.9});
    recipe.drive = root.number("drive", {0, 20}, 0);
    recipe.echo_s = root.number("echo_s", {0.01, recipe.seconds}, 0);
    recipe.echo = root.number("echo", {0, 0.8}, 0);
    recipe.seed = static_cast<std::uint64_t>(root.integer("seed", {0, 1e9}, 1));
}

/// Number of samples that a part with this envelope writes for each sine wave.
double samples_of(const Envelope& envelope, double decay, const Recipe& recipe) {
    const double whole = recipe.seconds * sample_rate;
    if (decay == 0) return whole;
    const double own = length_of(envelope, decay) * sample_rate;
    return recipe.loops ? own : std::min(own, whole);
}

double work_of_part(const Tone& tone, const Recipe& recipe) {
    return static_cast<double>(tone.partials.size()) * samples_of(tone.envelope, tone.envelope.decay, recipe);
}

double work_of_part(const Noise& noise, const Recipe& recipe) {
    return 4 * samples_of(noise.envelope, noise.envelope.decay, recipe);
}

double work_of_part(const Grains& grains, const Recipe& recipe) {
    const double lasts = samples_of(grains.envelope, grains.envelope.decay, recipe) / sample_rate;
    return std::max(grains.rate, grains.rate_to) * lasts * grains.ring * (4.0 / 3) * sample_rate;
}

double work_of_part(const Score& score, const Recipe& recipe) {
    double work = 0;
    for (const auto& note : score.notes) {
        Envelope envelope = score.envelope;
        envelope.hold = note.beats * 60 / score.beats_per_minute;
        work += static_cast<double>(score.partials.size()) * samples_of(envelope, envelope.decay, recipe);
    }
    return work;
}

}  // namespace

double work_of(const Recipe& recipe) {
    double work = 0;
    for (const auto& part : recipe.parts)
        work += std::visit([&](const auto& kind) { return work_of_part(kind, recipe); }, part);
    return work;
}

Expected<Recipe> read_recipe(std::string_view toml, std::string name) {
    const auto config = Config::parse(toml, text(name, ".toml"), recipe_version);
    if (!config) return config.error();
    const auto root = config->root();
    Recipe recipe;
    recipe.name = std::move(name);
    read_whole(root, recipe);
    const auto parts = root.tables("parts");
    if (parts.empty() || parts.size() > max_parts)
        root.report("parts", text("a sound has 1 to ", max_parts, " parts"));
    for (std::size_t i = 0; i < std::min(parts.size(), max_parts); ++i)
        recipe.parts.push_back(read_part(parts[i], {recipe.seconds, recipe.loops}));
    if (work_of(recipe) > max_work) config->report("the sound takes too long to make; shorten its decays");
    if (const auto checked = config->check(); !checked) return checked.error();
    return recipe;
}

}  // namespace thaum::audio
