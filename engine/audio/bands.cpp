#include "audio/bands.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/maths.h"

namespace thaum::audio {
namespace {

/// Only every eighth sample, 6,000 a second, goes through the filters. This is enough, because the bands end
/// at 1.2 kHz.
constexpr std::size_t thinning = 8;
constexpr double thin_rate = static_cast<double>(sample_rate) / thinning;
constexpr std::size_t thin_per_block = frame_samples / thinning;
/// Number of blocks of 8 ms after the end of a sound in which the filters of the bands still ring.
constexpr std::size_t tail_blocks = 12;

/// A second-order filter: a state variable filter by the trapezoidal rule, which stays exact at low
/// frequencies.
class Section {
public:
    Section(double hz, double quality, bool high)
        : g_(det::tan(pi * hz / thin_rate)),
          damping_(1 / quality),
          scale_(1 / (1 + g_ * (g_ + damping_))),
          high_(high) {}

    double next(double in) {
        const double high = (in - (g_ + damping_) * band_ - low_) * scale_;
        const double band = g_ * high + band_, low = g_ * band + low_;
        band_ = g_ * high + band;
        low_ = g_ * band + low;
        return high_ ? high : low;
    }

private:
    double g_, damping_, scale_;
    bool high_;
    double band_{}, low_{};
};

/// Follows the power of one band of frequencies, smoothed over time.
class BandPower {
public:
    explicit BandPower(const Band& band)
        : sections_{Section(band.low_hz, q_1, true), Section(band.low_hz, q_2, true),
                    Section(band.high_hz, q_1, false), Section(band.high_hz, q_2, false)},
          share_(std::min(1.0, 3 * band.low_hz / thin_rate)) {}

    void take(double sample) {
        for (auto& section : sections_) sample = section.next(sample);
        power_ += share_ * (sample * sample - power_);
    }
    double power() const { return power_; }

private:
    // Quality factors of the two second-order filters that make a Butterworth filter of the fourth order.
    static constexpr double q_1 = 0.541196100146197, q_2 = 1.306562964876377;
    std::array<Section, 4> sections_;
    double share_;
    double power_{};
};

/// Every eighth sample of a sound. Before that, a filter damps tones above 5 kHz, which would otherwise be
/// aliased to low tones.
std::vector<double> thinned(const Sound& sound) {
    const auto size = sound.samples.size();
    const auto sample_at = [&](std::size_t i) {
        if (i >= size && !sound.loops) return 0.0;
        return static_cast<double>(sound.samples[i % size]);
    };
    std::vector<double> out((size + thinning - 1) / thinning);
    for (std::size_t i = 0; i < out.size(); ++i) {
        double sum = 0;  // sum of samples by the weights of the filter, which rise and fall like a triangle
        for (std::size_t k = 0; k < 2 * thinning - 1; ++k)
            sum += static_cast<double>(std::min(k + 1, 2 * thinning - 1 - k)) * sample_at(i * thinning + k);
        out[i] = sum / (thinning * thinning);
    }
    return out;
}

/// Writes the level of one band in each block: the amplitude of a sine with the mean power of the block.
void follow_band(const std::vector<double>& samples, const Band& band, std::size_t number, BandCourse& out) {
    BandPower power(band);
    // A loop sounds as if it had always been playing, so its filters begin in the state that they have at its
    // end. For this at least 2 s (12,000 thinned samples) are filtered beforehand, longer than any filter
    // rings.
    constexpr std::size_t min_before = 12'000;
    for (std::size_t i = 0, before = samples.size(); out.loops && i < std::max(before, min_before); ++i)
        power.take(samples[i % before]);
    for (std::size_t block = 0; block < out.levels.size(); ++block) {
        double sum = 0;
        for (std::size_t i = block * thin_per_block; i < (block + 1) * thin_per_block; ++i) {
            const bool inside = i < samples.size();
            power.take(inside ? samples[i] : out.loops ? samples[i % samples.size()] : 0);
            sum += power.power();
        }
        out.levels[block].at(number) = static_cast<float>(std::sqrt(2 * std::max(0.0, sum) / thin_per_block));
    }
}

}  // namespace

BandLevels BandCourse::at(double sample) const {
    if (levels.empty() || has_ended(sample)) return {};
    const double within = loops ? sample - samples * std::floor(sample / samples) : sample;
    return levels[std::min(static_cast<std::size_t>(within / frame_samples), levels.size() - 1)];
}

bool BandCourse::has_ended(double sample) const {
    return !(sample >= 0) || (!loops && sample >= static_cast<double>(levels.size() * frame_samples));
}

BandCourse band_course(const Sound& sound, std::span<const Band> bands) {
    THAUM_ASSERT(bands.size() <= max_bands, "there are too many bands");
    BandCourse out{.samples = static_cast<double>(sound.samples.size()),
                   .loops = sound.loops,
                   .group = sound.group,
                   .near_m = sound.near_m,
                   .reach_m = sound.reach_m};
    if (sound.samples.empty()) return out;
    const auto samples = thinned(sound);
    out.levels.resize((sound.samples.size() + frame_samples - 1) / frame_samples +
                      (sound.loops ? 0 : tail_blocks));
    for (std::size_t i = 0; i < bands.size(); ++i) follow_band(samples, bands[i], i, out);
    return out;
}

std::vector<BandCourse> band_courses(const SoundBank& bank, std::span<const Band> bands) {
    std::vector<BandCourse> courses;
    for (const auto& sound : bank.sounds) courses.push_back(band_course(sound, bands));
    return courses;
}

}  // namespace thaum::audio
