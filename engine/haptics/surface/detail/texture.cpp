#include "haptics/surface/detail/texture.h"

#include <cmath>

namespace thaum::haptics {
namespace {

/// Weights of the quadratic B-spline for three neighbouring nodes of a bump map, and the slopes of the
/// weights.
struct Weights {
    std::array<double, 3> value{};
    std::array<double, 3> slope{};
};

/// Weights at a place `offset` cells beyond the middle node.
Weights weights_at(double offset) {
    const double before = 0.5 - offset, after = 0.5 + offset;
    return {{before * before / 2, 0.75 - offset * offset, after * after / 2}, {-before, -2 * offset, after}};
}

/// Position on the bump map (cells), wrapped round at its end, for a place at `length` along one of its axes.
/// `length` and `wavelength` are in m.
double cells_of(double length, double wavelength) {
    const double turns = length / wavelength;
    return (turns - std::floor(turns)) * static_cast<double>(bump_cells);
}

Relief bumps_at(const Texture& t, const BumpMap& map, double u, double v) {
    const double cell_u = cells_of(u, t.wavelength), cell_v = cells_of(v, t.wavelength);
    const double node_u = std::floor(cell_u + 0.5), node_v = std::floor(cell_v + 0.5);
    const Weights wu = weights_at(cell_u - node_u), wv = weights_at(cell_v - node_v);
    double height = 0, along_u = 0, along_v = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto column = (static_cast<std::size_t>(node_u) + i + bump_cells - 1) % bump_cells;
            const auto row = (static_cast<std::size_t>(node_v) + j + bump_cells - 1) % bump_cells;
            const auto node = static_cast<double>(map[row * bump_cells + column]);
            height += node * wu.value[i] * wv.value[j];
            along_u += node * wu.slope[i] * wv.value[j];
            along_v += node * wu.value[i] * wv.slope[j];
        }
    }
    const double steep = static_cast<double>(bump_cells) / t.wavelength;
    return {2 * t.amplitude * height, 2 * t.amplitude * steep * (along_u * t.axes[0] + along_v * t.axes[1])};
}
}  // namespace

Relief relief_at(const Texture& t, const BumpMap& bumps, vec3 place) noexcept {
    if (top_of(t) == 0) return {};
    const vec3 arm = place - t.origin;
    const double u = glm::dot(arm, t.axes[0]), v = glm::dot(arm, t.axes[1]);
    constexpr double max_turns = 1e9;
    const double least = t.wavelength * max_turns;
    // Farther than `least` from the origin, rounding leaves the place within a wavelength unknown, so there
    // is no texture.
    if (!(std::abs(u) < least && std::abs(v) < least)) return {};
    if (t.kind == TextureKind::bumps) return bumps_at(t, bumps, u, v);
    const double turns = u / t.wavelength;
    const double phase = 2 * pi * (turns - std::floor(turns));
    return {t.amplitude * (1 + det::sin(phase)),
            t.amplitude * 2 * pi / t.wavelength * det::cos(phase) * t.axes[0]};
}

}  // namespace thaum::haptics
