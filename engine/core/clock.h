// core/clock.h: the monotonic clock of this machine, for pacing and measuring. Nothing that decides a match may ask it.
#pragma once
#include <cstdint>

namespace thaum {

/// ns, since some moment that stays the same while the machine runs.
std::int64_t monotonic_ns();
/// Until that moment of the same clock, whatever signals come; at once where it is past.
void sleep_until_ns(std::int64_t when);

}  // namespace thaum
