// fluid/viscosity.h: viscosity that is too great for explicit steps, or differs from place to place, or acts beside solids.
//
//     (1 - A_x / 2) (1 - A_y / 2) (1 - A_z / 2) u' = (1 + A_x / 2) (1 + A_y / 2) (1 + A_z / 2) u,    A_x = dt d/dx nu d/dx
//
// One axis after the other (locally one-dimensional, Yanenko 1971), each by its own explicit and implicit half (Crank and Nicolson 1947):
// tridiagonal systems, so the work is bounded whatever the viscosity is. Where nu dt / h^2 is above a half, the explicit part stays what
// it is there and the implicit one takes the rest: no value leaves the range of those before it, and no wave changes its sign. That keeps
// the pressure stable, which is told only afterwards what viscosity left of its push.
//
// A force that is constant over the step must not be damped as if it had all acted before: its explicit part is added at the end, so that
// a steady flow does not depend on dt.
//
// Curved walls. A link from an open place to the wall beside it is divided by the open part of the way, so that no slip is where the wall
// is (Gibou, Fedkiw, Cheng and Kang 2002, in their symmetric form). The velocity on a cut face is the mean over its open part (cuts.h); on
// the lines its speed in the middle of the face stands, which is less in proportion to the distance from the wall.
#pragma once
#include <span>

#include "fluid/solids.h"

namespace thaum::fluid {

struct ViscousStep {
    const Samples* viscosity{};  ///< m^2/s, of cells, ghosts filled evenly
    /// The constant force of this step (m/s^2), whose work is in the velocity already; null for none.
    const std::array<Samples, 3>* force{};
    bool solid_holds = true;  ///< no slip at solids
    double lid{};             ///< m/s along x, of the wall at the top of y, where that holds
    double dt{};              ///< s
    int passes = 1;           ///< into which the step is divided
};

/// A link between a place on the lines and one next to it that is not.
struct CutLink {
    int slab{};
    std::ptrdiff_t at{};  ///< in the slab, of the lower place
    float nearer{};       ///< h by the way from the open place to the wall
};

/// A cut face that stands on the lines with the speed in its middle; the velocity on it is that in the middle of its open part.
struct ScaledFace {
    std::size_t at{};
    float
        factor{};  ///< ratio of these speeds: the distance of its middle from the wall by that of its open middle
};

/// A cut face whose middle is in the solid or close to it. It is dragged towards what its neighbours and the wall say: a speed in
/// proportion to the distance from the wall.
struct DraggedFace {
    std::size_t at{};
    float nearer{};                     ///< h by the distance from its open middle to the wall
    std::array<std::size_t, 6> from{};  ///< neighbours
    std::array<float, 6> share{};       ///< factors of their speeds; 0 where there is none
};

class Viscosity {
public:
    /// `solids` and `solid`: null for none; the former must outlive this.
    explicit Viscosity(const Lattice& lattice, const Solids* solids = nullptr, const SolidShare& solid = {});
    /// Ghosts of the velocity are left as they are.
    void diffuse(const ViscousStep& step, std::array<Samples, 3>& velocity);

private:
    void component(const ViscousStep& step, std::size_t axis, Samples& u);
    void along(const ViscousStep& step, std::size_t axis, std::size_t across, Samples& u);

    static void add_force(const ViscousStep& step, std::size_t axis, float sign, const Floats8& nodal,
                          std::ptrdiff_t at, Samples& u);
    void put_onto_lines(std::size_t axis, Samples& u);
    void put_onto_faces(const ViscousStep& step, std::size_t axis, Samples& u);

    vec3 place_of(std::size_t axis, std::size_t at) const;
    DraggedFace dragged_face(const SolidShare& solid, std::size_t axis, const CutFace& face) const;
    void find_faces(const SolidShare& solid, std::size_t axis);
    void find_cuts(const SolidShare& solid, std::size_t axis, std::size_t across);
    void find_open_ranges(std::size_t axis, std::size_t across);
    std::span<const CutLink> cuts_of(std::size_t axis, std::size_t across, int slab) const;

    Lattice lattice_;
    const Solids* solids_;
    Rows rows_;  ///< cells that hold fluid
    std::array<Samples, 3>
        on_lines_;  ///< above 0 where a component stands on the lines; empty without solids
    std::array<std::vector<ScaledFace>, 3> scaled_;
    std::array<std::vector<DraggedFace>, 3> dragged_;
    std::vector<float> dragged_speeds_;  ///< speeds of the dragged faces
    std::array<std::array<std::vector<CutLink>, 3>, 3>
        cuts_;  ///< by component and direction, in order of slabs
    std::array<std::array<std::vector<CellRange>, 3>, 3> open_ranges_;  ///< by component, direction and slab
    Samples nodal_;  ///< dt nu / h^2 where the component stands; below 0 where it does not
    // Of the lines that stand side by side, [place along a line][line]; value_ and coefficient_ of lines along x alone.
    std::vector<float> value_, coefficient_, upper_, corner_;
    // One value for each of the lines.
    std::array<std::vector<float>, 6> rows_of_lines_;
    std::vector<float> closed_;
};

}  // namespace thaum::fluid
