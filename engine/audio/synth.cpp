#include "audio/synth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "audio/detail/parts.h"
#include "core/file.h"
#include "core/maths.h"
#include "core/text.h"

namespace thaum::audio {
namespace {

constexpr std::size_t max_recipe = 64 << 10, max_sounds = 256;
/// Limit on the summed length of all sounds of a folder (s).
constexpr double max_seconds = 120;
constexpr double fade_in_s = 0.0005, fade_out_s = 0.02;  // durations of the fades of a sound without a loop
constexpr double lowest_hz = 15;  // lower frequencies are inaudible and only shift the samples

void add_part(Canvas& canvas, const Part& part, Random random) {
    if (const auto* tone = std::get_if<Tone>(&part)) return add_tone(canvas, *tone);
    if (const auto* noise = std::get_if<Noise>(&part)) return add_noise(canvas, *noise, random);
    if (const auto* grains = std::get_if<Grains>(&part)) return add_grains(canvas, *grains, random);
    add_score(canvas, std::get<Score>(part));
}

double max_of(const std::vector<double>& samples) {
    double peak = 0;
    for (const double sample : samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

/// Compresses loud moments: x becomes x / (1 + drive |x|), where x is a sample divided by the peak.
void compress(Canvas& canvas, double drive) {
    if (drive == 0) return;
    const double peak = std::max(max_of(canvas.samples()), 1e-12);
    for (double& sample : canvas.samples()) sample = sample / (peak + drive * std::abs(sample));
}

/// Adds echoes until they are below -60 dB.
void add_echoes(Canvas& canvas, double delay_s, double share) {
    if (delay_s == 0 || share <= 0) return;
    const auto dry = canvas.samples();
    const auto delay = static_cast<std::size_t>(delay_s * sample_rate);
    double level = share;
    for (std::size_t n = 1; level > 1e-3; ++n, level *= share) {
        if (!canvas.loops() && n * delay >= dry.size()) return;
        for (std::size_t i = 0; i < dry.size(); ++i) canvas.add(i + n * delay, dry[i] * level);
    }
}

/// Removes frequencies below the range of hearing. A loop is filtered twice, so that in the second run the
/// filter starts in the state that it has at the end of the loop.
void remove_offset(Canvas& canvas) {
    const double share = 1 - 2 * pi * lowest_hz / sample_rate;
    const auto dry = canvas.samples();
    double in = 0, out = 0;
    for (int run = canvas.loops() ? 0 : 1; run < 2; ++run) {
        for (std::size_t i = 0; i < dry.size(); ++i) {
            out = share * (out + dry[i] - in);
            in = dry[i];
            canvas.samples()[i] = out;
        }
    }
}

/// Fades a sound in and out, so that it begins and ends with silence.
void fade(Canvas& canvas) {
    if (canvas.loops()) return;
    auto& samples = canvas.samples();
    const auto gain = [](double share) { return share * share * (3 - 2 * share); };
    const auto rise = static_cast<std::size_t>(fade_in_s * sample_rate);
    const auto fall = static_cast<std::size_t>(fade_out_s * sample_rate);
    for (std::size_t i = 0; i < rise; ++i)
        samples[i] *= gain(static_cast<double>(i) / static_cast<double>(rise));
    for (std::size_t i = 0; i < fall; ++i)
        samples[samples.size() - 1 - i] *= gain(static_cast<double>(i) / static_cast<double>(fall));
}

Expected<std::vector<std::filesystem::path>> recipes_in(const std::filesystem::path& folder) {
    auto files = files_in(folder, ".toml");
    if (!files) return files;
    if (files->empty()) return fail(text(folder.string(), ": the folder holds no sounds (NAME.toml)"));
    if (files->size() > max_sounds)
        return fail(text(folder.string(), ": the folder holds more than ", max_sounds, " sounds"));
    std::sort(files->begin(), files->end(),
              [](const auto& a, const auto& b) { return a.stem().string() < b.stem().string(); });
    return files;
}

}  // namespace

namespace {

/// Makes a sound with the name, texts and other properties of its recipe, but without samples.
Sound head_of(const Recipe& recipe) {
    return {.name = recipe.name,
            .description = recipe.description,
            .caption = recipe.caption,
            .important = recipe.important,
            .group = recipe.group,
            .loops = recipe.loops,
            .near_m = recipe.near_m,
            .reach_m = recipe.reach_m,
            .samples = {}};
}

Expected<Recipe> load_recipe(const std::filesystem::path& file) {
    const auto toml = read_text_file(file, max_recipe);
    if (!toml) return toml.error();
    auto recipe = read_recipe(*toml, file.stem().string());
    if (recipe) return recipe;
    // The recipe's reader knows the name of the file but not its folder, which is therefore added to each
    // line.
    std::optional<Error> error;
    for (const auto& line : lines_of(recipe.error()))
        add_faults(error, Error{text(file.parent_path().string(), "/", line)});
    return *error;
}

}  // namespace

Sound make_sound(const Recipe& recipe) {
    Canvas canvas(recipe.seconds, recipe.loops);
    for (std::size_t i = 0; i < recipe.parts.size(); ++i)
        add_part(canvas, recipe.parts[i], random_stream(recipe.seed, i));
    compress(canvas, recipe.drive);
    add_echoes(canvas, recipe.echo_s, recipe.echo);
    remove_offset(canvas);
    fade(canvas);
    const double peak = max_of(canvas.samples());
    const double scale = peak > 1e-9 ? recipe.level / peak : 0;
    auto sound = head_of(recipe);
    sound.samples.reserve(canvas.size());
    for (const double sample : canvas.samples()) sound.samples.push_back(static_cast<float>(sample * scale));
    return sound;
}

Expected<SoundBank> load_sounds(const std::filesystem::path& folder, WithSamples samples) {
    const auto files = recipes_in(folder);
    if (!files) return files.error();
    SoundBank bank;
    double seconds = 0;
    for (const auto& file : *files) {
        const auto recipe = load_recipe(file);
        if (!recipe) {
            bank.faulty.push_back({file.stem().string(), recipe.error()});
            continue;
        }
        seconds += recipe->seconds;
        if (seconds > max_seconds)
            return fail(text(folder.string(), ": all sounds together are longer than ", max_seconds, " s"));
        bank.sounds.push_back(samples == WithSamples::yes ? make_sound(*recipe) : head_of(*recipe));
    }
    return bank;
}

}  // namespace thaum::audio
