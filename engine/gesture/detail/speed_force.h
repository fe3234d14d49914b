// gesture/detail/speed_force.h: detects recorded strokes whose force only follows the speed of the hand.
//
// A mouse feels no force, and a pen in the air meets none. So the game records the force of a viscous fluid
// instead, a multiple of the hand's speed. But the shape of a stroke already shows the speed, because its
// points are spaced by length and time, so such a force adds no information. Where a mouse is moved evenly,
// it adds noise.
#pragma once
#include <optional>
#include <span>

#include "gesture/gesture.h"

namespace thaum::gesture {

/// Share of a stroke's force that is no multiple of its speed: 0 for a force that is proportional to speed,
/// as in a viscous fluid, up to 1. It is a share of the mean square, taken over twelve equally long parts of
/// the stroke. std::nullopt for a stroke without force, times or length.
std::optional<double> force_beside_speed(Points stroke);

/// Whether the force of most recorded strokes follows their speed to within a tenth. All strokes are taken to
/// come from one device, so the force counts for all gestures or for none. False where no stroke has a force.
bool force_follows_speed(std::span<const Gesture> gestures);

}  // namespace thaum::gesture
