// gesture/variations.h: strokes as another user might draw them, and strokes that mean nothing, made from templates.
//
// A variation is tilted, stretched, bent by slow waves, hurried and slowed, cut or lengthened at its ends, and its
// force has another level and waves of its own. A scribble is a chain of smooth turns, or the beginning of
// one gesture followed by the end of another. The same generator gives the same strokes on every processor.
#pragma once
#include <span>
#include <vector>

#include "core/random.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// Standard deviations of a variation. The defaults are the differences between users.
struct VariationSettings {
    double tilt = 0.15;     ///< turn about the z axis (rad)
    double stretch = 0.18;  ///< logarithm of the scale of each axis
    double bend = 0.05;     ///< each wave of the shape (share of the size)
    double hurry = 0.35;    ///< waves of the logarithm of speed
    double ends = 0.04;     ///< length that is cut from each end (share of the arc length)
    double force = 0.3;     ///< logarithm of the level of force
};

/// A normally distributed number (sum of twelve uniform ones).
double normal(Random& random);

std::vector<StrokePoint> variation_of(Points stroke, Random& random, const VariationSettings& settings = {});

/// A stroke that means nothing, of the size of the templates.
std::vector<StrokePoint> scribble(std::span<const Gesture> gestures, Random& random);

}  // namespace thaum::gesture
