// physics/probe.h: which mathematical library does this machine run?
#pragma once
#include <cstdint>

namespace thaum::physics {

/// Hash of sin, cos, atan2, acos, asin, pow, exp, log and tan as Bullet's compiled code calls them, over a fixed list of
/// arguments. glibc picks other variants by processor: a log recorded under another probe need not replay to the same bits.
std::uint64_t libm_probe();

}  // namespace thaum::physics
