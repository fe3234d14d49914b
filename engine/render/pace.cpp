#include "render/pace.h"

#include <cerrno>
#include <ctime>

#include "core/assert.h"

namespace thaum::render {
namespace {

constexpr std::int64_t second = 1'000'000'000;

std::int64_t monotonic_now() {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * second + t.tv_nsec;
}

void sleep_until(std::int64_t deadline) {
    const timespec t{deadline / second, deadline % second};
    while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {}
}

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
        const auto now = monotonic_now();
        deadline_ = first ? now : next_deadline(deadline_, now, period_);
        if (deadline_ > now) sleep_until(deadline_);
    }
    const auto before = last_;
    last_ = monotonic_now();
    return first ? 0 : static_cast<double>(last_ - before) / static_cast<double>(second);
}

}  // namespace thaum::render
