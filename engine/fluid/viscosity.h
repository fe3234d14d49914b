// fluid/viscosity.h: viscosity that is too great for explicit steps, or differs from place to place, or acts beside solids.
//
//     (1 - dt d/dx nu d/dx) (1 - dt d/dy nu d/dy) (1 - dt d/dz nu d/dz) u' = u
//
// one axis after the other (locally one-dimensional, Yanenko 1971): tridiagonal systems, so the work is bounded whatever the
// viscosity is, no value leaves the range of those before it, and energy only falls. Of first order in dt.
//
// Where a wall stands between an open place and a closed one beside it, what couples the two is divided by the part of the way that is
// open, so that no slip is where the wall is and not where the closed place is (Gibou, Fedkiw, Cheng and Kang 2002, in their symmetric
// form). A turning bowl of 32 cells is then slowed with an eighth of the error.
#pragma once
#include <functional>
#include <span>

#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

struct Spread {
    const Samples* viscosity{};  ///< m^2/s, of cells, ghosts filled evenly
    bool solid_holds = true;     ///< no slip at solids
    double lid{};                ///< m/s along x, of the wall at the top of y, where that holds
    double dt{};                 ///< s
};

/// Velocities on faces of which nothing is open are 0.
struct Walls {
    const std::array<Samples, 3>* open{};  ///< null: no solids; must outlive what it is given to
    std::function<double(vec3)> solid{};   ///< share of a place that is solid, by the place in m
};

/// Between two places next to each other, one of them closed.
struct CutLink {
    int slab{};
    std::ptrdiff_t at{};  ///< in the slab, of the lower place
    float nearer{};       ///< h by the way from the open place to the wall
};

class Viscosity {
public:
    explicit Viscosity(const Lattice& lattice, const Walls& walls = {});
    /// Ghosts of the velocity are left as they are.
    void take(const Spread& spread, std::array<Samples, 3>& velocity);

private:
    void component(const Spread& spread, std::size_t axis, Samples& u);
    void along(const Spread& spread, std::size_t axis, std::size_t across, Samples& u);

    void find_cuts(const std::function<double(vec3)>& solid, std::size_t axis, std::size_t across);
    std::span<const CutLink> cuts_of(std::size_t axis, std::size_t across, int slab) const;

    Lattice lattice_;
    const std::array<Samples, 3>* open_;
    std::array<std::array<std::vector<CutLink>, 3>, 3>
        cuts_;       ///< by component and direction, in order of slabs
    Samples nodal_;  ///< dt nu / h^2 where the component stands; below 0 where it is closed
    // Of the lines that stand side by side, [place along a line][line].
    std::vector<float> value_, coefficient_, link_, upper_, corner_;
};

}  // namespace thaum::fluid
