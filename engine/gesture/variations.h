// gesture/variations.h: makes strokes as another user might draw them, and strokes that mean nothing, from
// templates.
//
// A variation is tilted, stretched, bent by slow waves, sped up and slowed down, cut or lengthened at its
// ends, and its force is scaled and varied by waves. A scribble is a chain of smooth turns, or the beginning
// of one gesture followed by the end of another. The same generator gives the same strokes on every
// processor.
#pragma once
#include <span>
#include <vector>

#include "core/random.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// Standard deviations of the random changes to a stroke. The defaults imitate how strokes of different users
/// differ.
struct VariationSettings {
    double tilt = 0.15;     ///< rotation about the z axis (rad)
    double stretch = 0.18;  ///< standard deviation of the logarithm of each axis's scale
    double bend = 0.05;     ///< amplitude of each wave of the shape (share of the size)
    double hurry = 0.35;    ///< standard deviation of the waves in the logarithm of the speed
    double ends = 0.04;     ///< length that is cut from each end (share of the arc length)
    double force = 0.3;     ///< standard deviation of the logarithm of the force level
};

/// A normally distributed number (sum of twelve uniform ones).
double normal(Random& random);

/// A stroke of the same gesture as another user might draw it.
std::vector<StrokePoint> variation_of(Points stroke, Random& random, const VariationSettings& settings = {});

/// A stroke that means nothing, as large as the templates.
std::vector<StrokePoint> scribble(std::span<const Gesture> gestures, Random& random);

}  // namespace thaum::gesture
