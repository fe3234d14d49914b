// fluid/fields.h: samples of a fluid as fields (field/field.h) for haptics and pictures.
//
// The ghost samples outside the walls belong to such a field, so they must be filled. Near a wall,
// interpolation then reads the mirror image of the flow.
#pragma once
#include <span>

#include "field/field.h"
#include "fluid/lattice.h"
#include "fluid/sample.h"

namespace thaum::fluid {

/// A field of samples. `first` is the position of the sample of cell (0, 0, 0), in cells: the centre of the
/// cell, or the centre of its low face across an axis.
inline field::Grid grid_of(const Lattice& lattice, std::span<const float> samples, vec3 first,
                           field::Kernel kernel = field::Kernel::catmull_rom) {
    field::Grid grid{.first = samples.data() + lattice.at(-ghosts, -ghosts, -ghosts),
                     .stride = lattice.stride,
                     .origin = lattice.h * (first - vec3(ghosts)),
                     .spacing = vec3(lattice.h),
                     .kernel = kernel};
    for (std::size_t axis = 0; axis < 3; ++axis) grid.count[axis] = lattice.cells[axis] + 2 * ghosts;
    return grid;
}

/// A field of a density or another quantity sampled at cell centres.
inline field::Grid cell_grid(const Lattice& lattice, std::span<const float> samples,
                             field::Kernel kernel = field::Kernel::catmull_rom) {
    return grid_of(lattice, samples, vec3(0.5), kernel);
}

/// A field of a velocity sampled on faces.
inline field::StaggeredGrid face_grid(const Lattice& lattice, const std::array<Samples, 3>& velocity,
                                      field::Kernel kernel = field::Kernel::catmull_rom) {
    return {{grid_of(lattice, velocity[0], face_place(0), kernel),
             grid_of(lattice, velocity[1], face_place(1), kernel),
             grid_of(lattice, velocity[2], face_place(2), kernel)}};
}

}  // namespace thaum::fluid
