#include "field/detail/carving_extent.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/doubles4.h"
#include "core/exp8.h"

namespace thaum::field {
namespace {

constexpr double bell_exponent = 4.5;  // makes the radius three standard deviations of the bell
constexpr double rim_voxels = 2;
constexpr double min_weight = 1e-9;

bool is_round(ExtentShape shape) { return shape == ExtentShape::sphere || shape == ExtentShape::gaussian; }

/// Distance beyond each half edge of the shape within which a voxel may still have a weight above 0, in the
/// extent's unit (voxels or m).
vec3 margin_of(const Footprint& f) {
    if (f.shape == ExtentShape::gaussian) return vec3(0);
    if (f.shape != ExtentShape::stamp) return vec3(f.rim / 2);
    return f.half / vec3(f.stamp->cells[0], f.stamp->cells[1], f.stamp->cells[2]);
}

/// Box of those voxels of the body that the shape may reach. Numbers are clamped before they become integers,
/// because the conversion of one beyond the range of int is undefined.
VoxelBox box_of(const Footprint& f, const VoxelBox& all) {
    // The limit keeps `reach` finite, because an infinite one times a turn would give NaN.
    vec3 reach = glm::min(f.half + margin_of(f), vec3(1e300));
    if (!is_round(f.shape)) {
        const mat3 size(glm::abs(f.turn[0]), glm::abs(f.turn[1]), glm::abs(f.turn[2]));
        reach = size * reach;
    }
    VoxelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        const double voxels = reach[a] / f.step[a], end = all.high[axis];
        box.low[axis] = static_cast<int>(std::clamp(std::ceil(f.centre[a] - voxels), 0.0, end));
        box.high[axis] = static_cast<int>(std::clamp(std::floor(f.centre[a] + voxels) + 1, 0.0, end));
    }
    return box.empty() ? VoxelBox{} : box;
}

/// A weight within [0, 1]. Weights that rounding leaves almost 0 or almost 1 are set to that, because they
/// would leave a trace of density after a cut.
double clean(double weight) {
    if (weight < min_weight) return 0;
    return weight > 1 - min_weight ? 1 : weight;
}

/// Weight of a voxel at the depth `inside` behind an edge of the shape (the extent's unit; negative outside):
/// it falls from 1 to 0 over the width `rim`.
double coverage(double inside, double rim) { return clean(0.5 + inside / rim); }

double box_weight(const Footprint& f, vec3 local) {
    const vec3 inside = f.half - glm::abs(local);
    return coverage(inside.x, f.rim) * coverage(inside.y, f.rim) * coverage(inside.z, f.rim);
}

double cell_weight(const Stamp& stamp, std::array<int, 3> cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (cell[axis] < 0 || cell[axis] >= stamp.cells[axis]) return 0;
    }
    const int at = cell[0] + stamp.cells[0] * (cell[1] + stamp.cells[1] * cell[2]);
    return static_cast<double>(stamp.weight[static_cast<std::size_t>(at)]);
}

/// Weight at a place in a stamp (a body of cells): trilinear between the centres of the cells, 0 beyond them.
double stamp_weight(const Footprint& f, vec3 local) {
    const Stamp& stamp = *f.stamp;
    const vec3 cells(stamp.cells[0], stamp.cells[1], stamp.cells[2]);
    const vec3 at = (local / f.half + 1.0) * (0.5 * cells) - 0.5;
    const vec3 low = glm::floor(glm::clamp(at, vec3(-1), cells)), part = at - low;
    const std::array cell{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(low.z)};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
        const double w =
            (x == 1 ? part.x : 1 - part.x) * (y == 1 ? part.y : 1 - part.y) * (z == 1 ? part.z : 1 - part.z);
        sum += w * cell_weight(stamp, {cell[0] + x, cell[1] + y, cell[2] + z});
    }
    return clean(sum);
}

/// Coordinates of the voxels of a part along each axis, from the shape's centre; 0 beyond the end of the
/// part.
std::array<BrickAxis, 3> along_axes(const Footprint& f, const VoxelBox& part) {
    std::array<BrickAxis, 3> axes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis), first = part.low[axis];
        for (int i = first; i < part.high[axis]; ++i)
            axes[axis][static_cast<std::size_t>(i - first)] = (i - f.centre[a]) * f.step[a];
    }
    return axes;
}

/// Sets the weight of each voxel of a part to weight(x, y, z), where x, y and z are its coordinates in
/// `axes`. Returns the number of weights.
template <class Weight>
std::size_t combine(const std::array<BrickAxis, 3>& axes, const VoxelBox& part, PartWeights& weights,
                    Weight weight) {
    const auto size = [&](std::size_t axis) {
        return static_cast<std::size_t>(part.high[axis] - part.low[axis]);
    };
    const std::size_t width = size(0);
    std::size_t at = 0;
    for (std::size_t k = 0; k < size(2); ++k) {
        for (std::size_t j = 0; j < size(1); ++j, at += brick_size) {
            for (std::size_t i = 0; i < brick_size; ++i)
                weights[at + i] = i < width ? weight(axes[0][i], axes[1][j], axes[2][k]) : 0;
        }
    }
    return at;
}

/// Sixteen numbers. Each step of a series waits for the one before, so four vectors take hardly longer than
/// one.
using Sixteen = std::array<Doubles4, 4>;

/// exp(x) for -max_amount <= x <= 0: x = n log 2 + r, and a Taylor series in Horner's form for exp(r).
Sixteen falling_exp(const Sixteen& x) {
    constexpr double log_2_high = 0x1.62e42fee00000p-1, log_2_low = 0x1.a39ef35793c76p-33;
    constexpr double per_log_2 = 1.4426950408889634,
                     whole = 0x1.8p52;  // adding and subtracting `whole` rounds to an integer
    Sixteen rounded, r, series;
    for (std::size_t i = 0; i < 4; ++i) {
        rounded[i] = x[i] * per_log_2 + whole;
        const Doubles4 n = rounded[i] - whole;
        r[i] = (x[i] - n * log_2_high) - n * log_2_low;
        series[i] = 1.0 + r[i] * (1.0 / 11);
    }
    for (int power = 10; power >= 1; --power)
        for (std::size_t i = 0; i < 4; ++i) series[i] = 1.0 + r[i] * (1.0 / power) * series[i];
    for (std::size_t i = 0; i < 4; ++i) {
        const auto exponent = (std::bit_cast<Integers4>(rounded[i]) + 1023) << 52;
        series[i] = series[i] * std::bit_cast<Doubles4>(exponent);
    }
    return series;
}

/// Computes the factors of a bell along an axis, unless they are the last ones. Beyond the part's end they
/// are 0.
void find_factors(const Footprint& f, const VoxelBox& part, std::size_t axis, BellAxis& last) {
    const int a = static_cast<int>(axis), low = part.low[axis], high = part.high[axis];
    const double centre = f.centre[a], step = f.step[a], radius = f.half.x;
    if (last.centre == centre && last.step == step && last.radius == radius && last.low == low &&
        last.high == high)
        return;
    last = {centre, step, radius, low, high, {}};
    BrickAxis exponents{};
    for (int i = low; i < high; ++i) {
        const double d = (i - centre) * step;
        exponents[static_cast<std::size_t>(i - low)] = -bell_exponent * (d / radius) * (d / radius);
    }
    exponents = det::exp8(exponents);
    std::copy_n(exponents.begin(), high - low, last.factors.begin());
}

/// Weights of a bell, which is the product of one along each axis.
std::size_t weigh_bell(const Footprint& f, const VoxelBox& part, BellAxes& bell, PartWeights& weights) {
    static const double rim = det::exp(-bell_exponent), scale = 1 / (1 - rim);
    for (std::size_t axis = 0; axis < 3; ++axis) find_factors(f, part, axis, bell[axis]);
    const auto size = [&](std::size_t axis) {
        return static_cast<std::size_t>(part.high[axis] - part.low[axis]);
    };
    std::size_t at = 0;
    for (std::size_t k = 0; k < size(2); ++k) {
        for (std::size_t j = 0; j < size(1); ++j) {
            for (std::size_t half = 0; half < brick_size; half += 4, at += 4) {
                const auto x = four_at<Doubles4>(&bell[0].factors[half]);
                const Doubles4 weight = (x * bell[1].factors[j] * bell[2].factors[k] - rim) * scale;
                put_four(&weights[at], weight > Doubles4{} ? weight : Doubles4{});
            }
        }
    }
    return at;
}

}  // namespace

Footprint footprint_of(const VoxelView& body, const Extent& extent, vec3 place, const mat3& turn) {
    Footprint f{.shape = extent.shape, .stamp = &extent.stamp, .half = extent.half, .turn = turn};
    const bool finite = is_finite(place) && is_finite(extent.half) && is_finite(turn[0]) &&
                        is_finite(turn[1]) && is_finite(turn[2]);
    const bool hollow = extent.shape == ExtentShape::stamp && extent.stamp.weight.empty();
    if (!finite || hollow || !(extent.half.x > 0 && extent.half.y > 0 && extent.half.z > 0)) return f;
    f.step = extent.in_metres ? body.spacing : vec3(1);
    f.rim = rim_voxels * std::max({f.step.x, f.step.y, f.step.z});
    f.centre = (place - body.first_place()) / body.spacing;
    if (is_finite(f.centre)) f.box = box_of(f, body.all());
    return f;
}

Footprint plate_of(const VoxelView& body, const Extent& extent, vec3 place, vec3 motion, const mat3& turn) {
    // Factor from m to the extent's unit, along each axis.
    const vec3 step = extent.in_metres ? vec3(1) : 1.0 / body.spacing;
    const vec3 way = motion * step;
    const double length = glm::length(way);
    if (!(length > 1e-9)) return footprint_of(body, extent, place, turn);
    Extent longer = extent;
    longer.half.z += length / 2;
    const vec3 z = way / length;
    vec3 y = turn[1] - z * glm::dot(z, turn[1]);
    y = glm::length(y) > 1e-6 ? glm::normalize(y) : perpendicular_to(z);
    return footprint_of(body, longer, place - 0.5 * motion, mat3(glm::cross(y, z), y, z));
}

std::size_t weigh(const Footprint& f, const VoxelBox& part, BellAxes& last, PartWeights& weights) {
    if (f.shape == ExtentShape::gaussian) return weigh_bell(f, part, last, weights);
    auto axes = along_axes(f, part);
    if (f.shape == ExtentShape::sphere) {
        for (BrickAxis& axis : axes) {
            for (double& d : axis) d = d * d;
        }
        return combine(axes, part, weights, [&](double x, double y, double z) {
            return coverage(f.half.x - std::sqrt(x + y + z), f.rim);
        });
    }
    return combine(axes, part, weights, [&](double x, double y, double z) {
        const vec3 local = vec3(x, y, z) * f.turn;  // multiplies by the transpose: body frame to tool frame
        return f.shape == ExtentShape::stamp ? stamp_weight(f, local) : box_weight(f, local);
    });
}

WeightedRows weighted_rows(const PartWeights& weights, std::size_t count) {
    WeightedRows weighted;
    for (std::size_t row = 0; row * brick_size < count; ++row) {
        const double* const at = &weights[row * brick_size];
        double most = 0;
        for (std::size_t i = 0; i < brick_size; ++i) most = std::max(most, at[i]);
        weighted.rows[weighted.count] = static_cast<std::uint8_t>(row);
        weighted.count += most > 0 ? 1 : 0;
    }
    return weighted;
}

void to_shares(double amount, const WeightedRows& weighted, PartWeights& weights) {
    for (std::size_t i = 0; i < weighted.count; i += 2) {
        // The last row stands for its missing partner.
        double* const row = &weights[weighted.rows[i] * std::size_t{brick_size}];
        double* const next =
            &weights[weighted.rows[std::min(i + 1, weighted.count - 1)] * std::size_t{brick_size}];
        const std::array<double*, 4> halves{row, row + 4, next, next + 4};
        Sixteen x;
        for (std::size_t h = 0; h < 4; ++h) x[h] = -amount * four_at<Doubles4>(halves[h]);
        const Sixteen left = falling_exp(x);
        for (std::size_t h = 0; h < 4; ++h) put_four(halves[h], 1.0 - left[h]);
    }
}

}  // namespace thaum::field
