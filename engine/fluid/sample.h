// fluid/sample.h: the semi-Lagrangian step: what each place holds comes from where its flow was (Stam 1999).
#pragma once
#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Where component `axis` of cell (0, 0, 0) stands on a staggered lattice, in cells.
inline vec3 face_place(std::size_t axis) {
    vec3 result(0.5);
    result[static_cast<int>(axis)] = 0;
    return result;
}

/// A place, in cells, moved into the box: to the nearest one, or round where the edges are periodic.
vec3 into_box(const Lattice& lattice, vec3 place);

/// One component of a staggered velocity as it was, dt ago, where the flow through its places came from (first order). Ghosts of
/// the velocity are filled; those of out are left.
void carry_back(const Lattice& lattice, const std::array<Samples, 3>& velocity, std::size_t axis, double dt,
                Samples& out);

}  // namespace thaum::fluid
