// fluid/detail/solids.h: walls of any shape on the staggered grid.
//
// Each face has an open share: the part of its area that no solid covers. A cell with an open face holds
// fluid. The pressure must cancel the net flow through the open parts of each cell's faces (Batty, Bertails
// and Bridson 2007). Conjugate gradients solve for it. The preconditioner is the direct solve of the whole
// box without solids, plus a term for cells that are mostly closed.
//
// In effect this solve of the whole box extends the flow in the fluid into the solid as smoothly as possible.
// The energy of this extension is at most a small multiple of the energy in the fluid, however fine the grid
// is. The number of iterations therefore does not grow with the grid.
#pragma once
#include <optional>

#include "fluid/detail/cuts.h"
#include "fluid/detail/separable.h"
#include "fluid/detail/split.h"
#include "fluid/rows.h"

namespace thaum::fluid {

/// A face that is partly open.
struct CutFace {
    std::size_t at{};  ///< index in the samples
    vec3 middle{};     ///< centre of the open part (m)
};

/// Faces with a smaller open share count as closed, and the flow through them is lost. With 0.125 this loss
/// was 8 to 10 % of the squared error of a flow in a bowl, and more on finer grids. Smaller openings do not
/// add iterations to the pressure solve.
inline constexpr double min_open = 0.02;
/// Limit of the open share for a fluid that slips along solids: faces with a smaller share count as closed.
/// The flow beside a wall is then as fast as elsewhere, and what is lost through a small closed opening is
/// pushed through others by the pressure. With a limit of 0.02, a flow that turns as a rigid body had 1.7
/// times the error that it has with 0.002 at 48 cells, and hardly less at 64.
inline constexpr double open_least_where_slipping = 0.002;

/// Solids on one lattice: open shares of faces, and the projection that removes divergence.
class Solids {
public:
    Solids(const Lattice& lattice, const SolidShare& solid, double min_share = min_open);

    /// Open share (part that no solid covers) of each face, 0 to 1, by the component of velocity sampled
    /// there; including ghost cells; 0 on walls.
    const std::array<Samples, 3>& open() const { return open_; }
    /// Faces of a component that are partly open, sorted by index.
    const std::vector<CutFace>& cut_faces(std::size_t axis) const { return cut_faces_[axis]; }
    /// Whether a cell holds fluid; `cell` is its index from Lattice::at.
    bool holds_fluid(std::size_t cell) const { return diagonal_[cell] > 0; }

    /// Rows of the cells that hold fluid. They contain all open faces.
    const Rows& rows() const { return rows_; }

    /// Sets velocities on faces that solids close off to 0.
    void clear_closed_faces(std::array<Samples, 3>& velocity) const;

    struct ProjectionResult {
        int iterations{};
        double divergence{};  ///< largest remaining divergence (1/s)
    };
    /// Removes the divergence, until it is at most `share` times the largest velocity component divided
    /// by h. The velocity must be 0 on closed faces.
    ///
    /// `potential` is input and output. On return its gradient is what was subtracted from the velocity,
    /// ghosts included. On entry it holds the potential of the last projection, which is the first search
    /// direction. The length of the step along it is the one that reduces the energy of the flow most
    /// (Fischer 1998, with one direction), so a bad guess does no harm.
    ProjectionResult project(std::array<Samples, 3>& velocity, Samples& potential, double share,
                             int max_iterations, Team& team);

private:
    struct Maxima {
        double divergence, velocity;  ///< largest divergence (1/s); largest velocity component (m/s)
    };
    Maxima divergence(const std::array<Samples, 3>& velocity, Team& team);
    Maxima divergence_in(const std::array<Samples, 3>& velocity, Layers layers);
    double apply_to_direction(Team& team);
    void apply_in(Layers layers);
    struct Products {
        double residual{}, image{};
    };
    Products precondition(Team& team);
    void smooth_in(Layers layers);
    std::optional<double> step_along_direction(double slope, Team& team);
    double take_step_in(float step, Layers layers);
    int solve(double left, double tolerance, int max_iterations, Team& team);
    void subtract_correction_in(Layers layers, std::array<Samples, 3>& velocity) const;
    void begin_round(std::array<Samples, 3>& velocity, Team& team);
    void end_round(std::array<Samples, 3>& velocity, Samples& potential, Team& team) const;
    Products sum_of_rows() const;

    Lattice lattice_;
    std::array<Samples, 3> open_;
    std::array<std::vector<CutFace>, 3> cut_faces_;
    Samples diagonal_;  ///< sum of the open shares of the faces of each cell
    /// Factor by which the preconditioner adds a cell's own residual; above 0 only for cells that solids
    /// mostly close off (m^2).
    Samples own_;
    Rows rows_;
    PressureSolver box_;
    // Conjugate gradients: residual, preconditioned residual, search direction, operator times
    // direction, solution.
    Samples residual_, smoothed_, direction_, image_, correction_;
    double curvature_{};  ///< product of direction_ and image_; 0: no direction yet
    std::vector<float> packed_;
    /// Sums over the cells of each row. They are added in the order of the rows, whichever thread found them.
    std::vector<Products> row_sums_;
};

}  // namespace thaum::fluid
