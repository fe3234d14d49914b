// fluid/detail/ceiling.h: the limit that keeps transport from creating densities above those that exist.
//
// While substances are transported, no cell may rise above the cell of the highest density; otherwise the
// density overshoots at sharp edges. A smooth hill is the exception. Its top may lie between cells, and a
// limit at the highest cell would cut it off in each sub-step. Where the cells around the highest one bend
// evenly, the limit is therefore the top of a parabola through them.
#pragma once
#include <array>

#include "fluid/rows.h"

namespace thaum::fluid {

/// Highest value that any cell may reach while `density` is transported. Densities must be finite and >= 0,
/// with filled ghost cells. `aperture` holds the shares of the faces that no solid covers; null means all are
/// open.
float density_ceiling(const Rows& rows, const std::array<Samples, 3>* aperture, const Samples& density);

}  // namespace thaum::fluid
