#include "fluid/momentum.h"

#include <algorithm>

#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

/// Interpolates the advecting velocity between a sample and the previous one, `step` away. The result
/// is multiplied by 16 / 9 at order 4 and by 2 at order 2.
template <bool fourth>
void interpolate_row(const float* u, std::ptrdiff_t step, std::ptrdiff_t count, float* out) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        Floats8 sum = load(u + i - step) + load(u + i);
        if constexpr (fourth) sum -= (1.0F / 9) * (load(u + i - 2 * step) + load(u + i + step));
        store(out + i, sum);
    }
}

/// Rows of the advecting velocity around a row of advected values: the previous row, the low side, the
/// high side, the next row.
struct CarryingRows {
    const float* before;
    const float* low;
    const float* high;
    const float* after;
    std::ptrdiff_t step;  ///< index distance between advected neighbours along this axis
};

/// Flux to the next samples minus flux from the previous ones.
inline Floats8 near_flux(const CarryingRows& by, const float* q, std::ptrdiff_t i) {
    return load(by.high + i) * load(q + by.step) - load(by.low + i) * load(q - by.step);
}
inline Floats8 far_flux(const CarryingRows& by, const float* q, std::ptrdiff_t i) {
    return load(by.after + i) * load(q + 3 * by.step) - load(by.before + i) * load(q - 3 * by.step);
}
inline Floats8 sum_of_both_sides(const float* q, std::ptrdiff_t step) {
    return load(q - step) + load(q + step);
}

struct FluxFactors {
    float near, far, spread;
};

/// The first axis is added to the sum of the other two, so exchanging those two changes no bit.
template <bool fourth, bool viscous>
inline Floats8 rate_at(const CarryingRows& a, const CarryingRows& b, const CarryingRows& c, const float* q,
                       std::ptrdiff_t i, const FluxFactors& factors) {
    Floats8 sum = factors.near * (near_flux(a, q, i) + (near_flux(b, q, i) + near_flux(c, q, i)));
    if constexpr (fourth) sum += factors.far * (far_flux(a, q, i) + (far_flux(b, q, i) + far_flux(c, q, i)));
    if constexpr (viscous) {
        const Floats8 ones =
            sum_of_both_sides(q, a.step) + (sum_of_both_sides(q, b.step) + sum_of_both_sides(q, c.step));
        if constexpr (fourth) {
            const Floats8 twos = sum_of_both_sides(q, 2 * a.step) +
                                 (sum_of_both_sides(q, 2 * b.step) + sum_of_both_sides(q, 2 * c.step));
            // The factors are integers (twelfths), which float holds exactly, so what leaves one sample
            // enters the others.
            sum += factors.spread * ((16.0F * ones - twos) - 90.0F * load(q));
        } else {
            sum += factors.spread * (ones - 6.0F * load(q));
        }
    }
    return sum;
}

/// Input and output arrays of one row.
struct RowTargets {
    const float* start;
    const float* before;  ///< sum of the earlier stages
    const float* force;   ///< null: no force
    const float* open;    ///< open shares of faces; null: all are open
    float* sum;
    float* next;  ///< null in the last stage
};

template <bool fourth, bool viscous>
[[gnu::always_inline]] inline void take_row(const CarryingRows& a, const CarryingRows& b,
                                            const CarryingRows& c, const float* q, std::ptrdiff_t count,
                                            const FluxFactors& factors, const RowTargets& row, float sum_part,
                                            float next_part) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        Floats8 rate = rate_at<fourth, viscous>(a, b, c, q + i, i, factors);
        if (row.force != nullptr) rate += load(row.force + i);
        const auto keep = [&](const Floats8& value) {
            return row.open == nullptr ? value : load(row.open + i) > zero8 ? value : zero8;
        };
        store(row.sum + i, keep(load(row.before + i) + sum_part * rate));
        if (row.next != nullptr) store(row.next + i, keep(load(row.start + i) + next_part * rate));
    }
}

}  // namespace

Momentum::Momentum(const Lattice& lattice, int order, const Solids* solids)
    : lattice_(lattice),
      order_(order),
      solids_(solids),
      rows_(solids != nullptr ? solids->rows() : whole_rows(lattice)) {
    for (auto& plane : planes_) plane.resize(static_cast<std::size_t>(lattice.stride[2]) + 8);
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

template <bool fourth, bool viscous, std::size_t axis>
void Momentum::component(const RungeKuttaStage& stage, float viscosity) {
    const int nx = lattice_.cells[0];
    const int ny = lattice_.cells[1];
    const int nz = lattice_.cells[2];
    const auto& stride = lattice_.stride;
    const auto along = stride[axis];
    const auto h = static_cast<float>(lattice_.h);
    const FluxFactors factors{-(fourth ? 81.0F / 256 : 0.25F) / h, 9.0F / 768 / h,
                              viscosity / (h * h) / (fourth ? 12 : 1)};
    const auto in_plane = [&](int i, int j) { return (j + ghosts) * stride[1] + i + ghosts; };
    const auto ring = [&](int k) { return planes_[2 + static_cast<std::size_t>(k + 1) % 4].data(); };
    const auto lift = [&](int k) {
        for (int j = 0; j < ny; ++j)
            interpolate_row<fourth>(stage.from[2].data() + lattice_.at(0, j, k), along, nx,
                                    ring(k) + in_plane(0, j));
    };
    for (int k = -1; k < 2; ++k) lift(k);
    for (int k = 0; k < nz; ++k) {
        lift(k + 2);
        const LayerBounds& bounds = layer_bounds_[static_cast<std::size_t>(k)];
        if (bounds.count == 0) continue;
        const auto start = static_cast<int>(bounds.start);
        for (int j = bounds.first; j < bounds.end; ++j)
            interpolate_row<fourth>(stage.from[0].data() + lattice_.at(start - 1, j, k), along,
                                    round_up_to_8(bounds.count + 3),
                                    planes_[0].data() + in_plane(start - 1, j));
        for (int j = bounds.first - 1; j < bounds.end + 2; ++j)
            interpolate_row<fourth>(stage.from[1].data() + lattice_.at(start, j, k), along, bounds.count,
                                    planes_[1].data() + in_plane(start, j));
        for (int j = bounds.first; j < bounds.end; ++j) {
            const std::ptrdiff_t at = rows_.at(j, k).at, count = rows_.at(j, k).count;
            const auto here = in_plane(static_cast<int>(at - lattice_.at(0, j, k)), j);
            const float* x = planes_[0].data() + here;
            const float* y = planes_[1].data() + here;
            const std::array<CarryingRows, 3> by{
                CarryingRows{x - 1, x, x + 1, x + 2, 1},
                CarryingRows{y - stride[1], y, y + stride[1], y + 2 * stride[1], stride[1]},
                CarryingRows{ring(k - 1) + here, ring(k) + here, ring(k + 1) + here, ring(k + 2) + here,
                             stride[2]}};
            const RowTargets row{.start = stage.start[axis].data() + at,
                                 .before = (stage.first ? stage.start : stage.sum)[axis].data() + at,
                                 .force = stage.force != nullptr ? (*stage.force)[axis].data() + at : nullptr,
                                 .open = solids_ != nullptr ? solids_->open()[axis].data() + at : nullptr,
                                 .sum = stage.sum[axis].data() + at,
                                 .next = stage.next != nullptr ? (*stage.next)[axis].data() + at : nullptr};
            take_row<fourth, viscous>(by[axis], by[(axis + 1) % 3], by[(axis + 2) % 3],
                                      stage.from[axis].data() + at, count, factors, row, stage.sum_part,
                                      stage.next_part);
        }
    }
}

template <bool fourth, bool viscous>
void Momentum::components(const RungeKuttaStage& stage, float viscosity) {
    component<fourth, viscous, 0>(stage, viscosity);
    component<fourth, viscous, 1>(stage, viscosity);
    component<fourth, viscous, 2>(stage, viscosity);
}

void Momentum::run_stage(const RungeKuttaStage& stage, double viscosity) {
    const auto nu = static_cast<float>(viscosity);
    if (order_ == 4)
        nu > 0 ? components<true, true>(stage, nu) : components<true, false>(stage, nu);
    else
        nu > 0 ? components<false, true>(stage, nu) : components<false, false>(stage, nu);
}

}  // namespace thaum::fluid
