#include "fluid/sample.h"

#include <algorithm>
#include <cmath>

namespace thaum::fluid {

namespace {

/// Moves one coordinate into the box as into_box does: wrapped across periodic edges, clamped at walls.
template <class T>
T into_box(const Lattice& lattice, std::size_t axis, T place) {
    const auto n = static_cast<T>(lattice.cells[axis]);
    if (lattice.edges[axis] == Edge::periodic) return place - n * std::floor(place / n);
    return std::clamp(place, T{0}, n);
}

/// Linear interpolation along each axis at the place `at`, which is relative to the sample of cell (0, 0, 0)
/// (cells). The place must not lie before the ghost cells.
inline float between(const float* first, const std::array<std::ptrdiff_t, 3>& stride,
                     const std::array<float, 3>& at) {
    const float* p = first;
    std::array<float, 3> part{};
    for (std::size_t a = 0; a < 3; ++a) {
        // Truncation equals the floor because the number is not negative.
        const auto low = static_cast<int>(at[a] + ghosts) - ghosts;
        part[a] = at[a] - static_cast<float>(low);
        p += low * stride[a];
    }
    const auto along_x = [&](const float* q) { return q[0] + part[0] * (q[1] - q[0]); };
    const auto along_y = [&](const float* q) {
        const float low = along_x(q);
        return low + part[1] * (along_x(q + stride[1]) - low);
    };
    const float low = along_y(p);
    return low + part[2] * (along_y(p + stride[2]) - low);
}

/// One component of the velocity at the position of another component's sample: the mean of the four nearest
/// samples.
inline float mean_of_four(const float* u, std::ptrdiff_t own, std::ptrdiff_t other) {
    return 0.25F * ((u[0] + u[other]) + (u[-own] + u[other - own]));
}

}  // namespace

vec3 into_box(const Lattice& lattice, vec3 place) {
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = into_box(lattice, static_cast<std::size_t>(axis), place[axis]);
    return place;
}

void carry_back(const Lattice& lattice, const std::array<Samples, 3>& velocity, std::size_t axis, double dt,
                Samples& out) {
    const vec3 stands = face_place(axis);
    const auto cells_per_speed = static_cast<float>(dt / lattice.h);
    const auto& stride = lattice.stride;
    const float* first = velocity[axis].data() + lattice.first;
    for (int k = 0; k < lattice.cells[2]; ++k) {
        for (int j = 0; j < lattice.cells[1]; ++j) {
            for (int i = 0; i < lattice.cells[0]; ++i) {
                const auto at = lattice.at(i, j, k);
                const std::array cell{i, j, k};
                std::array<float, 3> from{};
                for (std::size_t a = 0; a < 3; ++a) {
                    const float* u = velocity[a].data() + at;
                    const float speed = a == axis ? u[0] : mean_of_four(u, stride[axis], stride[a]);
                    const auto own = static_cast<float>(stands[static_cast<int>(a)]);
                    const float place = static_cast<float>(cell[a]) + own - cells_per_speed * speed;
                    from[a] = into_box(lattice, a, place) - own;
                }
                out[static_cast<std::size_t>(at)] = between(first, stride, from);
            }
        }
    }
}

}  // namespace thaum::fluid
