// game/settings/control_names.h: how a player's controls are called on the screen.
#pragma once
#include "game/data/control_names.h"
#include "game/settings/settings.h"

namespace thaum::app {

/// Names of the controls of one kind of device, as they are bound now: "E", "Left mouse", "RT". Of several controls
/// for an action, the first is named. An arm's hand has the names of the device beside it.
game::ControlNames control_names(const Settings& settings, input::DeviceKind kind);

}  // namespace thaum::app
