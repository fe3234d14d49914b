// audio/synth.h: makes sounds from recipes. Equal recipes give equal samples, bit for bit, on every processor.
#pragma once
#include <filesystem>

#include "audio/recipe.h"
#include "audio/sound.h"

namespace thaum::audio {

/// Makes the sound of a recipe that `read_recipe` has accepted.
Sound make_sound(const Recipe& recipe);

/// Makes the sounds of all recipes NAME.toml of a folder. The error names the file and its first fault.
Expected<SoundBank> load_sounds(const std::filesystem::path& folder);

}  // namespace thaum::audio
