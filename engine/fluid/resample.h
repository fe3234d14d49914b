// fluid/resample.h: transfers a flow to another grid, with other cells, solver or solids.
#pragma once
#include "fluid/fluid.h"

namespace thaum::fluid {

/// Copies velocity and substances of `from` to `to`, whose box must have the same size. Spring surfaces
/// and queued pushes are not transferred.
///
/// Velocity is interpolated by the Catmull-Rom kernel; the next step makes it free of divergence. Densities
/// are interpolated linearly, so none falls below zero, then scaled to conserve the amount of each substance.
/// If a substance lies only where `to` is solid, its amount is spread evenly. Where the cells of `to` are
/// larger, each value is the mean over several places in the cell. Substances that `to` does not have are
/// lost.
void resample_into(Fluid& to, const Fluid& from);

}  // namespace thaum::fluid
