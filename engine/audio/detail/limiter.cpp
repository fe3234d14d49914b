#include "audio/detail/limiter.h"

#include <algorithm>
#include <cmath>

namespace thaum::audio::detail {
namespace {

constexpr double ceiling = 0.999;
/// Rise of the gain after a peak: from 0 to 1 in 0.25 s.
constexpr double rise_per_sample = 1.0 / (0.25 * 48'000);

}  // namespace

double Limiter::lowest_needed() const { return *std::min_element(needed_.begin(), needed_.end()); }

bool Limiter::process(std::span<float> stereo) {
    bool limited = false;
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
        float& left = stereo[i];
        float& right = stereo[i + 1];
        if (!std::isfinite(left)) left = 0;
        if (!std::isfinite(right)) right = 0;
        const double peak = std::max(std::abs(left), std::abs(right));
        const double needs = peak > ceiling ? ceiling / peak : 1;
        const double leaves = needed_[at_];
        needed_[at_] = needs;
        if (needs <= lowest_)
            lowest_ = needs;
        else if (leaves == lowest_)
            lowest_ = lowest_needed();
        const double before = held_[(at_ + window - 1) % window];
        const double held = std::min(lowest_, before + rise_per_sample);
        held_sum_ += held - held_[at_];
        held_[at_] = held;
        calm_ = held < 1 ? 0 : calm_ + 1;
        // Set exactly, because rounding of the running sum would change the samples of a quiet signal.
        if (calm_ >= window) held_sum_ = window;
        const double gain = held_sum_ / window;
        std::swap(delayed_[2 * at_], left);
        std::swap(delayed_[2 * at_ + 1], right);
        at_ = (at_ + 1) % window;
        // The oldest sample of the delay line is the one that the next call overwrites.
        left = delayed_[2 * at_];
        right = delayed_[2 * at_ + 1];
        if (gain >= 1) continue;
        limited = true;
        left = std::clamp(static_cast<float>(left * gain), -1.0F, 1.0F);
        right = std::clamp(static_cast<float>(right * gain), -1.0F, 1.0F);
    }
    return limited;
}

}  // namespace thaum::audio::detail
