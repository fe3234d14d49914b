// fluid/sample.h: semi-Lagrangian advection: each sample takes the value from the place where its fluid was
// before (Stam 1999).
#pragma once
#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Position of the sample of component `axis` in cell (0, 0, 0) on a staggered lattice (cells).
inline vec3 face_place(std::size_t axis) {
    vec3 result(0.5);
    result[static_cast<int>(axis)] = 0;
    return result;
}

/// Moves a place (cells) into the box: wrapped across periodic edges, clamped at walls.
vec3 into_box(const Lattice& lattice, vec3 place);

/// Computes one component of a staggered velocity after semi-Lagrangian advection by dt (s), to first order.
/// The ghost cells of `velocity` must be filled; those of `out` are not written.
void carry_back(const Lattice& lattice, const std::array<Samples, 3>& velocity, std::size_t axis, double dt,
                Samples& out);

}  // namespace thaum::fluid
