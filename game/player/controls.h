// game/player/controls.h: from a device's integer counts to what a wizard does with hands, feet and eyes.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// Every tick, in a pause too: fills Controls, turns Gaze (not in a pause).
void add_controls_system(Stage& stage, ecs::Schedule& schedule);

/// Gameplay has looked: what was pressed and turned is used up. The last gameplay system.
void add_controls_used_system(Stage& stage, ecs::Schedule& schedule);

/// Pause by either player, at once.
void add_pause_system(Stage& stage, ecs::Schedule& schedule);

/// How fast a stick at `deflection` (-127..127) turns, as a share of the full speed: fine in the middle, fast at the rim.
double stick_curve(std::int32_t deflection);

}  // namespace thaum::game
