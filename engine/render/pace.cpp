#include "render/pace.h"

#include "core/assert.h"
#include "core/clock.h"

namespace thaum::render {
namespace {

constexpr std::int64_t second = 1'000'000'000;

}  // namespace

std::int64_t next_deadline(std::int64_t previous, std::int64_t now, std::int64_t period) {
    const std::int64_t due = previous + period;
    return now > due + period ? now : due;
}

Pacer::Pacer(double frames_per_second) {
    THAUM_ASSERT(frames_per_second >= 0, "a rate cannot be negative");
    if (frames_per_second > 0)
        period_ = static_cast<std::int64_t>(static_cast<double>(second) / frames_per_second);
}

double Pacer::wait() {
    const bool first = last_ == 0;
    if (period_ > 0) {
        const auto now = monotonic_ns();
        deadline_ = first ? now : next_deadline(deadline_, now, period_);
        if (deadline_ > now) sleep_until_ns(deadline_);
    }
    const auto before = last_;
    last_ = monotonic_ns();
    return first ? 0 : static_cast<double>(last_ - before) / static_cast<double>(second);
}

}  // namespace thaum::render
