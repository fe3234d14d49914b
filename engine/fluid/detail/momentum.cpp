#include "fluid/detail/momentum.h"

#include <algorithm>
#include <type_traits>

#include "fluid/floats8.h"

namespace thaum::fluid {
/// Factors of the sums of fluxes and of viscous stresses. Not in the unnamed namespace, because a lambda in a
/// member function captures them.
struct FluxFactors {
    float flux, spread;
};

namespace {

/// Interpolates the velocity that carries the momentum half-way between a sample and the previous one, `step`
/// away, at order 4. The result is 16 / 9 times that velocity, which saves multiplications here; later
/// factors remove the 16 / 9.
void interpolate_row(const float* u, std::ptrdiff_t step, std::ptrdiff_t count, float* out) {
    for (std::ptrdiff_t i = 0; i < count; i += 8)
        store(out + i, (load(u + i - step) + load(u + i)) -
                           (1.0F / 9) * (load(u + i - 2 * step) + load(u + i + step)));
}

/// Four neighbouring rows of the velocity that carries a row of values (the advecting velocity): one beyond
/// the row's low side, one on its low side, one on its high side and one beyond its high side.
struct CarryingRows {
    const float* before;
    const float* low;
    const float* high;
    const float* after;
    std::ptrdiff_t step;  ///< index distance between advected neighbours along this axis

    /// Flux out of eight samples to the next ones minus flux into them from the previous ones, at order 4, by
    /// the formula in momentum.h, multiplied by a common factor. q are the advected values. The sum of 30 T
    /// (the advecting velocity) and its two neighbours is 32 times T + delta2(T) / 32.
    Floats8 flux(const float* q, std::ptrdiff_t i) const {
        const Floats8 b = load(before + i), l = load(low + i), h = load(high + i), a = load(after + i);
        const Floats8 near = (30.0F * h + (a + l)) * load(q + step) - (30.0F * l + (h + b)) * load(q - step);
        const Floats8 far = (h + a) * load(q + 2 * step) - (l + b) * load(q - 2 * step);
        return near - (far + far);
    }
};

/// A row of the advecting velocity at order 2, which needs so few of its samples that they are interpolated
/// where they are used.
struct CarryingSamples {
    const float* velocity;
    std::ptrdiff_t back;  ///< index distance between the two samples that are interpolated
    std::ptrdiff_t step;  ///< index distance between advected neighbours along this axis

    /// Advecting velocity half-way between each of eight carried values and the previous one, times 2.
    Floats8 twice(std::ptrdiff_t i) const { return load(velocity + i - back) + load(velocity + i); }
    /// Flux out of eight samples to the next ones minus flux into them from the previous ones, times 4.
    Floats8 flux(const float* q, std::ptrdiff_t i) const {
        return twice(i + step) * load(q + step) - twice(i) * load(q - step);
    }
};

inline Floats8 sum_of_both_sides(const float* q, std::ptrdiff_t step) {
    return load(q - step) + load(q + step);
}

template <bool fourth>
FluxFactors flux_factors(float h, float viscosity) {
    return {-(fourth ? 9.0F / 768 : 0.25F) / h, viscosity / (h * h) / (fourth ? 12 : 1)};
}

/// Rate of change of eight samples of q by advection along the axes a, b and c, and by viscosity. The first
/// axis is added to the sum of the other two, so exchanging those two changes no bit of the result.
template <bool viscous, class Carrying>
inline Floats8 rate_at(const Carrying& a, const Carrying& b, const Carrying& c, const float* q,
                       std::ptrdiff_t i, const FluxFactors& factors) {
    constexpr bool fourth = std::is_same_v<Carrying, CarryingRows>;
    Floats8 sum = factors.flux * (a.flux(q, i) + (b.flux(q, i) + c.flux(q, i)));
    if constexpr (viscous) {
        const Floats8 ones =
            sum_of_both_sides(q, a.step) + (sum_of_both_sides(q, b.step) + sum_of_both_sides(q, c.step));
        if constexpr (fourth) {
            const Floats8 twos = sum_of_both_sides(q, 2 * a.step) +
                                 (sum_of_both_sides(q, 2 * b.step) + sum_of_both_sides(q, 2 * c.step));
            // In units of 1/12, the factors of this sum of second differences are 16, 1 and 90, which float
            // represents exactly. So viscosity keeps the momentum: what leaves one sample enters its
            // neighbours.
            sum += factors.spread * ((16.0F * ones - twos) - 90.0F * load(q));
        } else {
            sum += factors.spread * (ones - 6.0F * load(q));
        }
    }
    return sum;
}

/// Input and output arrays of a Runge-Kutta stage, at one row of samples.
struct RowTargets {
    const float* start;
    const float* before;  ///< sum of the earlier stages; in the first stage, velocity at the start (m/s)
    const float* force;   ///< acceleration by forces; null: no force
    const float* open;    ///< shares of the faces that no solid covers; null: all are open
    float* sum;
    float* next;  ///< velocity for the next stage; null in the last stage
};

template <bool viscous, class Carrying>
[[gnu::always_inline]] inline void take_row(const Carrying& a, const Carrying& b, const Carrying& c,
                                            const float* q, std::ptrdiff_t count, const FluxFactors& factors,
                                            const RowTargets& row, float sum_part, float next_part) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        Floats8 rate = rate_at<viscous>(a, b, c, q + i, i, factors);
        if (row.force != nullptr) rate += load(row.force + i);
        const auto keep = [&](const Floats8& value) {
            return row.open == nullptr ? value : load(row.open + i) > zero8 ? value : zero8;
        };
        store(row.sum + i, keep(load(row.before + i) + sum_part * rate));
        if (row.next != nullptr) store(row.next + i, keep(load(row.start + i) + next_part * rate));
    }
}

/// Index of a sample in a plane of the advecting velocity.
inline std::ptrdiff_t place_in_plane(const Lattice& lattice, int i, int j) {
    return (j + ghosts) * lattice.stride[1] + i + ghosts;
}

/// Index of the plane that holds the advecting velocity along z at layer k. Four planes take turns (ring
/// buffer).
inline std::size_t plane_along_z(int k) { return 2 + static_cast<std::size_t>(k + 1) % 4; }

/// Rows of the advecting velocity (which carries the momentum) along x, y and z around the row that starts at
/// `place` in layer k.
[[gnu::always_inline]] inline std::array<CarryingRows, 3> carrying_rows(const std::array<Samples, 6>& planes,
                                                                        const Lattice& lattice,
                                                                        std::ptrdiff_t place, int k) {
    const auto& stride = lattice.stride;
    const float* x = planes[0].data() + place;
    const float* y = planes[1].data() + place;
    const auto z = [&](int layer) { return planes[plane_along_z(layer)].data() + place; };
    return {CarryingRows{x - 1, x, x + 1, x + 2, 1},
            CarryingRows{y - stride[1], y, y + stride[1], y + 2 * stride[1], stride[1]},
            CarryingRows{z(k - 1), z(k), z(k + 1), z(k + 2), stride[2]}};
}

/// The arrays that a Runge-Kutta stage reads and writes for one component of the velocity, from index `at`
/// on.
[[gnu::always_inline]] inline RowTargets row_targets(const RungeKuttaStage& stage, const Solids* solids,
                                                     std::size_t axis, std::ptrdiff_t at) {
    return {.start = stage.start[axis].data() + at,
            .before = (stage.first ? stage.start : stage.sum)[axis].data() + at,
            .force = stage.force != nullptr ? (*stage.force)[axis].data() + at : nullptr,
            .open = solids != nullptr ? solids->open()[axis].data() + at : nullptr,
            .sum = stage.sum[axis].data() + at,
            .next = stage.next != nullptr ? (*stage.next)[axis].data() + at : nullptr};
}

}  // namespace

Momentum::Momentum(const Lattice& lattice, int order, const Solids* solids)
    : lattice_(lattice),
      order_(order),
      solids_(solids),
      rows_(solids != nullptr ? solids->rows() : whole_rows(lattice)) {
    for (auto& planes : planes_)
        for (auto& plane : planes)
            plane.resize(order == 4 ? static_cast<std::size_t>(lattice.stride[2]) + 8 : 0);
    for (int k = 0; k < lattice.cells[2]; ++k) layer_bounds_.push_back(bounds_of_layer(k));
}

Momentum::LayerBounds Momentum::bounds_of_layer(int k) const {
    LayerBounds bounds{.first = lattice_.cells[1], .end = 0, .start = lattice_.cells[0], .count = 0};
    std::ptrdiff_t end = 0;
    for (int j = 0; j < lattice_.cells[1]; ++j) {
        const Row row = rows_.at(j, k);
        if (row.count == 0) continue;
        const auto start = row.at - lattice_.at(0, j, k);
        bounds.first = std::min(bounds.first, j);
        bounds.end = j + 1;
        bounds.start = std::min(bounds.start, start);
        end = std::max(end, start + row.count);
    }
    bounds.count = std::max(std::ptrdiff_t{0}, end - bounds.start);
    return bounds;
}

/// Interpolates the advecting velocity (which carries the momentum) along z on the low faces of layer k, for
/// all its rows.
void Momentum::interpolate_between_layers(const Samples& velocity_z, std::ptrdiff_t step, int k,
                                          Planes& planes) {
    float* plane = planes[plane_along_z(k)].data();
    for (int j = 0; j < lattice_.cells[1]; ++j)
        interpolate_row(velocity_z.data() + lattice_.at(0, j, k), step, lattice_.cells[0],
                        plane + place_in_plane(lattice_, 0, j));
}

/// Interpolates the advecting velocities along x and y for the part of layer k that contains all its fluid.
void Momentum::interpolate_in_layer(const std::array<Samples, 3>& velocity, std::ptrdiff_t step, int k,
                                    Planes& planes) {
    const LayerBounds& bounds = layer_bounds_[static_cast<std::size_t>(k)];
    const auto start = static_cast<int>(bounds.start);
    for (int j = bounds.first; j < bounds.end; ++j)
        interpolate_row(velocity[0].data() + lattice_.at(start - 1, j, k), step,
                        round_up_to_8(bounds.count + 3),
                        planes[0].data() + place_in_plane(lattice_, start - 1, j));
    for (int j = bounds.first - 1; j < bounds.end + 2; ++j)
        interpolate_row(velocity[1].data() + lattice_.at(start, j, k), step, bounds.count,
                        planes[1].data() + place_in_plane(lattice_, start, j));
}

template <bool viscous, std::size_t axis>
void Momentum::component_of_fourth(const RungeKuttaStage& stage, float viscosity, Layers layers,
                                   Planes& planes) {
    const auto step = lattice_.stride[axis];
    const auto factors = flux_factors<true>(static_cast<float>(lattice_.h), viscosity);
    for (int k = layers.first - 1; k < layers.first + 2; ++k)
        interpolate_between_layers(stage.from[2], step, k, planes);
    for (int k = layers.first; k < layers.end; ++k) {
        interpolate_between_layers(stage.from[2], step, k + 2, planes);
        const LayerBounds& bounds = layer_bounds_[static_cast<std::size_t>(k)];
        if (bounds.count == 0) continue;
        interpolate_in_layer(stage.from, step, k, planes);
        for (int j = bounds.first; j < bounds.end; ++j) {
            const Row row = rows_.at(j, k);
            const auto i = static_cast<int>(row.at - lattice_.at(0, j, k));
            const auto by = carrying_rows(planes, lattice_, place_in_plane(lattice_, i, j), k);
            take_row<viscous>(by[axis], by[(axis + 1) % 3], by[(axis + 2) % 3],
                              stage.from[axis].data() + row.at, row.count, factors,
                              row_targets(stage, solids_, axis, row.at), stage.sum_part, stage.next_part);
        }
    }
}

template <bool viscous, std::size_t axis>
void Momentum::component_of_second(const RungeKuttaStage& stage, float viscosity, Layers layers) {
    const auto factors = flux_factors<false>(static_cast<float>(lattice_.h), viscosity);
    each_row(rows_, layers, [&](Row row) {
        const auto by = [&](std::size_t along) {
            return CarryingSamples{stage.from[along].data() + row.at, lattice_.stride[axis],
                                   lattice_.stride[along]};
        };
        take_row<viscous>(by(axis), by((axis + 1) % 3), by((axis + 2) % 3), stage.from[axis].data() + row.at,
                          row.count, factors, row_targets(stage, solids_, axis, row.at), stage.sum_part,
                          stage.next_part);
    });
}

template <bool fourth, bool viscous>
void Momentum::components(const RungeKuttaStage& stage, float viscosity, Layers layers, Planes& planes) {
    if constexpr (fourth) {
        component_of_fourth<viscous, 0>(stage, viscosity, layers, planes);
        component_of_fourth<viscous, 1>(stage, viscosity, layers, planes);
        component_of_fourth<viscous, 2>(stage, viscosity, layers, planes);
    } else {
        component_of_second<viscous, 0>(stage, viscosity, layers);
        component_of_second<viscous, 1>(stage, viscosity, layers);
        component_of_second<viscous, 2>(stage, viscosity, layers);
    }
}

void Momentum::run_stage(const RungeKuttaStage& stage, double viscosity, Layers layers, unsigned seat) {
    const auto nu = static_cast<float>(viscosity);
    Planes& planes = planes_[seat];
    if (order_ == 4)
        nu > 0 ? components<true, true>(stage, nu, layers, planes)
               : components<true, false>(stage, nu, layers, planes);
    else
        nu > 0 ? components<false, true>(stage, nu, layers, planes)
               : components<false, false>(stage, nu, layers, planes);
}

}  // namespace thaum::fluid
