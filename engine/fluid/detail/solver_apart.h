// fluid/detail/solver_apart.h: a solver in a library of its own. A program that
// does not link it has no such fluids.
#pragma once
#include <memory>

#include "fluid/fluid.h"

namespace thaum::fluid {

/// A solver with its scratch memory; holds no state.
class SolverApart {
public:
    virtual ~SolverApart() = default;
    virtual StepReport step(Fluid& fluid, double dt) = 0;
    virtual void carry_substances(Fluid& fluid, double dt) = 0;
    /// Writes the velocity's ghosts.
    virtual void fill(Fluid& fluid) = 0;
};

using MakeSolver = std::unique_ptr<SolverApart> (*)();

/// Registers the solver of `Solver::classic`; for a static object, so that it is done before main begins.
struct ClassicIs {
    explicit ClassicIs(MakeSolver make);
};

}  // namespace thaum::fluid
