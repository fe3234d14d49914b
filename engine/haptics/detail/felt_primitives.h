// haptics/detail/felt_primitives.h: force of the model's primitives on the hand in one tick of the servo.
#pragma once
#include "haptics/detail/sources.h"
#include "haptics/servo.h"

namespace thaum::haptics {

/// Adds the force of the primitives to the sources. Without primitives, the proxy follows the tip. Returns
/// true if the set of primitives appeared, ended or jumped.
bool feel_primitives(ServoState& state, const HapticModel& model, const Tip& tip, Sources& sources);

}  // namespace thaum::haptics
