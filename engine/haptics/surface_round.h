// haptics/surface_round.h: sliding along round surfaces in one move.
//
// Sliding with Coulomb's friction, the proxy moves in the direction of the pull's tangential part: it descends its
// distance
// to the tip along the surface until friction holds it. On a round surface this path has a closed form. Let psi be the
// angle
// about the core (the centre of a sphere, the axis of a cylinder) between the proxy and the tip, rho the tip's
// distance from the core, R
// the proxy's, and z their distance along the axis. Then the descent obeys
//
//     R psi' = -rho sin(psi),   z' = -z,   so that   z = z0 e,   tan(psi/2) = tan(psi0/2) e^(rho/R)
//
// with e from 1 to 0. On a sphere this is a great circle. Where two surfaces meet, the path is their curve, and the
// next place
// is a Newton step to the curve's place nearest to the tip. The place on the path where the pull leaves Coulomb's cone
// is a root
// of one variable, found to rounding; so is the place where the tip comes out and the proxy leaves the surface.
//
// The path is swept against all other surfaces along two tangents outside of the round ones, and halved where these
// meet
// something, so that the proxy moves through free space alone.
#pragma once
#include "haptics/surface_slide.h"

namespace thaum::haptics {

/// Whether one of the walls is the tangent plane of a round surface.
bool is_round(const Scene& scene, const Walls& walls, vec3 x);

/// Turns the walls of round surfaces to their tangent planes at x. Where there are some, drops the walls that do not
/// reach to x, unless the proxy met them there. `moved`: whether the last move brought the proxy to x.
void refresh_round(const Scene& scene, Walls& walls, vec3 x, bool moved);

enum class RoundEnd : std::uint8_t { rests, moved, limited };

struct RoundGoal {
    vec3 tip{};          ///< m
    vec3 tangent{};      ///< place nearest to the tip before the walls' tangent planes (m)
    bool was_sliding{};  ///< in the tick before
};

/// Moves the proxy along its walls, of which one at least is round, to where friction holds it, the walls let it go,
/// another
/// surface begins or the patch ends.
RoundEnd slide_round(const Scene& scene, SlideState& slide, const RoundGoal& goal);

}  // namespace thaum::haptics
