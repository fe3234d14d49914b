// fluid/ceiling.h: the highest density that transport may make of the densities there are.
//
// Nothing may rise above the highest cell, or sharp bodies would overshoot. A smooth hill is the exception: its top may stand between
// cells, and a limit at the highest cell would cut it off again in each sub-step. So where the cells round the highest ones bend evenly,
// the limit is the top of the parabola through them.
#pragma once
#include <array>

#include "fluid/rows.h"

namespace thaum::fluid {

/// Highest value that any cell may come to while `density` is carried. Densities are finite and >= 0, with their ghosts.
/// `aperture` holds the open shares of faces; null where all are open.
float density_ceiling(const Rows& rows, const std::array<Samples, 3>* aperture, const Samples& density);

}  // namespace thaum::fluid
