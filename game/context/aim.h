// game/context/aim.h: a direction of view as two angles.
#pragma once
#include "core/maths.h"

namespace thaum::game::inline context {

/// Direction of view, as two angles.
struct Aim {
    double yaw{}, pitch{};  ///< yaw counted to the left from -z, pitch upwards (rad)
};

/// Direction of view from the eye towards a position.
Aim aim_at(vec3 eye, vec3 target);

/// Signed angle from the first direction to the second, the shorter way round (rad).
double angle_between(double from, double to);

}  // namespace thaum::game::inline context
