// core/clock.h: the monotonic clock of this machine, for pacing and measuring. Code that decides a match must
// not read the clock.
#pragma once
#include <cstdint>

namespace thaum {

/// Time since a fixed but unspecified moment, without times in which the machine was suspended (ns).
std::int64_t monotonic_ns();
/// Processor time used by the calling thread (ns).
std::int64_t thread_cpu_ns();
/// Sleeps until `monotonic_ns()` reaches `when` (ns), even if signals arrive. Returns at once if `when` has
/// passed.
void sleep_until_ns(std::int64_t when);

}  // namespace thaum
