// game/match/player/controls.h: decodes the integer counts of a device's sample into what a wizard does with
// hands, feet and view.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Adds the system that fills in Controls every tick, also in a pause. It also turns Gaze, but not in a
/// pause.
void add_controls_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the system that clears button presses and wheel steps after use. It must be the last gameplay system.
void add_controls_used_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the system with which either player can pause the match at once.
void add_pause_system(MatchContext& context, ecs::Schedule& schedule);

/// Turning rate of a stick at `deflection` (-127 to 127) as a share of the full rate: slow near the middle,
/// fast near the rim.
double stick_curve(std::int32_t deflection);

}  // namespace thaum::game::inline match
