// tools/bench/worse.h: keeps the larger of two figures, and a NaN for good. std::max drops a NaN, so a run that computed
// nonsense would report the last sound figure before it.
#pragma once
#include <cmath>

namespace thaum::bench {

inline double worse(double worst, double figure) {
    return std::isnan(worst) || figure <= worst ? worst : figure;
}

}  // namespace thaum::bench
