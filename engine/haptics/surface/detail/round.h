// haptics/surface/detail/round.h: sliding along round surfaces in one move.
//
// A proxy that slides with Coulomb friction moves in the direction of the pull's tangential part. It thus
// reduces its distance to the tip along the surface until friction holds it. On a round surface this path has
// a closed form. The core is the centre of a sphere or the axis of a cylinder. Let psi be the angle about the
// core between the proxy and the tip, rho the tip's distance from the core, R the proxy's, and z their
// distance along the axis. Then the descent obeys
//
//     R psi' = -rho sin(psi),   z' = -z,   so that   z = z0 e,   tan(psi/2) = tan(psi0/2) e^(rho/R)
//
// with e from 1 to 0. On a sphere this is a great circle. If two surfaces meet, the path is their
// intersection curve. The next place is then a Newton step towards the curve's point nearest to the tip. The
// pull leaves Coulomb's cone at a root of one variable, found to rounding. The place where the tip comes out
// and the proxy leaves the surface is also such a root.
//
// The path is swept against all other surfaces along two tangents outside the round surfaces. If they meet
// something, the path is halved. So the proxy moves through free space only.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Whether one of the walls (planes at the touched surfaces) is the tangent plane of a round surface.
bool is_round(const Scene& scene, const Walls& walls, vec3 x);

/// Turns the walls (planes at the touched surfaces) of round surfaces to their tangent planes at x. If there
/// are such walls, removes all walls whose surface does not reach x, unless the proxy has just met it there.
/// `moved`: the last move has changed the proxy's place.
void refresh_round(const Scene& scene, Walls& walls, vec3 x, bool moved);

enum class RoundEnd : std::uint8_t { rests, moved, limited };

struct RoundGoal {
    vec3 tip{};          ///< position of the tip (m)
    vec3 tangent{};      ///< place nearest to the tip that is in front of all tangent planes (m)
    bool was_sliding{};  ///< the proxy slid in the last tick
};

/// Moves the proxy along its walls (planes at the touched surfaces), at least one of which is of a round
/// surface. It stops where friction holds it, the walls release it, another surface begins, or the space ends
/// whose surfaces are known.
RoundEnd slide_round(const Scene& scene, SlideState& slide, const RoundGoal& goal);

}  // namespace thaum::haptics
