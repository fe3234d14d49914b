// fluid/resample.h: a flow taken over to another grid: more or fewer cells, the other solver, other solids.
#pragma once
#include "fluid/fluid.h"

namespace thaum::fluid {

/// `to` takes velocity and substances from `from`, whose box is the same, in m; sheets and pushes are none of its business. Velocity is
/// read by the Catmull-Rom kernel and is free of divergence after the next step; densities linearly, so that none falls below
/// zero, and scaled so that the amount of each substance stays. What has nowhere to be, since all its places are solid now, is
/// spread evenly. Where cells are larger, a value is the mean over places in the cell. Substances beyond those of `to` are lost.
void resample_into(Fluid& to, const Fluid& from);

}  // namespace thaum::fluid
