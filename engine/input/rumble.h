// input/rumble.h: the two motors of a game pad, by Linux's force feedback (evdev).
//
// The layout `pad` has two actuators. The left one stands for the strong motor, which sits in the left hand,
// and the right one for the weak motor. The motors take no carrier frequency. Each effect ends by itself
// after the frame's time to live, and the system ends it when the program does, so no motor stays on.
#pragma once
#include <memory>

#include "input/pad_state.h"
#include "input/tactile_output.h"

namespace thaum::input {

/// The motors of a pad that is plugged in. Nothing is opened yet.
std::unique_ptr<TactileOutput> rumble_output(const PadState& pad);

}  // namespace thaum::input
