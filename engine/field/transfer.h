// field/transfer.h: transfer functions, which map a value of the data to a strength, an opacity or another
// value.
//
//     y
//     |        .----.           A function is piecewise linear between at most 32 points and constant
//     |       /     |           beyond its first and last point. Two points with the same x make a jump.
//     |------'      '--------
//     +----------------------- x
//
// At a point the function has exactly the y of the point; at a jump, that of the later point. Between two
// points it never leaves the range of their y, and it rises or falls with x throughout. Points are finite: a
// coordinate that is not finite or is beyond 1e100 is limited to that range, and NaN becomes 0.
//
// Plain data without allocation, so a copy can be handed to the code that computes forces.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::field {

inline constexpr std::size_t max_transfer_points = 32;

/// A piecewise linear function of one value.
struct TransferFunction {
    std::array<vec2, max_transfer_points> points{};  ///< points (x, y), sorted by x; unused entries are zero
    std::uint64_t count{};                           ///< number of points in use; 0: the function is 0

    /// Value at x. NaN gives the y of the first point.
    double operator()(double x) const;
    bool operator==(const TransferFunction&) const = default;
};
static_assert(std::is_trivially_copyable_v<TransferFunction>);
static_assert(sizeof(TransferFunction) == max_transfer_points * sizeof(vec2) + sizeof(std::uint64_t));

/// A function with the same value everywhere.
TransferFunction constant(double y);

/// The window of radiology: `from` up to x = low, `to` from x = high on, linear between. With low = high it
/// jumps there; with low > high the ends change places.
TransferFunction window(double low, double high, double from, double to);

/// Makes a function from points in the order of x. The error names the first point that is not finite, is
/// beyond 1e100 or stands before an earlier one, or says that there are too many or none.
Expected<TransferFunction> transfer_function(std::span<const vec2> points);

/// Draws one point of a freehand curve. The curve can set the function at columns, values of x that are
/// multiples of `width`. The column nearest to x gets the value y. The function stays as it was at all other
/// columns and beyond, and becomes linear between columns next to this one. If all 32 points are in use, the
/// points that change the shape least are removed. A `width` that is not above 0, an x that is not finite and
/// a y that is NaN change nothing.
void draw(TransferFunction& f, double x, double y, double width);

/// Draws a piece of a freehand curve: sets the function at all columns (multiples of `width`) between two
/// positions of the mouse, on the straight line between them. A position that is not finite draws nothing.
void draw_stroke(TransferFunction& f, vec2 from, vec2 to, double width);

}  // namespace thaum::field
