// gesture/shape.h: a stroke with time, place and size taken away, so that two
// strokes can be compared point by point.
//
// Steps:
//   1. Rests before, within and after the stroke are removed, also those of a hand that trembles (rests.h),
//      as are points at the place of the point before them.
//   2. The stroke is resampled to 24 points. They are equally spaced in 0.7 of the arc length plus 0.3 of the
//      time, each from 0 to 1. Slow parts (corners) get more points than by arc length alone.
//   3. The centroid moves to the origin and the root mean square distance from it becomes 1.
//   4. Each point gets its direction of motion, how sharply the stroke turns there, and the force, which is
//      centred and scaled to a variance of 0.25. Raw force in the vector of positions harms recognition
//      (GESTURE.md).
//
// All arithmetic is in float with a fixed order, so a shape has the same bits on every processor.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "gesture/stroke.h"

namespace thaum::gesture {

inline constexpr std::size_t shape_points = 24;
/// Number of points of a stroke that are used. A longer stroke is thinned evenly, which hardly changes the 24
/// points of the shape.
inline constexpr std::size_t counted_points = 80;
inline constexpr std::size_t max_points = 4096;  ///< largest number of points in a ShapeSpace (working
                                                 ///< memory for strokes) that a caller fills itself
/// Number of channels of a planar shape, numbers at each point: x, y, direction x, y, turn z, force.
inline constexpr std::size_t planar_channels = 6;
/// Number of channels of a solid shape, numbers at each point: x, y, z, direction x, y, z, turn x, y, z,
/// force.
inline constexpr std::size_t solid_channels = 10;
inline constexpr std::size_t max_channels = solid_channels;

/// A stroke with place, size and time taken away, so that strokes can be compared point by point.
struct Shape {
    /// Number of channels: planar_channels or solid_channels.
    std::size_t channels{};
    /// Value of a channel at a point: values[point * channels + channel].
    std::array<float, shape_points * max_channels> values{};
    float size{};    ///< root mean square distance from the centroid (unit of the stroke)
    float length{};  ///< arc length (unit of the stroke)
    /// Time from the first to the last point that is not left out as a rest (s).
    float seconds{};
    float force{};  ///< mean force along the path (unit of the stroke)
    float gap{};    ///< distance from start to end, divided by the arc length
    /// Time from the stroke's first point to its first point that is not left out as a rest (s).
    float start_t{};
    /// Time from the stroke's first point to its last point that is not left out as a rest (s).
    float end_t{};
};

/// A shape for closer comparison. It has more points, and the difference between the axes' sizes is reduced
/// by half (each axis is divided by the square root of its size), because users differ in how wide and how
/// high they draw.
inline constexpr std::size_t fine_points = 32;
using FineShape = std::array<float, fine_points * max_channels>;  ///< values: [point * channels + channel]

/// Kind of a fine shape: its channels, and whether the sizes of its axes are made more alike.
struct FineKind {
    Channels channels{};
    bool even = true;  ///< false: keep the ratio of the axes' sizes, for a gesture that may be turned
};

/// Share of time in the parameter by which a stroke is resampled, 0 to 1; the rest is arc length.
inline constexpr float time_share = 0.3F;

/// Force and place of a point.
struct ShapePoint {
    float force{}, x{}, y{}, z{};
};

/// Working memory in which a stroke becomes a shape: its points, with their times and arc lengths.
struct ShapeSpace {
    std::array<ShapePoint, max_points> points{};
    std::array<float, max_points> t{};
    std::array<float, max_points> length{};  ///< arc length up to each point
    std::array<float, max_points> place{};   ///< scratch memory: parameter by which the points are resampled
    std::size_t count{};
    float before{};  ///< duration of a rest that was removed from the start of the stroke (s)
    float paused{};  ///< removed time of rests within the stroke (s)
};

/// Whether the time for which the hand rests is removed from a stroke (rests.h). It is kept in a part that a
/// caller has cut out of continuous motion.
enum class Rests : std::uint8_t { left_out, kept };

/// Makes the shape of a stroke. Returns false for a stroke without two different places or with a value
/// that is not finite. No allocation.
bool make_shape(Points stroke, Channels channels, ShapeSpace& space, Shape& shape,
                Rests rests = Rests::left_out);

/// Makes the shape of the points in `space` from `first` to `last`, both included. `length` has the arc
/// length up to each point. For callers that write the points into the space themselves.
bool make_shape(ShapeSpace& space, std::size_t first, std::size_t last, Channels channels, Shape& shape);

/// Makes the fine shape of the points in `space` from `first` to `last`, both included. The first call of
/// `make_shape` with a stroke fills the space.
bool make_fine_shape(ShapeSpace& space, std::size_t first, std::size_t last, FineKind kind, FineShape& shape);

}  // namespace thaum::gesture
