// game/app/sound_picture.h: draws sounds: the waveform above, the spectrogram below.
#pragma once
#include <span>

#include "audio/sound.h"
#include "render/font.h"
#include "render/image.h"

namespace thaum::game::inline app {

/// Picture of one sound with its name, axes and description.
render::Image draw_sound(const audio::Sound& sound, render::Font& font);

/// Spectrograms and names of several sounds, side by side.
render::Image draw_sounds(std::span<const audio::Sound* const> sounds, render::Font& font);

}  // namespace thaum::game::inline app
