// fluid/detail/solver_apart.h: interface of a fluid solver that stands in a library of its own. A program
// that does not link that library cannot make fluids with this solver.
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
    /// Writes the velocity's ghost cells, as this solver's rules for the sides require.
    virtual void fill(Fluid& fluid) = 0;
};

using MakeSolver = std::unique_ptr<SolverApart> (*)();

/// Registers how to make the solver of `Solver::classic`. The object is static, so that this is done before
/// main begins.
struct ClassicIs {
    explicit ClassicIs(MakeSolver make);
};

}  // namespace thaum::fluid
