// game/settings/control_names.h: names of a player's controls on the screen.
#pragma once
#include "game/data/control_names.h"
#include "game/settings/settings.h"

namespace thaum::game::inline settings {

/// Names of the controls of one kind of device, by the present bindings: "E", "Left mouse", "RT". If an
/// action has several controls, the first is named. A player with an arm gets the names of the device used
/// beside it.
ControlNames control_names(const Settings& settings, input::DeviceKind kind);

}  // namespace thaum::game::inline settings
