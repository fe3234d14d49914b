#include "gesture/shape.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

#include "core/doubles4.h"
#include "gesture/detail/rests.h"
#include "gesture/detail/vectors.h"

namespace thaum::gesture {
namespace {

// Number of points up to which computing all places along the stroke is faster than searching for some.
constexpr std::size_t few_points = 200;
/// To make the axes of a fine shape more alike, the ratio of their sizes is raised to this exponent. An axis
/// smaller than `min_axis`, as a share of the largest, counts as that large.
constexpr float axis_exponent = 0.5F, min_axis = 0.5F;
// Length of a direction after a long step, and the step (in sizes of the stroke) at which the direction has
// half that length. Where points lie close together, their direction is uncertain, and so counts less.
constexpr float direction_weight = 1.3F, slow_step = 0.12F;
constexpr float force_deviation = 0.5F;  // standard deviation of the force channel
// A rest may begin at a point in two cases. Its next step lasts longer than T = `halt_share` times the
// longest halt and is shorter than `halt_way`. Or the next N steps, where N steps of the stroke last T on
// average, last longer than `min_halt` times T and are together shorter than `halt_way` plus N times
// `tremor_step`, since a hand trembles. Lengths are shares of the stroke's extent.
constexpr float halt_share = 0.75F, min_halt = 0.8F, halt_way = 0.04F, tremor_step = 0.01F;
// Duration above which all points of a stroke are searched for rests. In a shorter stroke, the points that
// were copied (at most counted_points) are searched first (s).
constexpr float surely_quick = 10;
/// Number of points outside of rests that is enough for a shape. If there are fewer, all points of the stroke
/// are read, so that others replace those of rests.
constexpr std::size_t enough_points = 48;

using Bits4 = std::uint64_t __attribute__((vector_size(32)));

Floats4 masked(Floats4 v, Ints4 mask) { return reinterpret_cast<Floats4>(reinterpret_cast<Ints4>(v) & mask); }

/// Points of a stroke in the form of its shape, each with force, x, y and z in its four lanes.
template <std::size_t points>
struct Sampled {
    std::array<Floats4, points> at;
};

/// Mask of those lanes (force, x, y, z) of a point that the channels in use contain.
Ints4 lanes_of(Channels channels) { return Ints4{channels.force ? -1 : 0, -1, -1, channels.depth ? -1 : 0}; }

/// Four vectors of four lanes, transposed: `a` holds the first lane of each vector, `d` the last one.
struct Columns {
    Floats4 a, b, c, d;
};

Columns transposed(Floats4 p, Floats4 q, Floats4 r, Floats4 s) {
    const auto pq = __builtin_shufflevector(p, q, 0, 4, 1, 5),
               pq2 = __builtin_shufflevector(p, q, 2, 6, 3, 7);
    const auto rs = __builtin_shufflevector(r, s, 0, 4, 1, 5),
               rs2 = __builtin_shufflevector(r, s, 2, 6, 3, 7);
    return {__builtin_shufflevector(pq, rs, 0, 1, 4, 5), __builtin_shufflevector(pq, rs, 2, 3, 6, 7),
            __builtin_shufflevector(pq2, rs2, 0, 1, 4, 5), __builtin_shufflevector(pq2, rs2, 2, 3, 6, 7)};
}

Floats4 roots_of(Floats4 v) {
    float lanes[4];
    store(lanes, v);
    for (float& lane : lanes) lane = std::sqrt(lane);
    return load<Floats4>(lanes);
}

/// Whether all numbers of all points are finite, including points that thinning leaves out. Tests four
/// numbers at a time.
bool all_finite_numbers(Points stroke) {
    static_assert(sizeof(StrokePoint) == 5 * sizeof(double));
    constexpr std::uint64_t exponent = 0x7ff0000000000000;
    const auto* from = reinterpret_cast<const unsigned char*>(stroke.data());
    const std::size_t bytes = stroke.size_bytes();
    constexpr std::size_t width = sizeof(Bits4);
    const auto bad_at = [&](std::size_t place) {
        return static_cast<Bits4>((load<Bits4>(from + place) & exponent) == exponent);
    };
    Bits4 bad{}, bad2{};
    std::size_t i = 0;
    for (; i + 4 * width <= bytes; i += 4 * width) {
        bad |= bad_at(i) | bad_at(i + width);
        bad2 |= bad_at(i + 2 * width) | bad_at(i + 3 * width);
    }
    for (; i + width <= bytes; i += width) bad |= bad_at(i);
    bool others = true;
    for (; i < bytes; i += sizeof(double))
        others = others && (load<std::uint64_t>(from + i) & exponent) != exponent;
    bad |= bad2;
    return others && (bad[0] | bad[1] | bad[2] | bad[3]) == 0;
}

/// Time and place of a point relative to those of another.
Floats4 relative(const StrokePoint& p, Doubles4 origin) {
    static_assert(offsetof(StrokePoint, t) == 0 && offsetof(StrokePoint, at) == sizeof(double));
    return __builtin_convertvector(load<Doubles4>(&p) - origin, Floats4);
}

Floats4 larger(Floats4 a, Floats4 b) { return a > b ? a : b; }
Floats4 smaller(Floats4 a, Floats4 b) { return a < b ? a : b; }
Floats4 size_of(Floats4 v) { return masked(v, 0x7fffffff + Ints4{}); }
bool all_of(Ints4 lanes) { return (lanes[0] & lanes[1] & lanes[2] & lanes[3]) != 0; }

/// Index distance of the points that are used: a long stroke is thinned to at most counted_points.
std::size_t stride_of(std::size_t points) { return (points + counted_points - 1) / counted_points; }

/// Facts about a stroke that `copy` has found.
struct Copied {
    bool finite{};   ///< true if all times and forces are finite
    bool plain{};    ///< true if each point has another place than the one before, and no earlier time
    float extent{};  ///< largest of width, height and depth
};

/// Copies the points as floats, relative to the first point's place and time, and sums up the distances
/// between neighbours.
Copied copy(Points stroke, bool depth, ShapeSpace& space) {
    const std::size_t stride = stride_of(stroke.size());
    const std::size_t steps = (stroke.size() - 1) / stride, count = steps + 1;
    const auto* from = &stroke[stroke.size() - 1 - steps * stride];  // so that the last point is copied, too
    const auto* const end = &stroke[stroke.size() - 1];
    const auto origin = load<Doubles4>(from);
    const Ints4 used{-1, -1, -1, depth ? -1 : 0};
    Floats4 before{}, low{}, high{}, latest{};
    Ints4 plain{-1, -1, -1, -1};
    float length = 0;
    const auto take = [&](std::size_t k) {
        const Floats4 v = masked(relative(*from, origin), used), step = v - before;
        const Floats4 force{static_cast<float>(from->force)};
        const Floats4 point = __builtin_shufflevector(v, force, 4, 1, 2, 3);
        before = v;
        space.t[k] = v[0];
        store(&space.points[k], point);
        low = smaller(low, point);
        high = larger(high, point);
        from += from < end ? stride : 0;  // the last point is repeated to fill the places after it
        return step;
    };
    for (std::size_t k = 0; k < count; k += 4) {
        const Floats4 a = take(k), b = take(k + 1), c = take(k + 2), d = take(k + 3);
        const auto [t, x, y, z] = transposed(a, b, c, d);
        const Floats4 distances = roots_of(x * x + y * y + z * z);
        for (std::size_t i = 0; i < 4; ++i) space.length[k + i] = length += distances[i];
        latest = larger(latest, size_of(t));
        Ints4 moves = (distances > 0) & (t >= 0);
        if (k == 0) moves[0] = -1;
        if (k + 4 > count)
            moves |= static_cast<std::int32_t>(k) + Ints4{0, 1, 2, 3} >= static_cast<std::int32_t>(count);
        plain &= moves;
    }
    space.count = count;
    constexpr float most = std::numeric_limits<float>::max();
    const Floats4 extent = high - low;
    return {all_of((high <= most) & (low >= -most) & (latest <= most)), all_of(plain),
            std::max({extent[1], extent[2], extent[3]})};
}

/// Signs that a rest may begin at a point, cheap to test: for some time, the path from there on is short.
struct HaltSign {
    std::size_t steps{};  ///< number of steps (point to point) of the path from the tested point on
    /// Length of the whole path, and of its first step, below which there may be a rest.
    float way{}, shortest{};
    /// Duration of the first step, and of the whole path, above which there may be a rest (s).
    float longest{}, halt{};
};

/// Marks those of the four points from `k` on at which a rest of the hand may begin.
Ints4 signs_at(const ShapeSpace& space, const HaltSign& sign, std::size_t k) {
    const auto length = load<Floats4>(&space.length[k]), t = load<Floats4>(&space.t[k]);
    const auto way = load<Floats4>(&space.length[k + sign.steps]) - length,
               time = load<Floats4>(&space.t[k + sign.steps]) - t,
               step = load<Floats4>(&space.length[k + 1]) - length,
               pause = load<Floats4>(&space.t[k + 1]) - t;
    return ((way < sign.way) & (time > sign.halt)) | ((step < sign.shortest) & (pause > sign.longest));
}

/// The signs of a rest for the points that were copied; `steps` is 0 if the stroke is too short for a rest.
/// Sets the points beyond the last one to values that never look like a rest.
HaltSign halt_sign(ShapeSpace& space, float extent) {
    const float lasts = space.t[space.count - 1];
    constexpr float halt = halt_share * static_cast<float>(longest_halt);
    if (!(lasts > halt)) return {};
    const auto wanted = static_cast<std::size_t>(halt * static_cast<float>(space.count) / lasts) + 1;
    const std::size_t steps = std::min(wanted, space.count - 1);
    const float tremor = tremor_step * static_cast<float>(steps);
    for (std::size_t i = 0; i < steps + 4; ++i) {
        space.length[space.count + i] = std::numeric_limits<float>::max();
        space.t[space.count + i] = lasts;
    }
    return {steps, (halt_way + tremor) * extent, halt_way * extent, halt, min_halt * halt};
}

bool has_sign(const ShapeSpace& space, const HaltSign& sign) {
    Ints4 some{};
    for (std::size_t k = 0; k + 1 < space.count; k += 4) some |= signs_at(space, sign, k);
    return (some[0] | some[1] | some[2] | some[3]) != 0;
}

/// Presents the copied points of a stroke to the search for rests (rests.h).
struct CopiedStroke {
    const ShapeSpace& space;
    const HaltSign& sign;
    std::size_t size() const { return space.count; }
    fvec3 place(std::size_t i) const { return {space.points[i].x, space.points[i].y, space.points[i].z}; }
    double t(std::size_t i) const { return static_cast<double>(space.t[i]); }
    bool may_rest(std::size_t i) const { return signs_at(space, sign, i)[0] != 0; }
};

/// Presents all points of a stroke to the search for rests (rests.h).
struct WholeStroke {
    Points points;
    bool depth;
    std::size_t size() const { return points.size(); }
    vec3 place(std::size_t i) const {
        const vec3& at = points[i].at;
        return {at.x, at.y, depth ? at.z : 0};
    }
    double t(std::size_t i) const { return points[i].t; }
    static bool may_rest(std::size_t) { return true; }
    double extent() const {
        vec3 low = points[0].at, high = low;
        for (const auto& p : points) {
            low = glm::min(low, p.at);
            high = glm::max(high, p.at);
        }
        const vec3 extent = high - low;
        return std::max({extent.x, extent.y, depth ? extent.z : 0});
    }
};

float distance(const ShapePoint& a, const ShapePoint& b) {
    const float dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
}

/// Keeps those of the copied points that lie in moving parts of the stroke, and drops those of rests.
void keep_moving(const MovingParts& parts, ShapeSpace& s) {
    const float start_t = s.t[parts.items[0].first];
    std::size_t count = 0;
    float length = 0;  // arc length up to the current point
    for (std::size_t k = 0; k < parts.count; ++k) {
        const auto& part = parts.items[k];
        if (count > 0) length += distance(s.points[count - 1], s.points[part.first]);
        const float longer = s.length[part.first] - length,
                    later = start_t + static_cast<float>(part.earlier);
        length = s.length[part.last] - longer;
        if (part.first == count) {  // nothing before this part was removed
            count = part.last + 1;
            continue;
        }
        for (std::size_t i = part.first; i <= part.last; ++i, ++count) {
            s.points[count] = s.points[i];
            s.t[count] = s.t[i] - later;
            s.length[count] = s.length[i] - longer;
        }
    }
    s.count = count;
    s.before += start_t;
}

/// Copies the points in the moving parts of a whole stroke, thinned to at most counted_points.
Copied copy_moving(Points stroke, bool depth, const MovingParts& parts, ShapeSpace& space) {
    const std::size_t points = parts.points(), stride = stride_of(points);
    std::array<StrokePoint, counted_points> kept;
    std::size_t skip = (points - 1) % stride, count = 0;
    for (std::size_t k = 0; k < parts.count; ++k) {
        const auto& part = parts.items[k];
        std::size_t i = part.first + skip;
        for (; i <= part.last; i += stride) {
            kept[count] = stroke[i];
            kept[count++].t -= part.earlier;
        }
        skip = i - part.last - 1;
    }
    space.before = static_cast<float>(kept[0].t - stroke[0].t);
    return copy(Points(kept).first(count), depth, space);
}

/// Removes the points at which the hand rests from a stroke that `copy` has copied.
Copied leave_out_rests(Points stroke, bool depth, const Copied& copied, ShapeSpace& space) {
    const bool slow = space.t[space.count - 1] > surely_quick;
    HaltSign sign;
    if (!slow) {
        sign = halt_sign(space, copied.extent);
        if (sign.steps == 0 || !has_sign(space, sign)) return copied;
    }
    const std::size_t stride = stride_of(stroke.size());
    if (!slow) {
        const auto parts = moving_parts(CopiedStroke{space, sign}, static_cast<double>(copied.extent));
        const std::size_t points = parts.points();
        if (points < 2 || points == space.count) return copied;
        if (stride == 1 || points >= enough_points) {
            space.paused = static_cast<float>(parts.items[parts.count - 1].earlier);
            keep_moving(parts, space);
            return {true, copied.plain && parts.count == 1, copied.extent};
        }
    }
    const WholeStroke whole{stroke, depth};
    const auto parts = moving_parts(whole, whole.extent());
    const std::size_t points = parts.points();
    if (points < 2 || points == stroke.size()) return copied;
    space.paused = static_cast<float>(parts.items[parts.count - 1].earlier);
    return copy_moving(stroke, depth, parts, space);
}

/// Drops points at the same place as the point before, and recomputes the arc lengths.
void drop_rests(ShapeSpace& s) {
    std::size_t k = 0;
    float length = 0, latest = s.t[0];
    ShapePoint before = s.points[0];
    for (std::size_t i = 1; i < s.count; ++i) {
        const ShapePoint p = s.points[i];
        const float step = distance(before, p);
        before = p;
        latest = std::max(latest, s.t[i]);  // a time that runs backwards is replaced by the latest time
        if (!(step > 0)) {
            if (k == 0) s.t[0] = latest;  // a rest before the stroke does not belong to it
            s.points[k].force = std::max(s.points[k].force, p.force);
            continue;
        }
        ++k;
        length += step;
        s.points[k] = p;
        s.t[k] = latest;
        s.length[k] = length;
    }
    s.count = k + 1;
}

bool fill(Points stroke, Channels channels, Rests rests, ShapeSpace& space) {
    if (stroke.empty() || !all_finite_numbers(stroke)) return false;
    space.before = space.paused = 0;
    auto copied = copy(stroke, channels.depth, space);
    if (!copied.finite) return false;
    if (rests == Rests::left_out) copied = leave_out_rests(stroke, channels.depth, copied, space);
    if (!copied.finite) return false;
    if (!copied.plain) drop_rests(space);
    return std::isfinite(space.length[space.count - 1]);
}

/// The last point from `first` to before `last` whose place (parameter along the stroke) is below `wanted`;
/// `first` if none is. The number of search steps depends only on the number of points, so the processor
/// predicts the branches.
template <class Place>
std::size_t point_before(float wanted, std::size_t first, std::size_t last, Place place) {
    for (std::size_t count = last - first; count > 1;) {
        const std::size_t half = count / 2;
        first += place(first + half) < wanted ? half : 0;
        count -= half;
    }
    return first;
}

/// The parameter along a stroke, from 0 to 1, at each of the equally spaced points of a shape. Then two more
/// values that are larger than any parameter.
template <std::size_t points>
constexpr std::array<float, points + 2> wanted_places() {
    std::array<float, points + 2> wanted{};
    for (std::size_t i = 0; i < points; ++i)
        wanted[i] = static_cast<float>(i) / static_cast<float>(points - 1);
    wanted[points] = wanted[points + 1] = 1e30F;
    return wanted;
}

/// For each point of the shape, the last point of the stroke from `first` to before `last` that lies before
/// it; `first` if none does. Instead of one search for each point of the shape, each point of the stroke
/// marks the first point of the shape beyond it.
template <std::size_t points>
std::array<std::uint32_t, points> points_before(const ShapeSpace& s, std::size_t first, std::size_t last) {
    static constexpr auto wanted = wanted_places<points>();
    constexpr std::size_t width = 4;
    std::array<std::uint32_t, (points + 2 + width - 1) / width * width> before;
    for (std::size_t i = 0; i < before.size(); i += width) store(&before[i], Ints4{});
    for (std::size_t j = first; j < last; ++j) {
        const float place = s.place[j];
        auto i =
            static_cast<std::uint32_t>(static_cast<std::int32_t>(place * static_cast<float>(points - 1)));
        i = std::min(i, static_cast<std::uint32_t>(points - 1));
        i += wanted[i] <= place ? 1 : 0;
        i += wanted[i] <= place ? 1 : 0;  // once more, since the product above may have been rounded down
        before[i] = static_cast<std::uint32_t>(j);
    }
    std::array<std::uint32_t, points> result;
    auto latest = static_cast<std::uint32_t>(first);
    for (std::size_t i = 0; i < points; ++i) result[i] = latest = std::max(latest, before[i]);
    return result;
}

/// For each point of the shape, how far it lies on the way from one point of the stroke to the next, 0 to 1.
template <std::size_t points>
void set_parts(const std::array<float, points>& before, const std::array<float, points>& after,
               std::array<float, points>& part) {
    static constexpr auto wanted = wanted_places<points>();
    for (std::size_t i = 0; i < points; i += 8) {
        const auto low = load<Floats8>(&before[i]), step = load<Floats8>(&after[i]) - low;
        const Floats8 share = (load<Floats8>(&wanted[i]) - low) / step;
        const Floats8 clamped = share < 0 ? Floats8{} : share > 1 ? 1 + Floats8{} : share;
        store(&part[i], step > 0 ? clamped : Floats8{});
    }
}

/// Samples the shape's points along the stroke, at equal steps of the weighted sum of arc length and time,
/// and computes their mean.
template <std::size_t points>
Sampled<points> resampled(ShapeSpace& s, std::size_t first, std::size_t last, Floats4& mean) {
    static constexpr auto wanted = wanted_places<points>();
    const float length = s.length[last] - s.length[first], seconds = s.t[last] - s.t[first];
    const float by_time = seconds > 0 ? time_share / seconds : 0;
    const float by_length = (seconds > 0 ? 1 - time_share : 1) / length;
    const auto place = [&](std::size_t i) {
        return by_length * (s.length[i] - s.length[first]) + by_time * (s.t[i] - s.t[first]);
    };
    std::array<std::uint32_t, points> start;
    std::array<float, points> before, after, part;
    if (last - first < few_points) {
        for (std::size_t i = first; i <= last; ++i) s.place[i] = place(i);
        start = points_before<points>(s, first, last);
        for (std::size_t i = 0; i < points; ++i) {
            before[i] = s.place[start[i]];
            after[i] = s.place[start[i] + 1];
        }
    } else {
        for (std::size_t i = 0; i < points; ++i) {
            start[i] = static_cast<std::uint32_t>(point_before(wanted[i], first, last, place));
            before[i] = place(start[i]);
            after[i] = place(start[i] + 1);
        }
    }
    set_parts(before, after, part);
    Sampled<points> out;
    Floats4 sum{};
    for (std::size_t i = 0; i < points; ++i) {
        const auto a = load<Floats4>(&s.points[start[i]]), b = load<Floats4>(&s.points[start[i] + 1]);
        sum += out.at[i] = a + part[i] * (b - a);
    }
    mean = sum / static_cast<float>(points);
    return out;
}

template <std::size_t points>
Floats4 squares_of(const Sampled<points>& q) {
    Floats4 sum{};
    for (const Floats4 v : q.at) sum += v * v;
    return sum;
}

template <std::size_t points>
void multiply(Sampled<points>& q, Floats4 factors) {
    for (Floats4& v : q.at) v *= factors;
}

/// Moves the centroid of the points to the origin, and scales them to a root mean square distance of 1. Lanes
/// (force, x, y, z) that `used` leaves out become 0. Returns the size before, or 0 if it is too small to
/// divide by.
template <std::size_t points>
float normalise(Sampled<points>& q, Floats4 mean, Ints4 used) {
    for (Floats4& v : q.at) v = masked(v - mean, used);
    const Floats4 squares = squares_of(q);
    const float size = std::sqrt((squares[1] + squares[2] + squares[3]) / static_cast<float>(points));
    if (!(size > 1e-30F) || !std::isfinite(size)) return 0;
    const float deviation = std::sqrt(squares[0] / static_cast<float>(points));
    const float by = 1 / size;
    multiply(q, Floats4{deviation > 1e-6F ? force_deviation / deviation : 0, by, by, by});
    return size;
}

/// Makes the extents of a normalised stroke along its axes more alike, and scales it back to a size of 1.
template <std::size_t points>
void even_out(Sampled<points>& q) {
    static_assert(axis_exponent == 0.5F);
    const Floats4 squares = squares_of(q);
    const float largest = std::max({squares[1], squares[2], squares[3]});
    std::array<float, 3> roots{};
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const float s = squares[k + 1], size = std::sqrt(std::max(s, min_axis * min_axis * largest));
        sum += s / size;
        roots[k] = std::sqrt(size);
    }
    const float whole = std::sqrt(sum / static_cast<float>(points));
    multiply(q, Floats4{1, 1 / (whole * roots[0]), 1 / (whole * roots[1]), 1 / (whole * roots[2])});
}

/// Directions of motion: x, y, z in the lanes 1 to 3.
template <std::size_t points>
Sampled<points> directions_of(const Sampled<points>& q) {
    static_assert(points % 4 == 0);
    const auto step_at = [&](std::size_t i) {
        return q.at[i + 1 < points ? i + 1 : points - 1] - q.at[i > 0 ? i - 1 : 0];
    };
    Sampled<points> d;
    for (std::size_t i = 0; i < points; i += 4) {
        const Floats4 p = step_at(i), r = step_at(i + 1), s = step_at(i + 2), t = step_at(i + 3);
        const auto squares = transposed(p * p, r * r, s * s, t * t);
        const Floats4 by = direction_weight / (roots_of(squares.b + squares.c + squares.d) + slow_step);
        d.at[i] = p * by[0];
        d.at[i + 1] = r * by[1];
        d.at[i + 2] = s * by[2];
        d.at[i + 3] = t * by[3];
    }
    return d;
}

/// How sharply the stroke turns: the cross product of the directions before and after, x, y, z in lanes 1 to
/// 3.
template <std::size_t points>
Floats4 turn_at(const Sampled<points>& d, std::size_t i) {
    const Floats4 a = d.at[i > 0 ? i - 1 : 0], b = d.at[i + 1 < points ? i + 1 : points - 1];
    const auto yzx = [](Floats4 v) { return __builtin_shufflevector(v, v, 0, 2, 3, 1); };
    const auto zxy = [](Floats4 v) { return __builtin_shufflevector(v, v, 0, 3, 1, 2); };
    return yzx(a) * zxy(b) - zxy(a) * yzx(b);
}

/// How sharply a planar stroke turns: the z component of the cross product in turn_at, in lane 1.
template <std::size_t points>
Floats4 flat_turn_at(const Sampled<points>& d, std::size_t i) {
    const Floats4 a = d.at[i > 0 ? i - 1 : 0], b = d.at[i + 1 < points ? i + 1 : points - 1];
    const Floats4 product = a * __builtin_shufflevector(b, b, 0, 2, 1, 3);
    return product - __builtin_shufflevector(product, product, 0, 2, 1, 3);
}

/// Stores the first two lanes.
void store_two(float* to, Floats4 v) { std::memcpy(to, &v, 2 * sizeof(float)); }

template <std::size_t points>
void write_planar(const Sampled<points>& q, const Sampled<points>& d, float* values) {
    for (std::size_t i = 0; i < points; ++i) {
        const Floats4 turn = flat_turn_at(d, i);
        float* v = values + i * planar_channels;
        store(v, __builtin_shufflevector(q.at[i], d.at[i], 1, 2, 5, 6));
        store_two(v + 4, __builtin_shufflevector(turn, q.at[i], 1, 4, 2, 3));
    }
}

template <std::size_t points>
void write_solid(const Sampled<points>& q, const Sampled<points>& d, float* values) {
    for (std::size_t i = 0; i < points; ++i) {
        const Floats4 turn = turn_at(d, i);
        float* v = values + i * solid_channels;
        store(v, __builtin_shufflevector(q.at[i], d.at[i], 1, 2, 3, 5));
        store(v + 4, __builtin_shufflevector(d.at[i], turn, 2, 3, 5, 6));
        store_two(v + 8, __builtin_shufflevector(turn, q.at[i], 3, 4, 1, 2));
    }
}

}  // namespace

bool make_shape(ShapeSpace& s, std::size_t first, std::size_t last, Channels channels, Shape& shape) {
    if (last <= first) return false;
    shape.length = s.length[last] - s.length[first];
    shape.seconds = s.t[last] - s.t[first];
    if (!(shape.length > 0) || !std::isfinite(shape.length) || !std::isfinite(shape.seconds)) return false;
    Floats4 mean;
    auto q = resampled<shape_points>(s, first, last, mean);
    shape.force = mean[0];
    const Ints4 used = lanes_of(channels);
    const Floats4 gap = masked(q.at[shape_points - 1] - q.at[0], used), squares = gap * gap;
    shape.gap = std::sqrt(squares[1] + squares[2] + squares[3]) / shape.length;
    shape.size = normalise(q, mean, used);
    if (!(shape.size > 0)) return false;
    const auto d = directions_of(q);
    shape.channels = channels.depth ? solid_channels : planar_channels;
    if (channels.depth) {
        write_solid(q, d, shape.values.data());
    } else {
        write_planar(q, d, shape.values.data());
    }
    shape.start_t = s.t[first];
    shape.end_t = s.t[last];
    return true;
}

bool make_fine_shape(ShapeSpace& s, std::size_t first, std::size_t last, FineKind kind, FineShape& shape) {
    const float length = s.length[last] - s.length[first], seconds = s.t[last] - s.t[first];
    if (last <= first || !(length > 0) || !std::isfinite(length) || !std::isfinite(seconds)) return false;
    Floats4 mean;
    auto q = resampled<fine_points>(s, first, last, mean);
    if (!(normalise(q, mean, lanes_of(kind.channels)) > 0)) return false;
    if (kind.even) even_out(q);
    const auto d = directions_of(q);
    if (kind.channels.depth) {
        write_solid(q, d, shape.data());
    } else {
        write_planar(q, d, shape.data());
    }
    return true;
}

bool make_shape(Points stroke, Channels channels, ShapeSpace& space, Shape& shape, Rests rests) {
    if (!fill(stroke, channels, rests, space) || space.count < 2 ||
        !make_shape(space, 0, space.count - 1, channels, shape))
        return false;
    shape.start_t += space.before;
    shape.end_t += space.before + space.paused;
    return true;
}

}  // namespace thaum::gesture
