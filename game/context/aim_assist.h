// game/context/aim_assist.h: help with aiming for a player who turns the view by a stick or by keys. The
// player chooses its strength (input::DeviceSpec::aim_assist), which is in the log, so a replay gives the
// same help.
//
// It helps in three ways:
// - The view turns more slowly while the crosshair is on the foe or near it.
// - If the crosshair is less than 2 degrees beside the foe, and while the player does something, the view is
//   drawn to the place where a shot meets the foe.
// - A shot that would miss narrowly is turned by up to 2 degrees.
// It does not help through walls, nor under rules without it (assets/rules). Bots, scripts and arms get no
// help.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline context {

/// Angle between crosshair and foe within which the view is drawn towards the foe; also the largest angle by
/// which a shot is turned, at full strength (rad).
inline constexpr double max_pull = 2 * radians_per_degree;

/// Effect of aim assist on the view in one tick.
struct ViewHelp {
    double turn_share{1};  ///< share of the player's own turn that aim assist leaves: 1 without help
    double left{}, up{};   ///< added turn of the view towards the foe, if the player gives any input (rad)
};
/// Effect of aim assist on the view of a wizard in this tick. Reads Wizard, Gaze, WandBelt, Dead, Arm and
/// resource::Physics.
ViewHelp view_help(const MatchContext& context, ecs::Entity wizard);

/// Direction of a straight shot after aim assist (unit, world). `aim` is the direction before (unit, world),
/// `from` the start of the shot (m, world), `speed` its speed (m/s). Reads Wizard, Dead, Arm and
/// resource::Physics.
vec3 helped_aim(const MatchContext& context, ecs::Entity wizard, vec3 from, vec3 aim, double speed);

}  // namespace thaum::game::inline context
