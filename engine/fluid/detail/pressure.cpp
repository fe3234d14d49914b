#include "fluid/detail/pressure.h"

#include "fluid/detail/part_of_row.h"
#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

/// Difference between samples `s` apart, at order 4 corrected by farther ones; about h times the derivative.
template <bool fourth>
inline Floats8 difference(const float* u, std::ptrdiff_t s) {
    if constexpr (fourth)
        return 1.125F * (load(u + s) - load(u)) - (1.0F / 24) * (load(u + 2 * s) - load(u - s));
    else
        return load(u + s) - load(u);
}

template <bool fourth>
void divergence_of(const Lattice& lattice, Layers layers, const std::array<Samples, 3>& velocity,
                   float* out) {
    const auto [x, y, z] = lattice.stride;
    const std::ptrdiff_t nx = lattice.cells[0];
    const auto per_h = static_cast<float>(1 / lattice.h);
    out += layers.first * lattice.cells[1] * nx;
    for (int k = layers.first; k < layers.end; ++k) {
        for (int j = 0; j < lattice.cells[1]; ++j) {
            const auto at = lattice.at(0, j, k);
            const float* u = velocity[0].data() + at;
            const float* v = velocity[1].data() + at;
            const float* w = velocity[2].data() + at;
            for (std::ptrdiff_t i = 0; i < nx; i += 8)
                store_within_row(out + i,
                                 per_h * (difference<fourth>(u + i, x) +
                                          (difference<fourth>(v + i, y) + difference<fourth>(w + i, z))),
                                 nx - i);
            out += nx;
        }
    }
}

template <bool fourth>
void subtract_gradient_of(const Rows& rows, Layers layers, const Samples& potential,
                          std::array<Samples, 3>& velocity) {
    const auto per_h = static_cast<float>(1 / rows.lattice.h);
    each_row(rows, layers, [&](Row row) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto s = rows.lattice.stride[axis];
            const float* before = potential.data() + row.at - s;
            float* u = velocity[axis].data() + row.at;
            for (std::ptrdiff_t i = 0; i < row.count; i += 8)
                store_within_row(u + i, load(u + i) - per_h * difference<fourth>(before + i, s),
                                 row.count - i);
        }
    });
}

}  // namespace

void divergence(const Lattice& lattice, Layers layers, int order, const std::array<Samples, 3>& velocity,
                std::span<float> out) {
    if (order == 4)
        divergence_of<true>(lattice, layers, velocity, out.data());
    else
        divergence_of<false>(lattice, layers, velocity, out.data());
}

void subtract_gradient(const Rows& rows, Layers layers, int order, const Samples& potential,
                       std::array<Samples, 3>& velocity) {
    if (order == 4)
        subtract_gradient_of<true>(rows, layers, potential, velocity);
    else
        subtract_gradient_of<false>(rows, layers, potential, velocity);
}

}  // namespace thaum::fluid
