// fluid/solids.h: walls of any shape on the staggered grid.
//
// Each face is open by a share of its area; a cell with open faces is fluid. The pressure makes what flows through the open parts
// of a cell's faces cancel (Batty, Bertails and Bridson 2007), which is solved by conjugate gradients. Their preconditioner is the
// direct solve of the whole box, as if nothing were solid: it is the energy of the smoothest continuation into the solid, which is
// at most a small multiple of that in the fluid, however fine the grid is; so the number of iterations does not grow with it.
// Cells that are mostly closed add a term of their own.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "fluid/cuts.h"
#include "fluid/rows.h"
#include "fluid/separable.h"

namespace thaum::fluid {

/// A face of which a part is open.
struct CutFace {
    std::size_t at{};  ///< place in the samples
    vec3 middle{};     ///< middle of the open part (m)
};

class Solids {
public:
    Solids(const Lattice& lattice, const SolidShare& solid);

    /// Shares of the faces of each component that are open, 0 to 1, ghosts included: 0 at walls.
    const std::array<Samples, 3>& open() const { return open_; }
    /// Faces of a component that are open in part, by their places in the samples.
    const std::vector<CutFace>& cut_faces(std::size_t axis) const { return cut_faces_[axis]; }
    /// Of a cell, counted as Lattice::at does.
    bool holds_fluid(std::size_t cell) const { return diagonal_[cell] > 0; }

    /// Of the cells that hold fluid, and so of all open faces.
    const Rows& rows() const { return rows_; }

    /// Velocities on closed faces become 0.
    void clear_closed_faces(std::array<Samples, 3>& velocity) const;

    struct ProjectionResult {
        int iterations{};
        double divergence{};  ///< 1/s, the largest that is left
    };
    /// Takes the divergence away, down to `share` of the largest component that is left by h; `potential`, ghosts included, becomes
    /// what was subtracted the gradient of. What it was, that of the last projection, is where the search begins: as far along it as
    /// leaves the least (Fischer 1998, with one direction), so that a bad guess does no harm. The velocity is 0 on closed faces.
    ProjectionResult project(std::array<Samples, 3>& velocity, Samples& potential, double share,
                             int iterations_most);

private:
    struct Maxima {
        double divergence, velocity;  ///< 1/s; m/s, of all components
    };
    Maxima divergence(const std::array<Samples, 3>& velocity);
    double apply_to_direction();
    double precondition();
    std::optional<double> step_along_direction(double slope);
    int solve(double left, double tolerance, int iterations_most);
    void subtract_correction(std::array<Samples, 3>& velocity) const;

    Lattice lattice_;
    std::array<Samples, 3> open_;
    std::array<std::vector<CutFace>, 3> cut_faces_;
    Samples diagonal_;  ///< sum of the open shares round a cell
    Samples own_;       ///< what the preconditioner takes of a cell's own residual besides (m^2)
    Rows rows_;
    PressureSolver box_;
    // Of the conjugate gradients: residual, its preconditioned, the direction, the operator on that, and their sum.
    Samples residual_, smoothed_, direction_, image_, correction_;
    std::vector<float> packed_;
};

}  // namespace thaum::fluid
