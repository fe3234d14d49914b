#include "core/clock.h"

#include <cerrno>
#include <ctime>

namespace thaum {
namespace {

constexpr std::int64_t second = 1'000'000'000;

}  // namespace

std::int64_t monotonic_ns() {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * second + t.tv_nsec;
}

void sleep_until_ns(std::int64_t when) {
    const timespec t{when / second, when % second};
    while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {}
}

}  // namespace thaum
