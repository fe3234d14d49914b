#include "fluid/detail/ceiling.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace thaum::fluid {
namespace {

/// Highest density of a row. Densities are >= 0 or negative zero, so their bits compare like integers.
float highest_of_row(const float* value, std::ptrdiff_t count) {
    Magnitudes8 most{};
    const std::ptrdiff_t whole = count / 8 * 8;
    for (std::ptrdiff_t i = 0; i < whole; i += 8)
        most = larger_magnitudes(most, magnitudes_of(load(value + i)));
    float last = 0;
    for (std::ptrdiff_t i = whole; i < count; ++i) last = std::max(last, std::abs(value[i]));
    return std::max(last, static_cast<float>(max_of(most)));
}

/// Densities along one axis: a cell and three cells on each side, mirrored at walls and solids.
struct DensityStencil {
    std::array<float, 7> value{};
    bool narrow{};  ///< true: both sides of the cell have a wall or solid within three cells
};

/// Reads the densities around a cell. `aperture` points to the share of the face below the cell that no solid
/// covers; null means all faces are open.
DensityStencil densities_along(const float* density, const float* aperture, std::ptrdiff_t s) {
    DensityStencil result;
    auto& v = result.value;
    for (std::ptrdiff_t i = 0; i < 7; ++i) v[static_cast<std::size_t>(i)] = density[(i - 3) * s];
    if (aperture == nullptr) return result;
    // Numbers of open cells between this cell and the wall on either side, at most 3.
    std::ptrdiff_t above = 0, below = 0;
    while (above < 3 && aperture[(above + 1) * s] > 0) ++above;
    while (below < 3 && aperture[-below * s] > 0) ++below;
    result.narrow = above < 3 && below < 3;
    for (std::ptrdiff_t i = above + 1; i <= 3; ++i)
        v[static_cast<std::size_t>(3 + i)] = v[static_cast<std::size_t>(3 + 2 * above + 1 - i)];
    for (std::ptrdiff_t i = below + 1; i <= 3; ++i)
        v[static_cast<std::size_t>(3 - i)] = v[static_cast<std::size_t>(3 - (2 * below + 1 - i))];
    return result;
}

// A hill or slope of the density counts as smooth if its second difference (bend), or its rise from cell to
// cell, is at most `max_change` of its height. The smallest such value among neighbouring cells must be at
// least `evenness` of the largest.
constexpr float max_change = 0.125F, evenness = 0.7F;
/// Largest slope at a cell, divided by the bend (second difference) there, with which the top of a hill lies
/// in that cell.
constexpr float max_slope = 0.6F;

/// Height that a smooth slope gains between the last cell before a wall and the wall; 0 if there is no wall
/// or no such slope.
float rise_to_wall(const std::array<float, 7>& v) {
    const auto rise = [&](std::size_t first, std::size_t second, bool mirrored) {
        const float near = v[3] - v[first], far = v[first] - v[second];
        const float least = std::min(near, far), most = std::max(near, far);
        return mirrored && least > 0 && most < max_change * v[3] && least >= evenness * most ? 0.5F * most
                                                                                             : 0;
    };
    const float below = rise(4, 5, v[3] == v[2] && v[4] == v[1] && v[5] == v[0]);
    const float above = rise(2, 1, v[3] == v[4] && v[2] == v[5] && v[1] == v[6]);
    return std::max(below, above);
}

/// Height by which the top of a smooth hill exceeds its highest cell, from a parabola along each axis;
/// 0 if the hill is not smooth.
float crest_above(const std::array<DensityStencil, 3>& along) {
    float sum = 0;
    for (const auto& [v, narrow] : along) {
        const auto bend = [&v = v](std::size_t i) { return (v[i] - v[i + 1]) + (v[i] - v[i - 1]); };
        const float here = bend(3), below = bend(2), above = bend(4);
        const float least = std::min(here, std::min(below, above)),
                    most = std::max(here, std::max(below, above));
        const float slope = 0.5F * (v[4] - v[2]), wall = rise_to_wall(v);
        if (narrow) return 0;
        if (wall > 0) {
            sum += wall;
        } else if (least != 0 || most != 0) {
            if (!(least > 0 && most < max_change * v[3] && least >= evenness * most)) return 0;
            if (std::abs(slope) > max_slope * here) return 0;
            sum += slope * slope / (2 * here);
        }
    }
    return sum;
}

/// True if the cells above the density `level` are so many that they are the inside of a body (region of
/// nearly one density) and not the top of a hill. Layers and waves that cross the whole lattice never count
/// as a body.
bool is_plateau(const Rows& rows, const Samples& density, float level) {
    constexpr int cells_of_a_top = 64;
    const auto [nx, ny, nz] = rows.lattice.cells;
    int cells = 0;
    std::array<int, 3> first{nx, ny, nz}, last{-1, -1, -1};
    each_cell(rows.lattice, [&](int i, int j, int k, std::size_t at) {
        if (!(density[at] > level)) return;
        ++cells;
        const std::array<int, 3> cell{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first[axis] = std::min(first[axis], cell[axis]);
            last[axis] = std::max(last[axis], cell[axis]);
        }
    });
    const bool crosses =
        last[0] - first[0] + 1 == nx || last[1] - first[1] + 1 == ny || last[2] - first[2] + 1 == nz;
    return cells > cells_of_a_top && !crosses;
}

}  // namespace

float density_ceiling(const Rows& rows, const std::array<Samples, 3>* aperture, const Samples& density) {
    constexpr float near_highest = 0.8F;
    float most = 0;
    each_row(rows,
             [&](Row row) { most = std::max(most, highest_of_row(density.data() + row.at, row.count)); });
    const auto crest = [&](std::ptrdiff_t at) {
        std::array<DensityStencil, 3> along;
        for (std::size_t axis = 0; axis < 3; ++axis)
            along[axis] = densities_along(density.data() + at,
                                          aperture != nullptr ? (*aperture)[axis].data() + at : nullptr,
                                          rows.lattice.stride[axis]);
        return crest_above(along);
    };
    float result = most;
    each_row(rows, [&](Row row) {
        const float* value = density.data() + row.at;
        if (highest_of_row(value, row.count) < near_highest * most) return;
        for (std::ptrdiff_t i = 0; i < row.count; ++i)
            if (value[i] >= near_highest * most) result = std::max(result, value[i] + crest(row.at + i));
    });
    return result > most && is_plateau(rows, density, most - (result - most)) ? most : result;
}

}  // namespace thaum::fluid
