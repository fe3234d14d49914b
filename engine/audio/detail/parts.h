// audio/detail/parts.h: adds the parts of a recipe (the description of a sound in a data file) to the samples
// of the sound.
#pragma once
#include "audio/detail/oscillator.h"
#include "core/random.h"

namespace thaum::audio {

void add_tone(Canvas& canvas, const Tone& tone);
void add_noise(Canvas& canvas, const Noise& noise, Random random);
void add_grains(Canvas& canvas, const Grains& grains, Random random);
void add_score(Canvas& canvas, const Score& score);

}  // namespace thaum::audio
