#include "audio/channels.h"

#include <algorithm>
#include <cmath>

#include "audio/detail/oscillator.h"

namespace thaum::audio {

void ChannelTones::set(std::size_t channel, const ChannelTone& tone) {
    auto& wave = waves_.at(channel);
    // A comparison with NaN is false: the wave then fades out if the amplitude is NaN, or keeps its
    // frequency.
    wave.wanted = tone.amplitude > 0 ? std::min(tone.amplitude, 1.0) : 0;
    if (tone.hz > 0) wave.hz = std::clamp(tone.hz, lowest_hz, highest_hz);
}

void ChannelTones::silence() {
    for (auto& wave : waves_) wave.wanted = 0;
}

bool ChannelTones::is_silent() const {
    return std::all_of(waves_.begin(), waves_.end(),
                       [](const Wave& wave) { return wave.amplitude == 0 && wave.wanted == 0; });
}

void ChannelTones::mix(std::span<float> block) {
    std::fill(block.begin(), block.end(), 0.0F);
    for (std::size_t channel = 0; channel < channels_; ++channel) {
        auto& wave = waves_[channel];
        if (wave.amplitude == 0 && wave.wanted == 0) continue;
        const double rise = (wave.wanted - wave.amplitude) / frame_samples;
        const double step = wave.hz / sample_rate;
        for (std::size_t i = 0; i < frame_samples; ++i) {
            const double amplitude = wave.amplitude + rise * static_cast<double>(i + 1);
            wave.phase += step;
            block[i * channels_ + channel] =
                static_cast<float>(amplitude * sine_of_cycles(wave.phase - std::floor(wave.phase)));
        }
        wave.phase -= std::floor(wave.phase);
        wave.amplitude = wave.wanted;
    }
}

}  // namespace thaum::audio
