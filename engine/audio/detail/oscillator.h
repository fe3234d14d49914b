// audio/detail/oscillator.h: the small parts of the sound generator, all with
// the same bits on every processor.
//
// Gains and frequencies are computed at the ends of blocks of samples. Within a block, a gain changes
// linearly and a frequency is constant.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "audio/recipe.h"

namespace thaum::audio {

/// Samples between two computations of a gain or a frequency.
inline constexpr std::size_t control_samples = 16;

/// Frequency of a MIDI key (Hz).
double hz_of_key(double key);

inline constexpr std::size_t sine_table_size = 4096;

/// Sine at each of sine_table_size places of a period, and at the two places after it, which interpolation
/// needs.
using SineTable = std::array<double, sine_table_size + 2>;
const SineTable& sine_table();

/// Sine of 2 pi `cycles`, for 0 <= cycles <= 1, within 4e-7.
inline double sine_of_cycles(const SineTable& table, double cycles) {
    const double at = cycles * sine_table_size;
    const auto index = static_cast<std::int32_t>(at);
    const double* const place = table.data() + index;
    return place[0] + (place[1] - place[0]) * (at - static_cast<double>(index));
}
inline double sine_of_cycles(double cycles) { return sine_of_cycles(sine_table(), cycles); }

/// Gain of an envelope at `time` without its decay: after the rise it stays at its level.
double steady_gain_at(const Envelope& envelope, double time);

/// Factor by which a gain with this decay (s) falls within `time` (s). With a decay of 0 the gain never
/// falls.
double fall_within(double time, double decay);

/// Factor by which an envelope with this decay (s) has fallen at `time`; 1 until the decay begins.
double fall_at(const Envelope& envelope, double decay, double time);

/// Gain of an envelope at `time`, with `decay` (s) in place of the envelope's own decay.
inline double gain_at(const Envelope& envelope, double decay, double time) {
    return steady_gain_at(envelope, time) * fall_at(envelope, decay, time);
}

/// Time after which the gain of an envelope with this decay is below -80 dB (s).
double length_of(const Envelope& envelope, double decay);

/// Frequency of a pitch at `time` after the start of its part, a layer of a sound (Hz).
double hz_at(const Pitch& pitch, double time);

/// The samples of a sound while its parts are added. In a looping sound, the
/// sample after the last is the first.
class Canvas {
public:
    Canvas(double seconds, bool loops);

    std::size_t size() const { return samples_.size(); }
    bool loops() const { return loops_; }
    double seconds() const;
    std::vector<double>& samples() { return samples_; }

    /// Adds samples from index `at` on, which may lie beyond the end.
    void add(std::size_t at, std::span<const double> values) {
        if (at + values.size() <= samples_.size()) {
            for (std::size_t i = 0; i < values.size(); ++i) samples_[at + i] += values[i];
        } else {
            for (std::size_t i = 0; i < values.size(); ++i) add(at + i, values[i]);
        }
    }
    /// Adds one sample.
    void add(std::size_t at, double value) {
        if (at >= samples_.size()) {
            if (!loops_) return;
            at %= samples_.size();
        }
        samples_[at] += value;
    }

private:
    std::vector<double> samples_;
    bool loops_;
};

/// The frequency nearest to `hz` that has a whole number of periods in a loop (Hz). In a sound without a
/// loop, `hz` itself. 0 stays 0.
double fitted_rate(double hz, const Canvas& canvas);

}  // namespace thaum::audio
