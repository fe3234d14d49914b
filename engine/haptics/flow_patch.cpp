#include "haptics/flow_patch.h"

#include <algorithm>
#include <cmath>

namespace thaum::haptics {
namespace {

constexpr std::size_t node_count = FlowPatch{}.nodes.size();
using NodeValues = std::array<double, node_count>;

/// The two samples of a fluid's grid on either side of a node of the flow patch, along one axis.
struct Between {
    std::ptrdiff_t low{}, high{};  ///< offsets of the two samples in the grid's array
    double t{};                    ///< position of the node between them, 0 at `low` and 1 at `high`
};
using AxisOfNodes = std::array<Between, flow_nodes>;

bool has_samples(const field::Grid& grid) {
    return grid.has_samples() && glm::all(glm::greaterThan(grid.spacing, vec3(0)));
}

AxisOfNodes axis_of(const field::Grid& grid, std::size_t axis, double first_node, double node_spacing) {
    const double last = grid.count[axis] - 1;
    AxisOfNodes nodes;
    for (int n = 0; n < flow_nodes; ++n) {
        const double off = first_node + n * node_spacing - grid.origin[static_cast<int>(axis)];
        const double x = std::clamp(off / grid.spacing[static_cast<int>(axis)], 0.0, last);
        const auto low = static_cast<std::ptrdiff_t>(std::max(0.0, std::min(std::floor(x), last - 1)));
        const std::ptrdiff_t step = last > 0 ? grid.stride[axis] : 0;
        nodes[static_cast<std::size_t>(n)] = {low * grid.stride[axis], low * grid.stride[axis] + step,
                                              x - static_cast<double>(low)};
    }
    return nodes;
}

/// Adds the values of a fluid's grid at the nodes of the patch, times `weight`, to `values`. The grid, whose
/// first sample is `first`, is read linearly between its samples.
template <class T>
void add_at_nodes(const field::Grid& grid, const T* first, const FlowPatch& patch, double weight,
                  NodeValues& values) {
    const AxisOfNodes x = axis_of(grid, 0, patch.origin.x, patch.spacing);
    const AxisOfNodes y = axis_of(grid, 1, patch.origin.y, patch.spacing);
    const AxisOfNodes z = axis_of(grid, 2, patch.origin.z, patch.spacing);
    std::size_t node = 0;
    for (const Between& k : z) {
        for (const Between& j : y) {
            const double ll = (1 - k.t) * (1 - j.t), lh = (1 - k.t) * j.t;
            const double hl = k.t * (1 - j.t), hh = k.t * j.t;
            const T *row_ll = first + (k.low + j.low), *row_lh = first + (k.low + j.high);
            const T *row_hl = first + (k.high + j.low), *row_hh = first + (k.high + j.high);
            const auto across = [&](std::ptrdiff_t i) {
                return (ll * row_ll[i] + lh * row_lh[i]) + (hl * row_hl[i] + hh * row_hh[i]);
            };
            for (const Between& i : x)
                values[node++] += weight * ((1 - i.t) * across(i.low) + i.t * across(i.high));
        }
    }
}

void add_at_nodes(const field::Grid& grid, const FlowPatch& patch, double weight, NodeValues& values) {
    if (!has_samples(grid) || weight == 0) return;
    grid.with_samples([&](const auto* first) { add_at_nodes(grid, first, patch, weight, values); });
}

struct Mixture {
    NodeValues viscosity{}, density{};
};

Mixture mixture_of(const FlowSource& source, const FlowPatch& patch) {
    Mixture mix;
    mix.viscosity.fill(source.viscosity);
    mix.density.fill(source.density);
    for (const FlowSubstance& substance : source.substances) {
        if (!has_samples(substance.amount)) continue;
        NodeValues amount{};
        add_at_nodes(substance.amount, patch, 1, amount);
        for (std::size_t n = 0; n < node_count; ++n) {
            mix.viscosity[n] += substance.viscosity * amount[n];
            mix.density[n] += substance.density * amount[n];
        }
    }
    return mix;
}

/// Position of a place between the patch's nodes along one axis: index of the node below, and fraction of the
/// distance from there to the next node.
struct Along {
    std::size_t low;
    double t;
};

Along along(double at) {
    const double x = std::clamp(at, 0.0, flow_nodes - 1.0);
    const int low = std::min(static_cast<int>(x), flow_nodes - 2);
    return {static_cast<std::size_t>(low), x - low};
}

}  // namespace

FlowSample flow_at(const FlowPatch& patch, vec3 place) noexcept {
    if (!(patch.spacing > 0) || !is_finite(place)) return {};
    const vec3 at = (place - patch.origin) / patch.spacing;
    if (!is_finite(at)) return {};
    const Along x = along(at.x), y = along(at.y), z = along(at.z);
    FlowSample sum;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t i = corner & 1U, j = corner >> 1U & 1U, k = corner >> 2U;
        const double weight = (i != 0 ? x.t : 1 - x.t) * (j != 0 ? y.t : 1 - y.t) * (k != 0 ? z.t : 1 - z.t);
        const FlowNode& node =
            patch.nodes[(x.low + i) + flow_nodes * ((y.low + j) + flow_nodes * (z.low + k))];
        sum.velocity += weight * vec3(node.velocity);
        sum.viscosity += weight * static_cast<double>(node.viscosity);
        sum.density += weight * static_cast<double>(node.density);
    }
    return sum;
}

FlowPatch patch_of(const FlowSource& source, vec3 middle) noexcept {
    const field::Grid& lattice = source.velocity.component[0];
    FlowPatch patch;
    if (!has_samples(lattice) || !is_finite(middle)) return patch;
    patch.spacing = std::min({lattice.spacing.x, lattice.spacing.y, lattice.spacing.z});
    const vec3 cell = glm::floor((middle - lattice.origin) / patch.spacing);
    patch.origin = lattice.origin + patch.spacing * (cell - vec3(1));
    if (!is_finite(patch.origin)) return {};
    std::array<NodeValues, 3> velocity{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        add_at_nodes(source.velocity.component[axis], patch, 1, velocity[axis]);
    const Mixture mix = mixture_of(source, patch);
    for (std::size_t n = 0; n < node_count; ++n) {
        patch.nodes[n] = {.velocity = {velocity[0][n], velocity[1][n], velocity[2][n]},
                          .viscosity = static_cast<float>(std::max(0.0, mix.viscosity[n])),
                          .density = static_cast<float>(std::max(0.0, mix.density[n]))};
    }
    return patch;
}

}  // namespace thaum::haptics
