#include "field/field.h"

#include <algorithm>

namespace thaum::field {
namespace {

/// A position between the first and the last sample along an axis, counted in samples.
struct Cell {
    int low{};   ///< number of the sample at or below the position
    double t{};  ///< distance from that sample, within [0, 1]
};

Cell cell_at(double x, int count) {
    x = std::clamp(x, 0.0, static_cast<double>(count - 1));
    const int low = std::min(static_cast<int>(x), count - 2);
    return {low, x - low};
}

/// Up to four samples along an axis (taps of the kernel), with their weights for the value and the slope.
struct Taps {
    std::array<std::ptrdiff_t, 4> offset{};
    std::array<double, 4> value{}, slope{};
    std::size_t count{};
};

/// Weights of the samples at -1, 0, 1 and 2, for a position t within [0, 1].
struct Weights {
    std::array<double, 4> value, slope;
};

Weights catmull_rom(double t) {
    const double t2 = t * t, t3 = t2 * t;
    return {
        {0.5 * (2 * t2 - t - t3), 0.5 * (3 * t3 - 5 * t2 + 2), 0.5 * (t + 4 * t2 - 3 * t3), 0.5 * (t3 - t2)},
        {0.5 * (4 * t - 1 - 3 * t2), 0.5 * (9 * t2 - 10 * t), 0.5 * (1 + 8 * t - 9 * t2),
         0.5 * (3 * t2 - 2 * t)}};
}

/// Replaces the tap `from`, a place outside the samples, by extrapolation: its weights go to the next three
/// taps, in the order `to`, as a parabola through them requires.
void fold(Taps& taps, std::size_t from, std::array<std::size_t, 3> to) {
    constexpr std::array<double, 3> parabola{3, -3, 1};
    for (std::size_t i = 0; i < 3; ++i) {
        taps.value[to[i]] += parabola[i] * taps.value[from];
        taps.slope[to[i]] += parabola[i] * taps.slope[from];
    }
    taps.value[from] = taps.slope[from] = 0;
    taps.offset[from] = taps.offset[to[0]];
}

/// Computes the taps (samples with weights) for a place x, counted in samples from the first one. `per_metre`
/// is the sample density (1/m).
Taps taps_at(double x, int count, std::ptrdiff_t stride, double per_metre, Kernel kernel) {
    Taps taps;
    if (count == 1) {
        taps.count = 1;
        taps.value[0] = 1;
        return taps;
    }
    const auto [low, t] = cell_at(x, count);
    if (kernel == Kernel::linear || count == 2) {
        taps.count = 2;
        taps.offset = {low * stride, (low + 1) * stride};
        taps.value = {1 - t, t};
        taps.slope = {-per_metre, per_metre};
        return taps;
    }
    const Weights weights = catmull_rom(t);
    taps.count = 4;
    for (std::size_t i = 0; i < 4; ++i) {
        taps.offset[i] = (low - 1 + static_cast<int>(i)) * stride;
        taps.value[i] = weights.value[i];
        taps.slope[i] = weights.slope[i] * per_metre;
    }
    const bool low_edge = low == 0, high_edge = low == count - 2;
    // At most one of these applies: even in a grid of three samples, no cell touches both ends.
    if (low_edge) fold(taps, 0, {1, 2, 3});
    if (high_edge) fold(taps, 3, {2, 1, 0});
    return taps;
}

/// Value between the eight samples around `at`, which is counted in samples. Adds in the same order as
/// Grid::operator(), so that both give the same bits. Needs two samples along each axis.
template <class T>
double trilinear(const Grid& grid, const T* first, vec3 at) {
    const Cell x = cell_at(at.x, grid.count[0]), y = cell_at(at.y, grid.count[1]);
    const Cell z = cell_at(at.z, grid.count[2]);
    const T* low = first + (z.low * grid.stride[2] + y.low * grid.stride[1] + x.low * grid.stride[0]);
    const T* high = low + grid.stride[2];
    const double base = *low;
    const auto along = [&](const T* row) {
        return (1 - x.t) * (row[0] - base) + x.t * (row[grid.stride[0]] - base);
    };
    const auto across = [&](const T* plane) {
        return (1 - y.t) * along(plane) + y.t * along(plane + grid.stride[1]);
    };
    return base + ((1 - z.t) * across(low) + z.t * across(high));
}

/// A reference sample of the cell. Kernels are applied to differences from it. Where all samples are equal,
/// value and gradient are therefore exact. With rounding noise the gradient of a uniform region would have a
/// direction that jumps, which a hand that feels the field would notice.
template <class T>
double base_of(const T* first, const Taps& x, const Taps& y, const Taps& z) {
    return first[x.offset[x.count / 4] + y.offset[y.count / 4] + z.offset[z.count / 4]];
}

bool can_read(const Grid& grid, vec3 place) { return grid.has_samples() && is_finite(place); }

template <class T>
double weighted_value(const T* first, const Taps& x, const Taps& y, const Taps& z) {
    const double base = base_of(first, x, y, z);
    double result = 0;
    for (std::size_t k = 0; k < z.count; ++k) {
        double across = 0;
        for (std::size_t j = 0; j < y.count; ++j) {
            const T* row = first + (z.offset[k] + y.offset[j]);
            double along = 0;
            for (std::size_t i = 0; i < x.count; ++i) along += x.value[i] * (row[x.offset[i]] - base);
            across += y.value[j] * along;
        }
        result += z.value[k] * across;
    }
    return base + result;
}

template <class T>
Scalar weighted_scalar(const T* first, const Taps& x, const Taps& y, const Taps& z) {
    const double base = base_of(first, x, y, z);
    Scalar result;
    for (std::size_t k = 0; k < z.count; ++k) {
        double value = 0, across_x = 0, across_y = 0;
        for (std::size_t j = 0; j < y.count; ++j) {
            const T* row = first + (z.offset[k] + y.offset[j]);
            double along = 0, slope = 0;
            for (std::size_t i = 0; i < x.count; ++i) {
                const double sample = row[x.offset[i]] - base;
                along += x.value[i] * sample;
                slope += x.slope[i] * sample;
            }
            value += y.value[j] * along;
            across_x += y.value[j] * slope;
            across_y += y.slope[j] * along;
        }
        result.value += z.value[k] * value;
        result.gradient += vec3(z.value[k] * across_x, z.value[k] * across_y, z.slope[k] * value);
    }
    result.value += base;
    return result;
}

}  // namespace

double Grid::linear_value(double x, double y, double z) const {
    return with_samples([&](const auto* samples) { return trilinear(*this, samples, {x, y, z}); });
}

double Grid::value_at(double x_m, double y_m, double z_m) const {
    const vec3 place(x_m, y_m, z_m);
    if (!can_read(*this, place)) return 0;
    const vec3 at = (place - origin) / spacing;
    if (kernel == Kernel::linear && *std::ranges::min_element(count) >= 2)
        return with_samples([&](const auto* samples) { return trilinear(*this, samples, at); });
    const Taps x = taps_at(at.x, count[0], stride[0], 1, kernel);
    const Taps y = taps_at(at.y, count[1], stride[1], 1, kernel);
    const Taps z = taps_at(at.z, count[2], stride[2], 1, kernel);
    return with_samples([&](const auto* samples) { return weighted_value(samples, x, y, z); });
}

Scalar Grid::scalar_at(double x_m, double y_m, double z_m) const {
    const vec3 place(x_m, y_m, z_m);
    if (!can_read(*this, place)) return {};
    const vec3 at = (place - origin) / spacing;
    const vec3 per_metre = 1.0 / spacing;
    const Taps x = taps_at(at.x, count[0], stride[0], per_metre.x, kernel);
    const Taps y = taps_at(at.y, count[1], stride[1], per_metre.y, kernel);
    const Taps z = taps_at(at.z, count[2], stride[2], per_metre.z, kernel);
    return with_samples([&](const auto* samples) { return weighted_scalar(samples, x, y, z); });
}

Vector StaggeredGrid::operator()(vec3 place) const {
    Vector result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Scalar one = component[axis](place);
        result.value[static_cast<int>(axis)] = one.value;
        result.gradient[axis] = one.gradient;
    }
    return result;
}

}  // namespace thaum::field
