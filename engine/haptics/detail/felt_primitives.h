// haptics/detail/felt_primitives.h: force on the hand by the haptic model's primitives (planes, lines, points
// and pushes) in one tick of the servo.
#pragma once
#include "haptics/detail/sources.h"
#include "haptics/servo.h"

namespace thaum::haptics {

/// Adds the force of the primitives to `sources`, the tick's forces by kind. Without primitives, the proxy
/// (the point that a spring ties to the tip) is at the tip. Returns true if the set of primitives appeared,
/// ended or jumped.
bool feel_primitives(ServoState& state, const HapticModel& model, const Tip& tip, Sources& sources);

}  // namespace thaum::haptics
