// gesture/trials/dot.h: the dot product of strokes as paper 000 (Mora and Lee 2008), section 8, prints it. It
// is a baseline for comparison; the recogniser that the game uses is in recogniser.h.
//
// "Since both our gesture templates and captured strokes have the same number of points after normalization,
// we model our gestures as normalized vectors. These are 4 x N dimensional vectors." Steps: scale to a size
// of 1, put points at a uniform distance, centre at the origin, make the vector a unit vector. The gesture of
// the template with the largest product is the result.
//
// The paper names dynamic time warping for the uniform distance; equal steps of arc length give
// exactly that. It does not say in which unit the force enters the vector: here in its own unit,
// after the scaling of the positions.
#pragma once
#include <array>

#include "gesture/stroke.h"

namespace thaum::gesture {

inline constexpr std::size_t dot_points = 32;

/// A unit vector of x, y, z and force of each point.
using StrokeVector = std::array<double, 4 * dot_points>;

/// Points at equal steps of arc length from the first to the last point of a stroke, interpolated linearly. A
/// stroke of one place gives that place everywhere. Needs at least one point.
std::array<StrokePoint, dot_points> equally_spaced(Points stroke);

/// Makes the vector of a stroke. Returns false for an empty stroke, one of a single
/// place, or values that are not finite.
bool make_vector(Points stroke, Channels channels, StrokeVector& vector);

/// Similarity of two strokes: 1 for equal vectors, less otherwise.
double dot_product(const StrokeVector& a, const StrokeVector& b);

}  // namespace thaum::gesture
