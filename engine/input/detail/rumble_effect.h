// input/detail/rumble_effect.h: converts tactile frames (amplitudes of all actuators at one moment) to
// effects of Linux's force feedback.
#pragma once
#include <linux/input.h>

#include "tactile/frame.h"

namespace thaum::input::detail {

/// Longest duration of an effect (ms).
inline constexpr Tick longest_rumble_ms = 500;

/// Effect that plays a frame for its time to live. The frame's first amplitude runs the strong motor, the
/// second one the weak motor. Amplitudes are rounded to the 255 steps that pads have, so that equal effects
/// need no new upload. NaN counts as 0. `id` is the effect to change; -1: a new one.
ff_effect rumble_effect(const tactile::TactileFrame& frame, std::int16_t id);

}  // namespace thaum::input::detail
