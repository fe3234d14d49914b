// Fuzzes the reader of sound recipes. An accepted recipe must make a sound whose samples are all within
// range.
#include <cmath>

#include "audio/synth.h"
#include "core/file.h"
#include "core/text.h"
#include "fuzz/fuzz.h"

namespace thaum::fuzz {
namespace {

std::vector<std::string> shipped_sounds(const Places& places) {
    std::vector<std::string> seeds;
    for (const char* name : {"bolt_shot", "blast_burst", "boil", "stir", "spoilt", "boon"}) {
        if (auto toml = read_text_file(places.assets / text("sounds/", name, ".toml"), 1U << 20U))
            seeds.push_back(std::move(*toml));
    }
    return seeds;
}

Outcome read_sound(const std::string& input, const Places&) {
    const auto recipe = audio::read_recipe(input, "sound");
    if (!recipe) return {.refusal = recipe.error().message};
    const auto sound = audio::make_sound(*recipe);
    if (sound.samples.empty()) return {.fault = "a sound without samples"};
    for (const float sample : sound.samples) {
        if (!(std::abs(sample) <= 0.9001F)) return {.fault = text("a sample of ", sample)};
    }
    return {.accepted = true};
}

}  // namespace

const Reader sound_reader{"sound", shipped_sounds, mutate_text, read_sound};

}  // namespace thaum::fuzz
