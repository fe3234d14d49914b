#include "core/clock.h"

#include <cerrno>
#include <ctime>

namespace thaum {
namespace {

constexpr std::int64_t second = 1'000'000'000;

std::int64_t now_ns(clockid_t clock) {
    timespec t{};
    ::clock_gettime(clock, &t);
    return t.tv_sec * second + t.tv_nsec;
}

}  // namespace

std::int64_t monotonic_ns() { return now_ns(CLOCK_MONOTONIC); }

std::int64_t thread_cpu_ns() { return now_ns(CLOCK_THREAD_CPUTIME_ID); }

void sleep_until_ns(std::int64_t when) {
    const timespec t{when / second, when % second};
    while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {}
}

}  // namespace thaum
