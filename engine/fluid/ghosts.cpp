#include "fluid/ghosts.h"

#include <algorithm>
#include <cstring>

namespace thaum::fluid {
namespace {

/// A layer across an axis, and what it holds: another one, times a factor.
struct Mirror {
    int to, from;
    float factor;
};

using Mirrors = std::array<Mirror, 2 * ghosts + 1>;

Mirrors round_about(int n) {
    Mirrors result{};
    std::size_t count = 0;
    for (int layer = 1; layer <= ghosts; ++layer) {
        // Of few cells the same one stands in several layers.
        result[count++] = {-layer, (n - layer % n) % n, 1};
        result[count++] = {n - 1 + layer, (layer - 1) % n, 1};
    }
    result[count] = {0, 0, 1};
    return result;
}

Mirrors about_walls(int n, float factor) {
    Mirrors result{};
    std::size_t count = 0;
    for (int layer = 1; layer <= ghosts; ++layer) {
        const int inward = std::min(layer, n) - 1;
        result[count++] = {-layer, inward, factor};
        result[count++] = {n - 1 + layer, n - 1 - inward, factor};
    }
    result[count] = {0, 0, 1};
    return result;
}

/// The walls themselves are layers 0 and n.
Mirrors through_walls(int n) {
    Mirrors result{{{0, 0, 0}, {n, n, 0}}};
    std::size_t count = 2;
    for (int layer = 1; layer <= ghosts; ++layer) {
        const int inward = std::min(layer, n);
        result[count++] = {-layer, inward, -1};
        if (layer < ghosts) result[count++] = {n + layer, n - inward, -1};
    }
    return result;
}

Mirrors mirrors(int n, Edge edge, Beyond beyond) {
    if (edge == Edge::periodic) return round_about(n);
    if (beyond == Beyond::through_wall) return through_walls(n);
    return about_walls(n, beyond == Beyond::even ? 1.0F : -1.0F);
}

void copy_scaled(const float* from, float* to, std::ptrdiff_t count, float factor) {
    if (factor == 1) {
        if (to != from) std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
    } else if (factor == 0) {
        std::fill_n(to, count, 0.0F);
    } else {
        for (std::ptrdiff_t i = 0; i < count; ++i) to[i] = factor * from[i];
    }
}

void fill_row(const Lattice& lattice, const Mirrors& all, float* row) {
    // Rows are written in whole eights: what that left beyond the cells may be anything.
    for (const Mirror& m : all) row[m.to] = m.factor == 0 ? 0 : m.factor * row[m.from];
    for (std::ptrdiff_t i = lattice.cells[0] + ghosts; i < whole_eights(lattice.cells[0]); ++i) row[i] = 0;
}

void fill_x(const Lattice& lattice, const Mirrors& all, float* cells) {
    each_row(lattice, [&](std::ptrdiff_t at) { fill_row(lattice, all, cells + at); });
}

void fill_x(const Rows& rows, const Mirrors& all, float* cells) {
    for (const std::ptrdiff_t at : rows.at_sides) fill_row(rows.lattice, all, cells + at);
}

void fill_y(const Lattice& lattice, const Mirrors& all, float* cells) {
    const auto row = lattice.stride[1];
    for (int k = 0; k < lattice.cells[2]; ++k) {
        float* plane = cells + lattice.at(-ghosts, 0, k);
        for (const Mirror& m : all) copy_scaled(plane + m.from * row, plane + m.to * row, row, m.factor);
    }
}

void fill_z(const Lattice& lattice, const Mirrors& all, float* cells) {
    const auto plane = lattice.stride[2];
    float* first = cells + lattice.at(-ghosts, -ghosts, 0);
    for (const Mirror& m : all) copy_scaled(first + m.from * plane, first + m.to * plane, plane, m.factor);
}

}  // namespace

void fill_ghosts_across(const Lattice& lattice, std::size_t axis, Beyond beyond, Samples& samples) {
    constexpr std::array<void (*)(const Lattice&, const Mirrors&, float*), 3> fill{fill_x, fill_y, fill_z};
    fill[axis](lattice, mirrors(lattice.cells[axis], lattice.edges[axis], beyond), samples.data());
}

void fill_ghosts_across(const Rows& rows, std::size_t axis, Beyond beyond, Samples& samples) {
    const Lattice& lattice = rows.lattice;
    if (axis == 0)
        fill_x(rows, mirrors(lattice.cells[0], lattice.edges[0], beyond), samples.data());
    else
        fill_ghosts_across(lattice, axis, beyond, samples);
}

// One axis after another, so that edges and corners follow from what was filled before.
void fill_ghosts(const Lattice& lattice, const std::array<Beyond, 3>& beyond, Samples& samples) {
    for (std::size_t axis = 0; axis < 3; ++axis) fill_ghosts_across(lattice, axis, beyond[axis], samples);
}

void fill_ghosts(const Rows& rows, const std::array<Beyond, 3>& beyond, Samples& samples) {
    for (std::size_t axis = 0; axis < 3; ++axis) fill_ghosts_across(rows, axis, beyond[axis], samples);
}

std::array<Beyond, 3> beyond_of_velocity(const Lattice& lattice, std::size_t axis) {
    std::array<Beyond, 3> result{};
    for (std::size_t across = 0; across < 3; ++across)
        result[across] = lattice.edges[across] == Edge::no_slip ? Beyond::odd : Beyond::even;
    result[axis] = Beyond::through_wall;
    return result;
}

}  // namespace thaum::fluid
