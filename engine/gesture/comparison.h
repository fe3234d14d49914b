// gesture/comparison.h: how a drawn stroke differs from a gesture, in figures and in words for the player.
//
// Both are resampled to points at equal distances along the way, in the plane of x and y, and moved and scaled to the
// same middle and size. The stroke is then turned, and for closed gestures begun elsewhere, so that the sum of the squared
// distances between the points is least. What is left is the deviation. No part of a recognition uses these figures.
#pragma once
#include <string>
#include <vector>

#include "gesture/gesture.h"

namespace thaum::gesture {

struct Comparison {
    double size{};       ///< longer edge of the stroke's box (m)
    double scale{};      ///< size of the stroke, as a multiple of the gesture's
    double gap{};        ///< distance from the stroke's end to its start (share of the size)
    double tilt{};       ///< angle by which the stroke is turned against the gesture, counterclockwise (rad)
    double deviation{};  ///< root mean square distance of its points (share of the size)
    double worst{};      ///< largest distance of a point (share of the size)
    vec3 worst_place{};  ///< place of that point in the gesture, from its middle (share of the size)
    bool backwards{};    ///< true if the stroke is drawn against the gesture's direction, which counts
};

/// Compares a stroke with the nearest stroke of a gesture. A stroke without two places has zeros.
Comparison compare(Points stroke, const Gesture& gesture);

/// What to do better, the gravest first, at most three lines: "draw it larger", "end where you began". Empty if there is
/// nothing. `force` is the mean force (N). `read`: the stroke was read as this gesture; then it was large enough.
std::vector<std::string> advice_on(const Comparison& comparison, const Gesture& gesture, double force,
                                   bool read);

/// Whether a stroke has the shape of the gesture and is left unread only by its direction or its turn.
bool is_turned_copy(const Comparison& comparison, const Gesture& gesture);

/// Words for a direction from the middle: "upper left", "right", "middle".
std::string place_words(vec3 from_middle);

}  // namespace thaum::gesture
