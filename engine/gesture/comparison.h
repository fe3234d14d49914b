// gesture/comparison.h: how a drawn stroke differs from a gesture, in numbers and in words for the player.
//
// The stroke and the gesture are resampled to points at equal distances along the way, in the plane of x and
// y, and moved and scaled to the same middle and size. The stroke is then turned, and for closed gestures
// begun elsewhere, so that the sum of the squared distances between the points is least. The root mean square
// of the remaining distances is the deviation. Recognition does not use these numbers.
#pragma once
#include <string>
#include <vector>

#include "gesture/gesture.h"

namespace thaum::gesture {

/// Differences between a stroke and a gesture, in numbers from which advice to the player is made.
struct Comparison {
    double size{};   ///< longer edge of the stroke's bounding box (m)
    double scale{};  ///< longer edge of the stroke's bounding box, as a multiple of the gesture's
    double gap{};    ///< distance from the stroke's end to its start (share of the size)
    double tilt{};   ///< angle by which the stroke is turned against the gesture, counterclockwise (rad)
    /// Root mean square distance of the stroke's points from those of the gesture (share of the size).
    double deviation{};
    /// Largest distance of a point of the stroke from that of the gesture (share of the size).
    double worst{};
    /// Place on the gesture at which this largest distance occurs, relative to the gesture's middle (share of
    /// the size).
    vec3 worst_place{};
    /// true if the stroke is drawn against the gesture's direction and the gesture's direction matters.
    bool backwards{};
};

/// Compares a stroke with that recorded stroke of a gesture which it resembles most. A stroke without two
/// different places gives zeros.
Comparison compare(Points stroke, const Gesture& gesture);

/// Advice to the player, the most important first, at most three lines: "draw it larger", "end where you
/// began". Empty if there is nothing to improve. `force` is the mean force of the stroke (N). `read`: true if
/// the stroke was recognised as this gesture, so that it was large enough.
std::vector<std::string> advice_on(const Comparison& comparison, const Gesture& gesture, double force,
                                   bool read);

/// Whether a stroke has the shape of the gesture, but is drawn in the wrong direction or turned too far,
/// which alone prevents its recognition.
bool is_turned_copy(const Comparison& comparison, const Gesture& gesture);

/// Words for a direction from the middle: "upper left", "right", "middle".
std::string place_words(vec3 from_middle);

}  // namespace thaum::gesture
