// audio/synth.h: makes sounds from recipes. Equal recipes give equal
// samples, bit for bit, on every processor.
#pragma once
#include <filesystem>

#include "audio/recipe.h"
#include "audio/sound.h"

namespace thaum::audio {

/// Makes the sound of a recipe that `read_recipe` has accepted.
Sound make_sound(const Recipe& recipe);

/// Whether sounds get their samples. Without samples, loading takes almost no time and gives captions,
/// descriptions and distances.
enum class WithSamples : std::uint8_t { no, yes };

/// Makes the sounds of all recipes NAME.toml of a folder. Of a faulty recipe only its own sound is left out.
/// The error says that the folder cannot be read, holds no sounds, or too many.
Expected<SoundBank> load_sounds(const std::filesystem::path& folder, WithSamples samples = WithSamples::yes);

}  // namespace thaum::audio
