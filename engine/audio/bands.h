// audio/bands.h: how strong a sound is in a few bands of frequencies, every 8 ms. Used to feel a sound
// instead of hearing it: motors on the body are too slow to follow the samples, but can follow these levels.
//
// Each band is cut out by Butterworth filters of the fourth order, so its ends are 3 dB down, and an octave
// beyond them 24 dB. The power is smoothed over a third of the longest period of the band and given as the
// amplitude of a sine of that power. The levels over the whole sound are called its course. The course of a
// looping sound has no seam. Equal sounds give equal courses, bit for bit.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "audio/frame.h"
#include "audio/sound.h"

namespace thaum::audio {

inline constexpr std::size_t max_bands = 4;

/// A range of frequencies.
struct Band {
    double low_hz{};   ///< lower end of the band, at least 10 (Hz)
    double high_hz{};  ///< upper end of the band, at most 1200 (Hz)
};

/// Amplitude of each band of frequencies (0 to about 1). Entries beyond the number of bands have 0.
using BandLevels = std::array<float, max_bands>;

/// Levels of the bands of one sound over time.
struct BandCourse {
    /// One entry for each block of frame_samples samples (8 ms), and some more for the time in which the
    /// filters ring after the end of the sound.
    std::vector<BandLevels> levels{};
    double samples{};  ///< length of the sound (samples)
    bool loops{};
    SoundGroup group{};
    /// Distances at which the sound begins to fade and at which it is silent, as in Sound (m).
    double near_m{}, reach_m{};

    /// Levels at a time since the start (samples, >= 0); a sound that has ended has zeros.
    BandLevels at(double sample) const;
    /// Whether the sound and the ringing of its filters are over at a time since the start (samples). Also
    /// true before the start; never true afterwards for a looping sound.
    bool has_ended(double sample) const;
};

/// Levels over time of all sounds of a bank; the index is the number of the sound.
std::vector<BandCourse> band_courses(const SoundBank& bank, std::span<const Band> bands);

/// Levels over time of one sound; `bands` has at most max_bands entries.
BandCourse band_course(const Sound& sound, std::span<const Band> bands);

}  // namespace thaum::audio
