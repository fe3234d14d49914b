#include "gesture/shape.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace thaum::gesture {
namespace {

constexpr std::size_t few_points = 200;  // up to here it is faster to compute all places first
constexpr float turn_weight = 0.5F, fine_turn_weight = 1;
/// Share of the difference between the sizes of the axes that a fine shape keeps as an exponent, and the least size of
/// an axis that counts, as a share of the largest.
constexpr float axis_exponent = 0.5F, least_axis = 0.5F;
// Length of the direction of a long step, and the step (sizes of the stroke) that halves it. Where the points lie close
// together, their direction is uncertain.
constexpr float direction_weight = 1.3F, slow_step = 0.12F;
constexpr std::uint32_t exponent_bits = 0x7f800000;  // all set: infinite or not a number
constexpr float force_deviation = 0.5F;              // standard deviation of the force channel

template <std::size_t points>
using Column = std::array<float, points>;

template <std::size_t points>
struct Sampled {
    Column<points> x{}, y{}, z{}, force{};
};

/// Whether all numbers of all points are finite, also of points that do not count. Four numbers at a time.
bool all_finite_numbers(Points stroke) {
    using Bits4 = std::uint64_t __attribute__((vector_size(32)));
    static_assert(sizeof(StrokePoint) == 5 * sizeof(double));
    constexpr std::uint64_t exponent = 0x7ff0000000000000;
    const auto* from = reinterpret_cast<const unsigned char*>(stroke.data());
    const std::size_t bytes = stroke.size_bytes();
    Bits4 bad{};
    std::size_t i = 0;
    for (; i + sizeof(Bits4) <= bytes; i += sizeof(Bits4)) {
        Bits4 bits;
        std::memcpy(&bits, from + i, sizeof bits);
        bad |= static_cast<Bits4>((bits & exponent) == exponent);
    }
    bool rest = true;
    for (; i < bytes; i += sizeof(double)) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, from + i, sizeof bits);
        rest = rest && (bits & exponent) != exponent;
    }
    return rest && (bad[0] | bad[1] | bad[2] | bad[3]) == 0;
}

using Doubles4 = double __attribute__((vector_size(32)));
using Floats4 = float __attribute__((vector_size(16)));

/// Time and place of a point relative to those of another.
Floats4 relative(const StrokePoint& p, Doubles4 origin) {
    static_assert(offsetof(StrokePoint, t) == 0 && offsetof(StrokePoint, at) == sizeof(double));
    Doubles4 v;
    std::memcpy(&v, &p, sizeof v);
    return __builtin_convertvector(v - origin, Floats4);
}

/// Writes four points at place k. `points` are apart by `stride`. Returns their sums, to see whether all are finite.
Floats4 copy_four(const StrokePoint* points, std::size_t stride, Doubles4 origin, std::size_t k, bool depth,
                  ShapeSpace& space) {
    const auto a = relative(points[0], origin), b = relative(points[stride], origin),
               c = relative(points[2 * stride], origin), d = relative(points[3 * stride], origin);
    const auto tx = __builtin_shufflevector(a, b, 0, 4, 1, 5), yz = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const auto tx2 = __builtin_shufflevector(c, d, 0, 4, 1, 5),
               yz2 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    const auto t = __builtin_shufflevector(tx, tx2, 0, 1, 4, 5),
               x = __builtin_shufflevector(tx, tx2, 2, 3, 6, 7);
    const auto y = __builtin_shufflevector(yz, yz2, 0, 1, 4, 5),
               z = __builtin_shufflevector(yz, yz2, 2, 3, 6, 7);
    const Floats4 force{static_cast<float>(points[0].force), static_cast<float>(points[stride].force),
                        static_cast<float>(points[2 * stride].force),
                        static_cast<float>(points[3 * stride].force)};
    const Floats4 used_z = depth ? z : Floats4{};
    std::memcpy(&space.t[k], &t, sizeof t);
    std::memcpy(&space.x[k], &x, sizeof x);
    std::memcpy(&space.y[k], &y, sizeof y);
    std::memcpy(&space.z[k], &used_z, sizeof used_z);
    std::memcpy(&space.force[k], &force, sizeof force);
    return x + y + z + force + t;
}

/// Copies the points as floats from the first point's place and time. Returns false if a value is not finite.
bool copy(Points stroke, Channels channels, ShapeSpace& space) {
    const std::size_t stride = (stroke.size() + counted_points - 1) / counted_points;
    const std::size_t first = (stroke.size() - 1) % stride;  // so that the last point counts
    const std::size_t count = (stroke.size() - 1 - first) / stride + 1;
    const auto& o = stroke[first];
    const Doubles4 origin{o.t, o.at.x, o.at.y, o.at.z};
    std::uint32_t bad = 0;
    for (std::size_t k = 0; k < count; k += count < 4 ? 1 : 4) {
        // The last four points overlap those before them. Of fewer than four, each is written four times, the last of
        // which the next one replaces.
        const std::size_t from = count < 4 ? k : std::min(k, count - 4), step = count < 4 ? 0 : stride;
        const auto sums =
            copy_four(&stroke[first + from * stride], step, origin, from, channels.depth, space);
        for (std::size_t i = 0; i < 4; ++i)
            bad |= static_cast<std::uint32_t>((std::bit_cast<std::uint32_t>(sums[i]) & exponent_bits) ==
                                              exponent_bits);
    }
    space.count = count;
    return bad == 0;
}

/// Puts the distance from each point to the next in `length`, from the second on.
void measure_steps(ShapeSpace& s) {
    for (std::size_t i = 1; i < s.count; ++i) {
        const float dx = s.x[i] - s.x[i - 1], dy = s.y[i] - s.y[i - 1], dz = s.z[i] - s.z[i - 1];
        s.length[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
    }
}

/// Drops points at the place of the point before, and sums the steps up.
void drop_rests(ShapeSpace& s) {
    std::size_t k = 0;
    float length = 0, latest = std::max(0.0F, s.t[0]);
    s.length[0] = 0;
    s.t[0] = latest;
    std::size_t i = 1;
    for (; i < s.count && s.length[i] > 0 && s.t[i] >= latest; ++i) {  // mostly all of them
        length += s.length[i];
        s.length[i] = length;
        latest = s.t[i];
    }
    k = i - 1;
    for (; i < s.count; ++i) {
        const float step = s.length[i];
        latest = std::max(latest, s.t[i]);  // a clock that runs backwards stands still
        if (!(step > 0)) {
            if (k == 0) s.t[0] = latest;  // a rest before the stroke is not part of it
            s.force[k] = std::max(s.force[k], s.force[i]);
            continue;
        }
        ++k;
        length += step;
        s.x[k] = s.x[i];
        s.y[k] = s.y[i];
        s.z[k] = s.z[i];
        s.force[k] = s.force[i];
        s.t[k] = latest;
        s.length[k] = length;
    }
    s.count = k + 1;
}

bool fill(Points stroke, Channels channels, ShapeSpace& space) {
    if (stroke.empty() || !all_finite_numbers(stroke) || !copy(stroke, channels, space)) return false;
    measure_steps(space);
    drop_rests(space);
    return std::isfinite(space.length[space.count - 1]);
}

/// The last point from `first` to before `last` whose place is below `wanted`; `first` if none is. The steps of the
/// search depend on the number of points alone, so the processor foresees them.
template <class Place>
std::size_t point_before(float wanted, std::size_t first, std::size_t last, Place place) {
    for (std::size_t count = last - first; count > 1;) {
        const std::size_t half = count / 2;
        first += place(first + half) < wanted ? half : 0;
        count -= half;
    }
    return first;
}

/// Parameter of each of the equally spaced points, and two more that no place reaches.
template <std::size_t points>
constexpr std::array<float, points + 2> wanted_places() {
    std::array<float, points + 2> wanted{};
    for (std::size_t i = 0; i < points; ++i)
        wanted[i] = static_cast<float>(i) / static_cast<float>(points - 1);
    wanted[points] = wanted[points + 1] = 1e30F;
    return wanted;
}

/// For each point of the shape, the last one of the stroke from `first` to before `last` whose place is below it;
/// `first` if none is. Instead of a search for each, each point of the stroke names the first of the shape beyond it.
template <std::size_t points>
std::array<std::uint32_t, points> points_before(const ShapeSpace& s, std::size_t first, std::size_t last) {
    static constexpr auto wanted = wanted_places<points>();
    std::array<std::uint32_t, points + 2> before{};
    for (std::size_t j = first; j < last; ++j) {
        const float place = s.place[j];
        auto i =
            static_cast<std::uint32_t>(static_cast<std::int32_t>(place * static_cast<float>(points - 1)));
        i = std::min(i, static_cast<std::uint32_t>(points - 1));
        i += wanted[i] <= place ? 1 : 0;
        i += wanted[i] <= place ? 1 : 0;  // the product above may have been rounded down
        before[i] = static_cast<std::uint32_t>(j);
    }
    std::array<std::uint32_t, points> result;
    auto latest = static_cast<std::uint32_t>(first);
    for (std::size_t i = 0; i < points; ++i) result[i] = latest = std::max(latest, before[i]);
    return result;
}

/// Places of the shape along the points, in arc length and time.
template <std::size_t points>
Sampled<points> resampled(ShapeSpace& s, std::size_t first, std::size_t last) {
    static constexpr auto wanted = wanted_places<points>();
    const float length = s.length[last] - s.length[first], seconds = s.t[last] - s.t[first];
    const float by_time = seconds > 0 ? time_share / seconds : 0;
    const float by_length = (seconds > 0 ? 1 - time_share : 1) / length;
    const auto place = [&](std::size_t i) {
        return by_length * (s.length[i] - s.length[first]) + by_time * (s.t[i] - s.t[first]);
    };
    const bool few = last - first < few_points;
    std::array<std::uint32_t, points> start;
    if (few) {
        for (std::size_t i = first; i <= last; ++i) s.place[i] = place(i);
        start = points_before<points>(s, first, last);
    } else {
        for (std::size_t i = 0; i < points; ++i)
            start[i] = static_cast<std::uint32_t>(point_before(wanted[i], first, last, place));
    }
    Sampled<points> out;
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t j = start[i];
        const float before = place(j), step = place(j + 1) - before;
        const float part = step > 0 ? std::clamp((wanted[i] - before) / step, 0.0F, 1.0F) : 0.0F;
        out.x[i] = s.x[j] + part * (s.x[j + 1] - s.x[j]);
        out.y[i] = s.y[j] + part * (s.y[j + 1] - s.y[j]);
        out.z[i] = s.z[j] + part * (s.z[j + 1] - s.z[j]);
        out.force[i] = s.force[j] + part * (s.force[j + 1] - s.force[j]);
    }
    return out;
}

template <std::size_t points>
float mean_of(const Column<points>& values) {
    float sum = 0;
    for (const float v : values) sum += v;
    return sum / static_cast<float>(points);
}

/// Subtracts the mean and returns the sum of squares of the rest.
template <std::size_t points>
float centre(Column<points>& values) {
    const float mean = mean_of(values);
    float sum = 0;
    for (float& v : values) {
        v -= mean;
        sum += v * v;
    }
    return sum;
}

template <std::size_t points>
void multiply(Column<points>& values, float factor) {
    for (float& v : values) v *= factor;
}

/// Moves the centroid to the origin, and scales. Returns the size, 0 if it is too small to divide by.
template <std::size_t points>
float normalise(Sampled<points>& q) {
    const float squares = centre(q.x) + centre(q.y) + centre(q.z);
    const float size = std::sqrt(squares / static_cast<float>(points));
    if (!(size > 1e-30F) || !std::isfinite(size)) return 0;
    for (auto* axis : {&q.x, &q.y, &q.z}) multiply(*axis, 1 / size);
    const float deviation = std::sqrt(centre(q.force) / static_cast<float>(points));
    multiply(q.force, deviation > 1e-6F ? force_deviation / deviation : 0);
    return size;
}

template <std::size_t points>
float squares_of(const Column<points>& values) {
    float sum = 0;
    for (const float v : values) sum += v * v;
    return sum;
}

/// Makes the axes of a normalised stroke more alike in size, and scales it again to a size of 1.
template <std::size_t points>
void even_out(Sampled<points>& q) {
    static_assert(axis_exponent == 0.5F);
    Column<points>* const axes[] = {&q.x, &q.y, &q.z};
    std::array<float, 3> squares{};
    float largest = 0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, squares[k] = squares_of(*axes[k]));
    float sum = 0;
    for (auto& s : squares) {
        const float size = std::sqrt(std::max(s, least_axis * least_axis * largest));
        sum += s / size;
        s = std::sqrt(size);
    }
    const float whole = std::sqrt(sum / static_cast<float>(points));
    for (std::size_t k = 0; k < 3; ++k) multiply(*axes[k], 1 / (whole * squares[k]));
}

template <std::size_t points>
struct Directions {
    Column<points> x{}, y{}, z{};
};

template <std::size_t points>
Directions<points> directions_of(const Sampled<points>& q) {
    Directions<points> d;
    const auto set = [&](std::size_t i, std::size_t a, std::size_t b) {
        const float x = q.x[b] - q.x[a], y = q.y[b] - q.y[a], z = q.z[b] - q.z[a];
        const float by = direction_weight / (std::sqrt(x * x + y * y + z * z) + slow_step);
        d.x[i] = x * by;
        d.y[i] = y * by;
        d.z[i] = z * by;
    };
    set(0, 0, 1);
    for (std::size_t i = 1; i + 1 < points; ++i) set(i, i - 1, i + 1);
    set(points - 1, points - 2, points - 1);
    return d;
}

template <std::size_t points>
void write_planar(const Sampled<points>& q, const Directions<points>& d, float turn, float* values) {
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = i + 1 < points ? i + 1 : points - 1;
        float* v = values + i * planar_channels;
        v[0] = q.x[i];
        v[1] = q.y[i];
        v[2] = d.x[i];
        v[3] = d.y[i];
        v[4] = turn * (d.x[a] * d.y[b] - d.y[a] * d.x[b]);
        v[5] = q.force[i];
    }
}

template <std::size_t points>
void write_solid(const Sampled<points>& q, const Directions<points>& d, float turn, float* values) {
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = i + 1 < points ? i + 1 : points - 1;
        float* v = values + i * solid_channels;
        v[0] = q.x[i];
        v[1] = q.y[i];
        v[2] = q.z[i];
        v[3] = d.x[i];
        v[4] = d.y[i];
        v[5] = d.z[i];
        v[6] = turn * (d.y[a] * d.z[b] - d.z[a] * d.y[b]);
        v[7] = turn * (d.z[a] * d.x[b] - d.x[a] * d.z[b]);
        v[8] = turn * (d.x[a] * d.y[b] - d.y[a] * d.x[b]);
        v[9] = q.force[i];
    }
}

}  // namespace

bool make_shape(ShapeSpace& s, std::size_t first, std::size_t last, Channels channels, Shape& shape) {
    if (last <= first) return false;
    shape.length = s.length[last] - s.length[first];
    shape.seconds = s.t[last] - s.t[first];
    if (!(shape.length > 0) || !std::isfinite(shape.length) || !std::isfinite(shape.seconds)) return false;
    auto q = resampled<shape_points>(s, first, last);
    shape.force = mean_of(q.force);
    if (!channels.force) q.force = {};
    if (!channels.depth) q.z = {};
    const float dx = q.x[shape_points - 1] - q.x[0], dy = q.y[shape_points - 1] - q.y[0],
                dz = q.z[shape_points - 1] - q.z[0];
    shape.gap = std::sqrt(dx * dx + dy * dy + dz * dz) / shape.length;
    shape.size = normalise(q);
    if (!(shape.size > 0)) return false;
    const auto d = directions_of(q);
    shape.channels = channels.depth ? solid_channels : planar_channels;
    if (channels.depth) {
        write_solid(q, d, turn_weight, shape.values.data());
    } else {
        write_planar(q, d, turn_weight, shape.values.data());
    }
    shape.start_t = s.t[first];
    shape.end_t = s.t[last];
    return true;
}

bool make_fine_shape(ShapeSpace& s, std::size_t first, std::size_t last, FineKind kind, FineShape& shape) {
    const float length = s.length[last] - s.length[first], seconds = s.t[last] - s.t[first];
    if (last <= first || !(length > 0) || !std::isfinite(length) || !std::isfinite(seconds)) return false;
    auto q = resampled<fine_points>(s, first, last);
    if (!kind.channels.force) q.force = {};
    if (!kind.channels.depth) q.z = {};
    if (!(normalise(q) > 0)) return false;
    if (kind.even) even_out(q);
    const auto d = directions_of(q);
    if (kind.channels.depth) {
        write_solid(q, d, fine_turn_weight, shape.data());
    } else {
        write_planar(q, d, fine_turn_weight, shape.data());
    }
    return true;
}

bool make_shape(Points stroke, Channels channels, ShapeSpace& space, Shape& shape) {
    return fill(stroke, channels, space) && space.count >= 2 &&
           make_shape(space, 0, space.count - 1, channels, shape);
}

}  // namespace thaum::gesture
