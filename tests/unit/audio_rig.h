// A small bank of sines and noise, and measurements of what a mixer plays.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <utility>
#include <vector>

#include "audio/mixer.h"

namespace thaum::audio::rig {

inline constexpr std::size_t second = sample_rate / frame_samples;  // blocks in a second

enum SoundNumber : std::uint32_t { bell, hiss, hum, loud, song, verse, wood, sound_count };

inline std::vector<float> sine(double frequency, double seconds_long, double size) {
    std::vector<float> samples(static_cast<std::size_t>(seconds_long * sample_rate));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] =
            static_cast<float>(size * std::sin(2 * pi * frequency * static_cast<double>(i) / sample_rate));
    return samples;
}

/// Fades a sound in and out over 10 ms.
inline std::vector<float> with_ends(std::vector<float> samples) {
    constexpr std::size_t ramp = 480;
    for (std::size_t i = 0; i < ramp; ++i) {
        const auto share = static_cast<float>(i) / ramp;
        samples[i] *= share;
        samples[samples.size() - 1 - i] *= share;
    }
    return samples;
}

inline std::vector<float> noise(std::size_t count) {
    std::vector<float> samples(count);
    std::uint32_t state = 1;
    for (auto& sample : samples) {
        state = state * 1664525U + 1013904223U;
        sample = static_cast<float>(static_cast<double>(state >> 8U) / (1U << 23U) - 1) * 0.5F;
    }
    return samples;
}

inline SoundBank bank() {
    SoundBank made;
    const auto add = [&](const char* name, SoundGroup group, bool loops, std::vector<float> samples) {
        made.sounds.push_back({.name = name,
                               .description = name,
                               .group = group,
                               .loops = loops,
                               .near_m = 2,
                               .reach_m = 40,
                               .samples = std::move(samples)});
    };
    add("bell", SoundGroup::effects, false, with_ends(sine(200, 0.2, 0.5)));
    add("hiss", SoundGroup::effects, true, noise(sample_rate));
    add("hum", SoundGroup::effects, true, sine(200, 1, 0.5));
    add("loud", SoundGroup::effects, true, sine(200, 1, 1));
    add("song", SoundGroup::music, true, sine(100, 2, 0.4));
    add("verse", SoundGroup::music, true, sine(100, 2, 0.4));
    add("wood", SoundGroup::interface, false, with_ends(sine(300, 0.1, 0.5)));
    return made;
}

inline Mixer mixer(const MixSettings& settings = {}) {
    auto made = Mixer::create(bank(), settings);
    if (!made) {
        ADD_FAILURE() << made.error().message;
        std::abort();
    }
    return std::move(*made);
}

/// Level of each channel: root mean square times the square root of two, which is the amplitude of a sine.
struct Levels {
    double left{}, right{};
};

/// Collects all samples of some blocks.
class Recorder {
public:
    explicit Recorder(Mixer& mixer) : mixer_(mixer) {}

    void play(const AudioFrame& frame, std::size_t blocks = 1) {
        for (std::size_t i = 0; i < blocks; ++i) mixer_.play(frame, next());
    }
    void run_on(std::size_t blocks = 1) {
        for (std::size_t i = 0; i < blocks; ++i) mixer_.run_on(next());
    }
    void clear() { samples.clear(); }

    /// Levels of both channels over the last `blocks` blocks.
    Levels levels(std::size_t blocks) const {
        Levels sum;
        const auto last = std::min(samples.size(), blocks * block_values);
        for (std::size_t i = samples.size() - last; i < samples.size(); i += 2) {
            sum.left += samples[i] * samples[i];
            sum.right += samples[i + 1] * samples[i + 1];
        }
        const double count = static_cast<double>(last) / 2;
        return {std::sqrt(2 * sum.left / count), std::sqrt(2 * sum.right / count)};
    }
    double largest() const {
        float most = 0;
        for (const float s : samples) most = std::max(most, std::abs(s));
        return most;
    }
    /// Largest difference between neighbouring samples of one channel. A click shows as a large difference.
    double max_step() const {
        float most = 0;
        for (std::size_t i = 2; i < samples.size(); ++i)
            most = std::max(most, std::abs(samples[i] - samples[i - 2]));
        return most;
    }
    /// Energy of the left channel from `low` to `high` (Hz), by a Fourier transform of the last 4,096
    /// samples.
    double band(double low, double high) const {
        constexpr std::size_t size = 4096;
        double energy = 0;
        const auto* last = samples.data() + samples.size() - 2 * size;
        for (auto k = static_cast<std::size_t>(low * size / sample_rate);
             k < static_cast<std::size_t>(high * size / sample_rate); k += 8) {
            std::complex<double> sum;
            for (std::size_t i = 0; i < size; ++i) {
                const double window = 0.5 - 0.5 * std::cos(2 * pi * static_cast<double>(i) / size);
                sum += window * last[2 * i] *
                       std::polar(1.0, -2 * pi * static_cast<double>(k * i % size) / size);
            }
            energy += std::norm(sum);
        }
        return energy;
    }

    std::vector<float> samples;

private:
    std::span<float> next() {
        samples.resize(samples.size() + block_values);
        return std::span(samples).last(block_values);
    }

    Mixer& mixer_;
};

/// A voice at a place. The key identifies it if it is a lasting voice.
inline Voice voice(std::uint32_t sound, vec3 position, std::uint32_t key = 1) {
    return {.sound = sound, .key = key, .position = position};
}

inline Voice at_ear(std::uint32_t sound, std::uint32_t key = 1) {
    return {.sound = sound, .key = key, .at_ear = true};
}

inline AudioFrame frame_with(std::initializer_list<Voice> lasts, std::initializer_list<Voice> begins = {}) {
    AudioFrame frame;
    for (const auto& v : lasts) frame.lasts.add(v);
    for (const auto& v : begins) frame.begins.add(v);
    return frame;
}

/// Largest difference between neighbouring samples of a 200 Hz sine with this amplitude, with a margin for
/// changes of its gain.
inline double smooth_step(double size) { return 1.6 * size * 2 * pi * 200 / sample_rate; }

}  // namespace thaum::audio::rig
