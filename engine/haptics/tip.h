// haptics/tip.h: motion of the device's tip, from the last positions that the servo has seen.
#pragma once
#include <cstddef>

#include "core/maths.h"

namespace thaum::haptics {

struct ServoState;

inline constexpr std::size_t velocity_window = 8;  ///< ticks over which the tip's velocity is measured

/// Motion of the tip in one tick (device frame), and whether the force on it jumps or has to end.
struct Tip {
    vec3 position{};      ///< measured position (m)
    vec3 velocity{};      ///< velocity over the last `velocity_window` ticks (m/s)
    double path_speed{};  ///< speed along the path; also a tip that vibrates in place is fast (m/s)
    bool switched{};      ///< a source of force on the tip, such as a tether, appeared, ended or jumped
    bool jumps{};         ///< the force may jump in this tick: a source switched, or a push was cut off
    bool stops{};         ///< the force has to end: the haptic model is stale, or the player wants no forces
};

/// Stores a measured position of the tip. Returns it with the tip's motion. `quantum` is the device's
/// distance between two measurable positions (m).
Tip move_tip(ServoState& state, vec3 position, double quantum);

/// Mean velocity of the tip over the stored positions (m/s); zero before the second position.
vec3 tip_velocity(const ServoState& state);

/// Smallest deviation from a line that counts as motion, not noise (m).
inline constexpr double finest_motion = 5e-5;

/// Velocity of the tip (m/s) with the least delay that the quantum (m) allows. It is the mean over the
/// longest part of the window in which the samples lie on a line. The tolerance is one quantum, or
/// `finest_motion` if that is larger. At rest this part is the whole window, in a quick turn two samples. A
/// damper that acts on a velocity of four ticks ago excites a stiff spring instead of calming it. Source:
/// first-order adaptive windowing, Janabi-Sharifi, Hayward and Chen 2000.
vec3 prompt_velocity(const ServoState& state, double quantum);

/// Motion of the tip in the last tick that the servo has seen, by `prompt_velocity` (m).
vec3 tip_motion(const ServoState& state, double quantum);

/// Speed along the path from sample to sample, less the part that the rounding of positions to a quantum (m)
/// can add (m/s). A tip that vibrates between two places has no velocity over the window but is fast. The
/// mean is over the window because samples may come late and then close together.
double path_speed(const ServoState& state, double quantum);

}  // namespace thaum::haptics
