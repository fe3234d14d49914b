#include "fluid/resample.h"

#include <algorithm>
#include <cmath>

#include "fluid/fields.h"

namespace thaum::fluid {
namespace {

/// Mean of a field over a cell, sampled at `per_edge` places along each edge.
double mean_round(const field::Grid& grid, vec3 middle, double h, int per_edge) {
    if (per_edge == 1) return grid(middle).value;
    double sum = 0;
    for (int k = 0; k < per_edge; ++k)
        for (int j = 0; j < per_edge; ++j)
            for (int i = 0; i < per_edge; ++i)
                sum += grid(middle + h * ((vec3(i, j, k) + 0.5) / double(per_edge) - 0.5)).value;
    return sum / (per_edge * per_edge * per_edge);
}

void sample_into(const Lattice& lattice, vec3 first, const field::Grid& from, int per_edge, Samples& out) {
    each_cell(lattice, [&](int i, int j, int k, std::size_t at) {
        out[at] =
            static_cast<float>(mean_round(from, lattice.h * (vec3(i, j, k) + first), lattice.h, per_edge));
    });
}

void scale(Samples& samples, double factor) {
    for (float& value : samples) value = static_cast<float>(factor * double{value});
}

void take_substance(Fluid& to, const Fluid& from, std::size_t s, int per_edge) {
    const double wanted = amount(from, s);
    const auto grid = cell_grid(from.lattice, from.state.substances[s], field::Kernel::linear);
    set_substance(to, s, [&](vec3 place) { return mean_round(grid, place, to.lattice.h, per_edge); });
    if (wanted > 0 && !(amount(to, s) > 0)) set_substance(to, s, [](vec3) { return 1.0; });
    const double got = amount(to, s);
    if (got > 0) scale(to.state.substances[s], wanted / got);
}

}  // namespace

void resample_into(Fluid& to, const Fluid& from) {
    const int per_edge = std::max(1, static_cast<int>(std::ceil(to.lattice.h / from.lattice.h - 1e-9)));
    for (std::size_t axis = 0; axis < 3; ++axis)
        sample_into(to.lattice, to.place(axis),
                    grid_of(from.lattice, from.state.velocity[axis], from.place(axis)), per_edge,
                    to.state.velocity[axis]);
    for (std::size_t s = 0; s < std::min(to.state.substances.size(), from.state.substances.size()); ++s)
        take_substance(to, from, s, per_edge);
    refresh_after_edit(to);
}

}  // namespace thaum::fluid
