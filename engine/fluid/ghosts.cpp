#include "fluid/ghosts.h"

#include <algorithm>

#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

/// One ghost layer across an axis: a copy of another layer, times a factor.
struct Mirror {
    int to, from;
    float factor;
};

struct Mirrors {
    std::array<Mirror, 2 * ghosts + 1> all{};
    std::size_t count{};

    void add(const Mirror& mirror) { all[count++] = mirror; }
    const Mirror* begin() const { return all.data(); }
    const Mirror* end() const { return all.data() + count; }
};

Mirrors periodic_mirrors(int n, int depth) {
    Mirrors result;
    for (int layer = 1; layer <= depth; ++layer) {
        // If the lattice is thinner than its layers of ghost cells, one cell fills several layers.
        result.add({-layer, (n - layer % n) % n, 1});
        result.add({n - 1 + layer, (layer - 1) % n, 1});
    }
    return result;
}

Mirrors wall_mirrors(int n, float factor, int depth) {
    Mirrors result;
    for (int layer = 1; layer <= depth; ++layer) {
        const int inward = std::min(layer, n) - 1;
        result.add({-layer, inward, factor});
        result.add({n - 1 + layer, n - 1 - inward, factor});
    }
    return result;
}

/// Ghost layers of a quantity that is sampled on the faces across the axis and is zero on walls. Layers 0 and
/// n are the walls themselves.
Mirrors face_mirrors(int n, int depth) {
    Mirrors result;
    result.add({0, 0, 0});
    result.add({n, n, 0});
    for (int layer = 1; layer <= depth; ++layer) {
        const int inward = std::min(layer, n);
        result.add({-layer, inward, -1});
        if (layer < ghosts) result.add({n + layer, n - inward, -1});
    }
    return result;
}

Mirrors mirrors(int n, Edge edge, GhostRule rule, int depth) {
    if (edge == Edge::periodic) return periodic_mirrors(n, depth);
    if (rule == GhostRule::through_wall) return face_mirrors(n, depth);
    return wall_mirrors(n, rule == GhostRule::even ? 1.0F : -1.0F, depth);
}

/// Copies a whole row or plane, whose length is a multiple of eight, times a factor. It calls no library
/// function to copy or clear memory: for such short rows the call would take longer than the copy.
void copy_scaled(const float* from, float* to, std::ptrdiff_t count, float factor) {
    if (factor == 1) {
        if (to != from) copy_by_8(from, to, count);
    } else {
        for (std::ptrdiff_t i = 0; i < count; i += 8)
            store(to + i, factor == 0 ? zero8 : factor * load(from + i));
    }
}

void fill_row(const Lattice& lattice, const Mirrors& all, float* row) {
    // Rows are written in multiples of eight, so values beyond the ghosts are still arbitrary here and are
    // set to 0.
    for (const Mirror& m : all) row[m.to] = m.factor == 0 ? 0 : m.factor * row[m.from];
    for (std::ptrdiff_t i = lattice.cells[0] + ghosts; i < round_up_to_8(lattice.cells[0]); ++i) row[i] = 0;
}

/// Fills the ghosts at both ends of a row that has more cells than ghosts.
[[gnu::always_inline]] inline void fill_ends(const Lattice& lattice, GhostRule rule, int depth, float* row) {
    const std::ptrdiff_t n = lattice.cells[0];
    float* const end = row + n;
    if (lattice.edges[0] == Edge::periodic) {
        for (int layer = 1; layer <= depth; ++layer) {
            row[-layer] = end[-layer];
            end[layer - 1] = row[layer - 1];
        }
    } else if (rule == GhostRule::through_wall) {
        row[0] = end[0] = 0;
        for (int layer = 1; layer <= depth; ++layer) row[-layer] = -row[layer];
        for (int layer = 1; layer <= std::min(depth, ghosts - 1); ++layer) end[layer] = -end[-layer];
    } else {
        const float factor = rule == GhostRule::even ? 1.0F : -1.0F;
        for (int layer = 1; layer <= depth; ++layer) {
            row[-layer] = factor * row[layer - 1];
            end[layer - 1] = factor * end[-layer];
        }
    }
    for (std::ptrdiff_t i = n + ghosts; i < round_up_to_8(n); ++i) row[i] = 0;
}

bool has_simple_ends(const Lattice& lattice) { return lattice.cells[0] > ghosts; }

/// Calls `visit` with the start of each lattice row in `layers` whose ghosts across x mirror fluid.
template <class Visit>
void each_row_near_sides(const Rows& rows, Layers layers, const Visit& visit) {
    const auto& all = rows.rows_near_sides;
    const auto from = std::ranges::lower_bound(all, rows.lattice.at(0, 0, layers.first));
    const auto end = rows.lattice.at(0, 0, layers.end);
    for (auto at = from; at != all.end() && *at < end; ++at) visit(*at);
}

void fill_x(const Lattice& lattice, Layers layers, const Mirrors& all, float* cells) {
    each_row(lattice, layers, [&](std::ptrdiff_t at) { fill_row(lattice, all, cells + at); });
}

void fill_x(const Rows& rows, Layers layers, const Mirrors& all, float* cells) {
    each_row_near_sides(rows, layers, [&](std::ptrdiff_t at) { fill_row(rows.lattice, all, cells + at); });
}

void fill_y(const Lattice& lattice, Layers layers, const Mirrors& all, float* cells) {
    const auto row = lattice.stride[1];
    for (int k = layers.first; k < layers.end; ++k) {
        float* plane = cells + lattice.at(-ghosts, 0, k);
        for (const Mirror& m : all) copy_scaled(plane + m.from * row, plane + m.to * row, row, m.factor);
    }
}

/// Whether a ghost layer across z copies one of `layers`. The wall behind the last layer counts as that
/// layer.
bool copies(const Mirror& m, Layers layers, const Lattice& lattice) {
    return layers.contains(std::min(m.from, lattice.cells[2] - 1));
}

void fill_z(const Lattice& lattice, Layers layers, const Mirrors& all, float* cells) {
    const auto plane = lattice.stride[2];
    float* first = cells + lattice.at(-ghosts, -ghosts, 0);
    for (const Mirror& m : all)
        if (copies(m, layers, lattice))
            copy_scaled(first + m.from * plane, first + m.to * plane, plane, m.factor);
}

/// Copies row j of layer k, including its ghost cells, from another row, times `factor`.
void copy_row(const Lattice& lattice, int from_j, int from_k, int j, int k, float factor, float* cells) {
    copy_scaled(cells + lattice.at(-ghosts, from_j, from_k), cells + lattice.at(-ghosts, j, k),
                lattice.stride[1], factor);
}

bool holds_fluid(const Rows& rows, int j, int k) {
    return j >= 0 && j < rows.lattice.cells[1] && rows.at(j, k).count > 0;
}

void fill_y(const Rows& rows, Layers layers, const Mirrors& all, float* cells) {
    for (int k = layers.first; k < layers.end; ++k)
        for (const Mirror& m : all)
            if (holds_fluid(rows, m.from, k)) copy_row(rows.lattice, m.from, k, m.to, k, m.factor, cells);
}

void fill_z(const Rows& rows, Layers layers, const Mirrors& all, float* cells) {
    const int ny = rows.lattice.cells[1];
    for (const Mirror& m : all) {
        if (!layers.contains(m.from)) continue;
        const auto copy = [&](int j) { copy_row(rows.lattice, j, m.from, j, m.to, m.factor, cells); };
        // Rows next to the two sides across y are mirrored into the ghosts, so those ghosts are copied
        // together with the rows.
        bool low = false, high = false;
        for (int j = 0; j < ny; ++j) {
            if (!holds_fluid(rows, j, m.from)) continue;
            copy(j);
            low = low || j <= ghosts;
            high = high || j >= ny - ghosts;
        }
        const bool round = rows.lattice.edges[1] == Edge::periodic;
        for (int layer = 1; layer <= ghosts; ++layer) {
            if (low || (round && high)) copy(-layer);
            if (high || (round && low)) copy(ny - 1 + layer);
        }
    }
}

void fill_across(const Lattice& lattice, Layers layers, std::size_t axis, GhostRule rule, float* cells) {
    if (axis == 0 && has_simple_ends(lattice))
        return each_row(lattice, layers,
                        [&](std::ptrdiff_t at) { fill_ends(lattice, rule, ghosts, cells + at); });
    constexpr std::array<void (*)(const Lattice&, Layers, const Mirrors&, float*), 3> fill{fill_x, fill_y,
                                                                                           fill_z};
    fill[axis](lattice, layers, mirrors(lattice.cells[axis], lattice.edges[axis], rule, ghosts), cells);
}

}  // namespace

void fill_ghosts_across(const Lattice& lattice, std::size_t axis, GhostRule rule, Samples& samples) {
    fill_across(lattice, all_layers(lattice), axis, rule, samples.data());
}

void fill_ghosts_across(const Rows& rows, Layers layers, std::size_t axis, GhostRule rule, Samples& samples,
                        int depth) {
    const Lattice& lattice = rows.lattice;
    if (rows.complete) return fill_across(lattice, layers, axis, rule, samples.data());
    if (axis == 0 && has_simple_ends(lattice)) {
        each_row_near_sides(rows, layers,
                            [&](std::ptrdiff_t at) { fill_ends(lattice, rule, depth, samples.data() + at); });
        return;
    }
    constexpr std::array<void (*)(const Rows&, Layers, const Mirrors&, float*), 3> fill{fill_x, fill_y,
                                                                                        fill_z};
    fill[axis](rows, layers, mirrors(lattice.cells[axis], lattice.edges[axis], rule, depth), samples.data());
}

void fill_ghosts_across(const Rows& rows, std::size_t axis, GhostRule rule, Samples& samples, int depth) {
    fill_ghosts_across(rows, all_layers(rows.lattice), axis, rule, samples, depth);
}

// The axes are filled one after another, so edges and corners copy ghosts that are already filled.
void fill_ghosts(const Lattice& lattice, const std::array<GhostRule, 3>& rule, Samples& samples) {
    for (std::size_t axis = 0; axis < 3; ++axis) fill_ghosts_across(lattice, axis, rule[axis], samples);
}

void fill_ghosts(const Rows& rows, const std::array<GhostRule, 3>& rule, Samples& samples, int depth) {
    fill_ghosts(rows, all_layers(rows.lattice), rule, samples, depth);
}

void fill_ghosts(const Rows& rows, Layers layers, const std::array<GhostRule, 3>& rule, Samples& samples,
                 int depth) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        fill_ghosts_across(rows, layers, axis, rule[axis], samples, depth);
}

std::array<GhostRule, 3> ghost_rules_of_velocity(const Lattice& lattice, std::size_t axis) {
    std::array<GhostRule, 3> result{};
    for (std::size_t across = 0; across < 3; ++across)
        result[across] = lattice.edges[across] == Edge::no_slip ? GhostRule::odd : GhostRule::even;
    result[axis] = GhostRule::through_wall;
    return result;
}

}  // namespace thaum::fluid
