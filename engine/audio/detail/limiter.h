// audio/detail/limiter.h: keeps a stereo signal within -1 to 1 without clipping its waves.
//
// The signal is delayed by 2 ms. For each sample the limiter finds the largest gain that keeps it within -1
// to 1. The least of these gains within the delay, averaged over the delay, is the gain of the output. So the
// gain is low enough when a peak comes out, and it has moved there evenly. After a peak it rises slowly. Both
// channels get the same gain, so that no voice moves to the other side.
#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace thaum::audio::detail {

class Limiter {
public:
    /// Delay of the output (samples).
    static constexpr std::size_t delay = 95;

    /// Replaces interleaved stereo samples by the limited, delayed ones. NaN becomes 0. Returns true if the
    /// gain of some sample was below 1.
    bool process(std::span<float> stereo);
    /// Drops the delayed samples and sets the gain back to 1.
    void clear() { *this = {}; }

private:
    static constexpr std::size_t window = delay + 1;

    double lowest_needed() const;

    std::array<float, 2 * window> delayed_{};
    /// Largest gain that keeps each delayed sample within -1 to 1.
    std::array<double, window> needed_ = filled();
    /// Gain before averaging: the least gain that any delayed sample needs. It rises slowly after a peak.
    std::array<double, window> held_ = filled();
    double held_sum_{window};
    double lowest_{1};
    std::size_t calm_{window};  ///< number of samples since a gain was last below 1
    std::size_t at_{};

    static constexpr std::array<double, window> filled() {
        std::array<double, window> ones{};
        ones.fill(1);
        return ones;
    }
};

}  // namespace thaum::audio::detail
