// fluid/viscosity.h: viscosity that is too great for explicit steps, or differs from place to place, or acts beside solids.
//
//     (1 - dt d/dx nu d/dx) (1 - dt d/dy nu d/dy) (1 - dt d/dz nu d/dz) u' = u
//
// one axis after the other (locally one-dimensional, Yanenko 1971): tridiagonal systems, so the work is bounded whatever the
// viscosity is, no value leaves the range of those before it, and energy only falls. Of first order in dt.
#pragma once
#include "fluid/lattice.h"

namespace thaum::fluid {

struct Spread {
    const Samples* viscosity{};  ///< m^2/s, of cells, ghosts filled evenly
    const std::array<Samples, 3>*
        open{};               ///< velocities on faces of which nothing is open are 0; null: no solids
    bool solid_holds = true;  ///< no slip there
    double lid{};             ///< m/s along x, of the wall at the top of y, where that holds
    double dt{};              ///< s
};

class Viscosity {
public:
    explicit Viscosity(const Lattice& lattice);
    /// Ghosts of the velocity are left as they are.
    void take(const Spread& spread, std::array<Samples, 3>& velocity);

private:
    void component(const Spread& spread, std::size_t axis, Samples& u);
    void along(const Spread& spread, std::size_t axis, std::size_t across, Samples& u);

    Lattice lattice_;
    Samples nodal_;  ///< dt nu / h^2 where the component stands; below 0 where it is closed
    // Of the lines that stand side by side, [place along a line][line].
    std::vector<float> value_, coefficient_, link_, upper_, corner_;
};

}  // namespace thaum::fluid
