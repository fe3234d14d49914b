// fluid/detail/viscosity.h: implicit viscosity, for values too large for explicit steps, variable values, or
// solids.
//
//     (1 - A_x / 2) (1 - A_y / 2) (1 - A_z / 2) u' = (1 + A_x / 2) (1 + A_y / 2) (1 + A_z / 2) u
//
// where A_x = dt d/dx nu d/dx. The axes are treated one after another (locally one-dimensional, Yanenko
// 1971), each with an explicit and an implicit half (Crank and Nicolson 1947). The systems are
// tridiagonal, so the time does not depend on the viscosity. Where nu dt / h^2 exceeds 1/2, the
// explicit part is limited to its value there, and the implicit part takes the rest. Values then stay
// within their previous range, and no wave changes its sign. This keeps the pressure stable, since it
// is solved only after viscosity has acted.
//
// A force that is constant over the step must not be damped as if it had acted before the step. Its
// explicit part is added at the end, so that a steady flow does not depend on dt.
//
// A place is a sample of one velocity component; the link between two neighbouring places has a coefficient
// dt nu / h^2. Where the viscosity varies, it is the harmonic mean of their coefficients. A flow along layers
// is then exact if they meet halfway between places. Where they meet within a cell that holds no other fluid,
// the coefficient of the cell tells how far each layer reaches into it.
//
// Curved walls: the coefficient of a link from an open place to the wall beside it is divided by the
// open part of its length. No slip then holds at the true position of the wall (Gibou, Fedkiw, Cheng
// and Kang 2002, in their symmetric form). The velocity on a cut face is the mean over its open part
// (cuts.h). The lines of this solver use the velocity at the centre of the face instead, which is
// smaller in proportion to its distance from the wall.
#pragma once
#include <limits>

#include "fluid/detail/solids.h"
#include "fluid/detail/split.h"

namespace thaum::fluid {

/// Arguments of one implicit viscous step.
struct ViscousStep {
    const Samples* viscosity{};  ///< kinematic viscosity at cell centres, with filled ghost cells (m^2/s)
    /// Largest viscosity of a link (coupling of two neighbouring samples) (m^2/s). Single samples may have a
    /// larger one, so that a cell that thick fluid fills in part differs from one that it fills wholly.
    double thickest = std::numeric_limits<double>::infinity();
    bool varies = true;  ///< true: the viscosity differs between places
    /// Constant force of this step, already included in the velocity (m/s^2); null for none.
    const std::array<Samples, 3>* force{};
    bool no_slip_at_solids = true;  ///< true: no slip at solids; false: free slip
    double lid{};                   ///< speed along x of a no-slip wall at the top of y (m/s)
    double dt{};                    ///< length of the step (s)
    int passes = 1;                 ///< number of passes of equal length into which the step is divided
};

/// Layout of slabs. A slab is a layer of parallel lines of samples, side by side along x, or along y if the
/// lines run along x.
struct Slabs {
    std::size_t beside, outer;  ///< axis along which lines are adjacent, and axis across the slabs
    std::ptrdiff_t pitch;       ///< number of lines in a slab, rounded up to a multiple of eight
};

inline Slabs slabs_along(const Lattice& lattice, std::size_t across) {
    const std::size_t beside = across == 0 ? 1 : 0;
    return {beside, 3 - across - beside, round_up_to_8(lattice.cells[beside])};
}

/// A cut face (one that a solid covers in part) whose velocity the solver needs at the centre of the face. It
/// is scaled to there from the centre of the open part.
struct ScaledFace {
    std::size_t at{};
    /// Distance of the centre of the face from the wall, divided by that of the centre of the open part.
    float factor{};
};

/// A cut face whose centre lies in the solid or close to it. Drag pulls its velocity towards a profile
/// that grows in proportion to the distance from the wall and fits its neighbours.
struct DraggedFace {
    std::size_t at{};
    float nearer{};  ///< h divided by the distance from the centre of the face's open part to the wall
    /// Indices of the neighbouring faces whose velocities define the profile.
    std::array<std::size_t, 6> from{};
    std::array<float, 6> share{};  ///< weights of the neighbours' velocities; 0 for an unused neighbour
};

/// Solver for implicit viscosity on one lattice.
class Viscosity {
public:
    /// `solids` and `solid` are null or empty without solids; `solids` must outlive this object.
    explicit Viscosity(const Lattice& lattice, const Solids* solids = nullptr, const SolidShare& solid = {});
    /// Applies one step to a velocity; its ghosts are not changed.
    void diffuse(const ViscousStep& step, std::array<Samples, 3>& velocity, Team& team);

private:
    /// Ranges of a slab (layer of parallel lines) outside of which all places are in solids: the range of
    /// places along the lines, and that of the lines, whose first is a multiple of eight.
    struct OpenRange {
        CellRange places, lines;
    };

    void begin_component(const ViscousStep& step, std::size_t axis, Layers layers, Samples& u);
    void end_component(const ViscousStep& step, std::size_t axis, Layers layers, Samples& u) const;
    /// Arrays for the lines of one slab, which one thread solves.
    struct LineScratch {
        // Arrays of parallel lines, [place along a line][line]. Lines along x need all four, since they are
        // transposed first; others need only upper and corner, which begin with a row of zeros.
        std::vector<float> value, coefficient, upper, corner;
        /// Rows with one value for each of the parallel lines that are solved together.
        std::array<std::vector<float>, 6> rows;
    };
    void along(const ViscousStep& step, std::size_t axis, std::size_t across, Layers slabs, Samples& u,
               LineScratch& scratch);

    static void add_force(const ViscousStep& step, std::size_t axis, float sign, const Floats8& coefficients,
                          std::ptrdiff_t at, Samples& u);
    void scale_to_lines(std::size_t axis, Layers layers, Samples& u);
    void scale_to_faces(const ViscousStep& step, std::size_t axis, Samples& u);

    vec3 position_of(std::size_t axis, std::size_t at) const;
    DraggedFace dragged_face(const SolidShare& solid, std::size_t axis, const CutFace& face) const;
    void find_faces(const SolidShare& solid, std::size_t axis);
    void find_cuts(const SolidShare& solid, std::size_t axis, std::size_t across);
    void find_open_ranges(std::size_t axis, std::size_t across);
    OpenRange open_range(std::size_t axis, std::size_t across, int slab) const;

    Lattice lattice_;
    const Solids* solids_;
    Rows rows_;  ///< cells that hold fluid
    /// Above 0 for faces whose velocity takes part in the tridiagonal systems; empty if there are no solids.
    std::array<Samples, 3> on_lines_;
    std::array<std::vector<ScaledFace>, 3> scaled_;
    std::array<std::vector<DraggedFace>, 3> dragged_;
    std::array<std::vector<float>, 3> dragged_speeds_;  ///< velocities of the dragged faces
    /// Factor of each link, which joins a place to the next one, by component and direction:
    /// [slab][place][line]. Where a wall cuts the link, it is h divided by the distance from the open place
    /// to the wall; else 1. Empty if there are no solids.
    std::array<std::array<std::vector<float>, 3>, 3> nearer_;
    /// For each component, direction and slab (layer of parallel lines), the range outside of which all
    /// places are in solids.
    std::array<std::array<std::vector<OpenRange>, 3>, 3> open_ranges_;
    /// dt nu / (passes h^2) at each face of a component; below 0 on closed faces.
    std::array<Samples, 3> face_coefficients_;
    /// One for each thread, by its seat (number in the team).
    std::array<LineScratch, Team::max_threads> scratch_;
    std::vector<float> closed_;
};

}  // namespace thaum::fluid
