// haptics/pulse.h: forces that push the hand wherever its tip is: pulses and a steady force. A switch is a
// jump of a force, which the safety stage fades.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"

namespace thaum::haptics {

struct ServoState;

/// A kick: half a sine wave over `length` ticks. An active source: it may push the hand. It starts and ends
/// at zero, so it is no switch, and the safety stage passes it unchanged. The stage's slew limit of 40 N/s
/// would leave little of a kick: 1.2 N in 15 ms rises at 251 N/s.
struct Pulse {
    vec3 peak{};             ///< largest force (N, device frame)
    std::uint32_t length{};  ///< duration, > 0 (ticks)
    std::uint32_t number{};  ///< counts up from 1 from pulse to pulse; a new number starts the pulse
};

/// A force that changes slowly and does not depend on the tip's position, such as the pull of a growing
/// charge or a weight. An active source: it may push the hand.
struct SteadyForce {
    vec3 force{};  ///< force on the hand (N, device frame)
    /// Changes when the force jumps, which is a switch: the safety stage then fades it.
    std::uint64_t number{};
};

/// Number of pulses that can play at once. A further pulse replaces the oldest one, which is a switch.
inline constexpr std::size_t pulses_at_once = 4;

/// A pulse (kick) that has begun.
struct PlayingPulse {
    vec3 peak{};
    std::uint32_t length{};
    std::uint32_t at{};  ///< number of ticks played so far; equal to `length` at the end
};

/// Mean force of a pulse over its tick `at`, as a share of its peak. As it is the mean, the impulse of a
/// whole pulse is exactly that of half a sine wave: 2/pi times peak times duration.
double half_sine(std::uint32_t at, std::uint32_t length);

/// Force of pulses and steady force in one tick.
struct PushForce {
    vec3 force{};     ///< force on the hand (N)
    bool cut_off{};   ///< a new pulse ended one that was playing
    bool switched{};  ///< the steady force jumped
};

/// Starts the newest pulse unless it has been started before. Advances all playing pulses by one tick, and
/// returns the sum of their forces and the steady force.
PushForce feel_pushes(ServoState& state, const Pulse& newest, const SteadyForce& steady);

}  // namespace thaum::haptics
