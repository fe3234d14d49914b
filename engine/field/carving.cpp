#include "field/carving.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "core/assert.h"
#include "core/doubles4.h"
#include "core/hash.h"
#include "field/detail/carving_extent.h"

namespace thaum::field {
namespace {

// A filter moves a density gradually towards a constant. When they differ by at most this (share of the range
// from empty to full), the density becomes the constant exactly.
constexpr double close_enough = 0x1.0p-20;
// Least weight of the tool at a voxel with which the voxel's material is set, and its colour if the operation
// does not mix colours gradually.
constexpr double half_covered = 0.5;

/// One operation of a tool at one of the places along its motion, with all that it needs there.
struct Cast {
    const Operation* operation;
    Footprint footprint;
    /// For a gradual change (`filter`): its rate times the time for which it acts; else not used.
    double amount;
    std::uint64_t seed;  ///< random seed by which colours are rounded up or down
};

struct Casts {
    std::array<Cast, max_operations * max_places> items;
    std::size_t count = 0;
};

/// Number of places along the tool's motion at which it is applied. They are so near to each other that a
/// quick motion leaves no gaps: at most half of the extent's smallest half edge apart, unless `max_places`
/// limits their number.
int places_along(const VoxelView& body, const Extent& extent, vec3 motion) {
    const vec3 way = extent.in_metres ? motion : motion / body.spacing;
    const double smallest = std::min({extent.half.x, extent.half.y, extent.half.z});
    const double steps = std::ceil(glm::length(way) / (0.5 * smallest));
    return steps > 1 ? static_cast<int>(std::min(steps, double{max_places})) : 1;  // a NaN gives 1
}

void add_casts(const VoxelView& body, const Operation& operation, const Dab& dab, Casts& casts) {
    const bool filter = operation.method == Method::filter;
    const double amount = filter ? std::min(operation.rate * dab.seconds, max_amount) : 1;
    if (!(amount > 0) || !is_finite(dab.motion)) return;
    const Extent& extent = operation.extent;
    const bool plate = extent.shape == ExtentShape::plate;
    const int places = plate ? 1 : places_along(body, extent, dab.motion);
    for (int i = 0; i < places; ++i) {
        const vec3 place = dab.place - dab.motion * (static_cast<double>(places - 1 - i) / places);
        const Footprint footprint = plate ? plate_of(body, extent, place, dab.motion, dab.turn)
                                          : footprint_of(body, extent, place, dab.turn);
        if (footprint.box.empty()) continue;
        casts.items[casts.count++] = {&operation, footprint, amount / places,
                                      hash_combine(dab.seed, static_cast<std::uint64_t>(i))};
    }
}

void check(const Tool& tool) {
    int density = 0, colour = 0, material = 0;
    for (const Operation& o : tool.operations) {
        density += o.changes.density ? 1 : 0;
        colour += o.changes.colour ? 1 : 0;
        material += o.changes.material ? 1 : 0;
    }
    THAUM_ASSERT(tool.operations.size() <= max_operations && density <= 1 && colour <= 1 && material <= 1,
                 "two operations of a carving tool change one property");
}

void collect(const VoxelView& body, const Tool& tool, const Dab& dab, Casts& casts) {
    check(tool);
    for (const Operation& operation : tool.operations) add_casts(body, operation, dab, casts);
}

VoxelBox box_around(const Casts& casts) {
    VoxelBox box;
    for (std::size_t i = 0; i < casts.count; ++i) box = around(box, casts.items[i].footprint.box);
    return box;
}

/// Density of a voxel after an operation that sets the density to a constant. `weight` is that of the tool's
/// shape at the voxel. With weight 1 the density becomes the constant. At the rim of the shape weights are
/// lower, and the density need only lie in a range around the constant, which is wider there. A density in
/// the range is kept, so applying the tool again changes nothing.
float limited_density(const VoxelView& body, const Cast& cast, float current, double weight) {
    const double range = static_cast<double>(body.full) - static_cast<double>(body.empty);
    const double empty = static_cast<double>(body.empty), constant = cast.operation->density;
    const double d = std::isfinite(current) ? static_cast<double>(current) : empty;
    const double solid = (d - empty) / range;
    const double low = constant * weight, high = constant + (1 - weight) * (1 - constant);
    if (solid >= low && solid <= high) return static_cast<float>(d);
    return static_cast<float>(empty + std::clamp(solid, low, high) * range);
}

using Floats4 = float __attribute__((vector_size(16)));
/// Four integers: the result of comparing two vectors of four floats.
using Narrow4 = std::int32_t __attribute__((vector_size(16)));

/// Copies a row of densities. Most rows are whole, and the copy of a constant number of bytes needs no call.
void copy_row(const float* from, float* to, std::size_t width) {
    if (width == brick_size)
        std::memcpy(to, from, brick_size * sizeof(float));
    else
        std::copy_n(from, width, to);
}

/// Moves each density of a row towards the constant of a filter, by the part of the way that `shares` gives.
/// Adds the changes to `sums` and returns a bit for each density that changed. Eight are computed at once,
/// which takes a third of the time; the sums are added one by one, in the order of the row.
unsigned filter_row(const VoxelView& body, const Cast& cast, std::span<float> row,
                    std::span<const double, brick_size> shares, Edit& sums) {
    const Doubles4 largest = all_four(std::numeric_limits<float>::max());
    const double range = static_cast<double>(body.full) - static_cast<double>(body.empty);
    const Doubles4 empty = all_four(static_cast<double>(body.empty));
    const Doubles4 target = empty + cast.operation->density * range;
    const Doubles4 near = all_four(close_enough * range);
    std::array<float, brick_size> densities{};
    copy_row(row.data(), densities.data(), row.size());
    std::array<double, brick_size> added, removed;
    unsigned bits = 0;
    for (std::size_t half = 0; half < brick_size; half += 4) {
        const auto stored = four_at<Floats4>(&densities[half]);
        const auto share = four_at<Doubles4>(&shares[half]);  // 0 beyond the row's end, which changes nothing
        const Doubles4 current = __builtin_convertvector(stored, Doubles4);
        const Doubles4 d = ((current >= -largest) & (current <= largest)) ? current : empty;
        const Doubles4 moved = d + share * (target - d), off = moved - target;
        const Doubles4 exact = ((off >= -near) & (off <= near)) ? target : moved;
        const Floats4 next = __builtin_convertvector(exact, Floats4);
        const Doubles4 kept = __builtin_convertvector(next, Doubles4);
        const Integers4 changes = (kept != current) & (share > Doubles4{});
        const Doubles4 more = changes ? kept - d : Doubles4{};
        put_four(&added[half], more > Doubles4{} ? more : Doubles4{});
        put_four(&removed[half], more > Doubles4{} ? Doubles4{} : -more);
        put_four(&densities[half], __builtin_convertvector(changes, Narrow4) ? next : stored);
        const Integers4 bit = changes & Integers4{1, 2, 4, 8};
        bits |= static_cast<unsigned>(bit[0] | bit[1] | bit[2] | bit[3]) << half;
    }
    if (bits == 0) return 0;
    for (std::size_t i = 0; i < brick_size; ++i) {
        sums.added += added[i];
        sums.removed += removed[i];
    }
    copy_row(densities.data(), row.data(), row.size());
    return bits;
}

/// Moves a byte towards another one by `share` of their difference. The result is rounded up or down at
/// random; `dice` is the random number, in [0, 1).
std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share, double dice) {
    const double exact = from + share * (to - from);
    return static_cast<std::uint8_t>(std::clamp(exact + dice, 0.0, 255.0));
}

Rgb8 next_colour(const Cast& cast, std::size_t voxel, Rgb8 current, double weight) {
    const Rgb8 to = cast.operation->colour;
    if (cast.operation->method == Method::constant) return weight >= half_covered ? to : current;
    const std::uint64_t dice = hash_combine(cast.seed, voxel);
    const auto part = [&](unsigned shift) {
        return static_cast<double>((dice >> shift) & 0xffffU) * 0x1.0p-16;
    };
    return {mixed(current.r, to.r, weight, part(0)), mixed(current.g, to.g, weight, part(16)),
            mixed(current.b, to.b, weight, part(32))};
}

/// Whether one of the voxel's six neighbours lies on the other side of the body's surface.
bool is_at_surface(const VoxelView& body, std::array<int, 3> voxel) {
    const bool inside = body.density[body.at(voxel[0], voxel[1], voxel[2])] >= body.surface;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            auto next = voxel;
            next[axis] += side;
            if (next[axis] < 0 || next[axis] >= body.count[axis]) continue;
            if ((body.density[body.at(next[0], next[1], next[2])] >= body.surface) != inside) return true;
        }
    }
    return false;
}

/// Changes these properties of one voxel, and adds the change of density to `sums`. Returns true if a bit of
/// the voxel changed.
bool change(const VoxelView& body, const Cast& cast, const Properties& changes, std::size_t voxel,
            double weight, Edit& sums) {
    bool changed = false;
    if (changes.density && cast.operation->method == Method::filter) {
        const std::array<double, brick_size> shares{weight};
        changed = filter_row(body, cast, body.density.subspan(voxel, 1), shares, sums) != 0;
    } else if (changes.density) {
        float& density = body.density[voxel];
        const float next = limited_density(body, cast, density, weight);
        if (next != density) {  // also true if the old density is NaN
            const double was =
                std::isfinite(density) ? static_cast<double>(density) : static_cast<double>(body.empty);
            const double more = static_cast<double>(next) - was;
            (more > 0 ? sums.added : sums.removed) += std::abs(more);
            density = next;
            changed = true;
        }
    }
    if (changes.colour) {
        const Rgb8 next = next_colour(cast, voxel, body.colour[voxel], weight);
        changed = changed || next != body.colour[voxel];
        body.colour[voxel] = next;
    }
    if (changes.material && weight >= half_covered) {
        changed = changed || body.material[voxel] != cast.operation->material;
        body.material[voxel] = cast.operation->material;
    }
    return changed;
}

/// Marks of the voxels of a brick (8 x 8 x 8 voxels) that have changed: a bit for each voxel, a byte for each
/// row.
using Changed = std::array<std::uint8_t, brick_size * brick_size>;

/// Applies an operation to a row of voxels, which begins at `first`. Returns a bit for each voxel that
/// changed.
unsigned change_row(const VoxelView& body, const Cast& cast, std::array<int, 3> first, std::size_t width,
                    std::span<const double, brick_size> weights, Edit& sums) {
    const bool surface_only = cast.operation->surface_only;
    const std::size_t voxel = body.at(first[0], first[1], first[2]);
    Properties changes = cast.operation->changes;
    unsigned changed = 0;
    if (changes.density && cast.operation->method == Method::filter && !surface_only) {
        changed = filter_row(body, cast, body.density.subspan(voxel, width), weights, sums);
        changes.density = false;
    }
    if (changes == Properties{}) return changed;
    for (std::size_t i = 0; i < width; ++i) {
        if (!(weights[i] > 0)) continue;
        const auto x = first[0] + static_cast<int>(i);
        if (surface_only && !is_at_surface(body, {x, first[1], first[2]})) continue;
        if (change(body, cast, changes, voxel + i, weights[i], sums)) changed |= 1U << i;
    }
    return changed;
}

void apply(const VoxelView& body, const Cast& cast, const VoxelBox& brick, BellAxes& last, Changed& changed,
           Edit& sums) {
    const VoxelBox part = overlap(brick, cast.footprint.box);
    if (part.empty()) return;
    PartWeights weights;
    const std::size_t count = weigh(cast.footprint, part, last, weights);
    const WeightedRows weighted = weighted_rows(weights, count);
    if (cast.operation->method == Method::filter) to_shares(cast.amount, weighted, weights);
    const int low = part.low[0], rows = part.high[1] - part.low[1];
    const auto width = static_cast<std::size_t>(part.high[0] - low);
    for (std::size_t i = 0; i < weighted.count; ++i) {
        const int row = weighted.rows[i], j = part.low[1] + row % rows, k = part.low[2] + row / rows;
        const auto of_row = std::span(weights).subspan(static_cast<std::size_t>(row) * brick_size);
        const int row_in_brick = (k % brick_size) * brick_size + j % brick_size;
        std::uint8_t& bits = changed[static_cast<std::size_t>(row_in_brick)];
        bits = static_cast<std::uint8_t>(
            bits | change_row(body, cast, {low, j, k}, width, of_row.first<brick_size>(), sums)
                       << static_cast<unsigned>(low % brick_size));
    }
}

/// Adds the number of changed voxels of a brick (block of voxels), and a box around them, to the result.
void count_changed(const Changed& changed, const VoxelBox& brick, Edit& result) {
    unsigned columns = 0, rows = 0, layers = 0, count = 0;  // a bit for each that has a changed voxel
    for (unsigned layer = 0; layer < brick_size; ++layer) {
        for (unsigned row = 0; row < brick_size; ++row) {
            const unsigned bits = changed[layer * brick_size + row];
            columns |= bits;
            rows |= bits != 0 ? 1U << row : 0U;
            layers |= bits != 0 ? 1U << layer : 0U;
            count += static_cast<unsigned>(std::popcount(bits));
        }
    }
    if (count == 0) return;
    VoxelBox box = brick;
    const std::array bits{columns, rows, layers};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = brick.low[axis] + std::countr_zero(bits[axis]);
        box.high[axis] = brick.low[axis] + static_cast<int>(std::bit_width(bits[axis]));
    }
    result.changed = around(result.changed, box);
    result.voxels += count;
    ++result.bricks;
}

}  // namespace

VoxelBox reach(const VoxelView& body, const Tool& tool, const Dab& dab) {
    Casts casts;
    collect(body, tool, dab, casts);
    return box_around(casts);
}

Edit edit(const VoxelView& body, const Tool& tool, const Dab& dab) {
    Casts casts;
    collect(body, tool, dab, casts);
    Edit result;
    BellAxes last;
    Bricks& bricks = *body.bricks;
    const std::uint32_t version = bricks.newest + 1;
    for_each_brick(bricks, bricks_around(box_around(casts)),
                   [&](std::array<int, 3> brick, std::size_t number) {
                       const VoxelBox box = brick_box(body.count, brick);
                       const std::size_t before = result.bricks;
                       Changed changed{};
                       for (std::size_t i = 0; i < casts.count; ++i)
                           apply(body, casts.items[i], box, last, changed, result);
                       count_changed(changed, box, result);
                       if (result.bricks > before) bricks.version[number] = version;
                   });
    if (result.bricks > 0) bricks.newest = version;
    result.removed *= body.voxel_volume();
    result.added *= body.voxel_volume();
    return result;
}

}  // namespace thaum::field
