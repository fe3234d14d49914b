// core/exp8.h: the exponential of eight numbers at once.
#pragma once
#include <array>

namespace thaum::det {

/// exp(x) (core/maths.h) for each of eight numbers, to the same bits. Eight numbers between -700 and 700 take
/// about as long as one, because the divisions of one do not wait for those of another.
std::array<double, 8> exp8(const std::array<double, 8>& x);

}  // namespace thaum::det
