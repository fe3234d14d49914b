// audio/detail/oscillator.h: the small parts of the sound generator, all with the same bits on every processor.
//
// Gains and frequencies are computed at the ends of blocks of samples. Within a block, a gain runs in a straight line
// and a frequency stays.
#pragma once
#include <vector>

#include "audio/recipe.h"

namespace thaum::audio {

/// Samples of one block of a gain or a frequency.
inline constexpr std::size_t control_samples = 16;

/// Frequency of a MIDI key (Hz).
double hz_of_key(double key);

/// Sine of 2 pi `cycles`, for 0 <= cycles <= 1, within 4e-7.
double sine_of_cycles(double cycles);

/// Gain of an envelope at `time`, with a decay of its own (s). A decay of 0 never falls.
double gain_at(const Envelope& envelope, double decay, double time);

/// Time after which an envelope's gain is below -80 dB (s).
double length_of(const Envelope& envelope, double decay);

/// Frequency at `time` after the start of the part (Hz).
double hz_at(const Pitch& pitch, double time);

/// The samples of a sound while its parts are added. In a looping sound, the sample after the last is the first.
class Canvas {
public:
    Canvas(double seconds, bool loops);

    std::size_t size() const { return samples_.size(); }
    bool loops() const { return loops_; }
    double seconds() const;
    std::vector<double>& samples() { return samples_; }

    /// Adds one sample at a position that may lie beyond the end.
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

/// Number of whole periods per loop, as a rate (Hz); the rate itself in a sound without a loop, and 0 for 0.
double fitted_rate(double hz, const Canvas& canvas);

}  // namespace thaum::audio
