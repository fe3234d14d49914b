// tests/scenes/worse.h: the larger of two measured values, or NaN if one is NaN. std::max drops a NaN, so a
// failed run would report its last valid value.
#pragma once
#include <cmath>

namespace thaum::bench {

inline double worse(double worst, double figure) {
    return std::isnan(worst) || figure <= worst ? worst : figure;
}

}  // namespace thaum::bench
