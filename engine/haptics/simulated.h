// haptics/simulated.h: a simulated force feedback device, held by a simulated hand. Mouse, gamepad and bots
// move the hand's target. Forces move the simulated device as they would move a real one.
//
//     target -- hand's spring, damper --[ mechanism + hand's mass ]-- viscous damping, dry friction -- ground
//                                                 ^ force: saturated, delayed
//
// The hand grips rigidly, so each axis has one body. Skin would need a second body on a spring of a few kN/m
// and 50 g. That pair rings above the servo's band, so at 1 kHz it cannot be told from a rigid grip. With one
// body, the motion and the moments at which dry friction stops and releases it have closed forms.
//
// The force is constant and the target moves evenly within a tick. The motion between a stop and the next
// release, or between a release and the next stop, is therefore exact (haptics/oscillator.h). The stop is the
// first zero of the velocity, found to rounding by a bracketed Newton's method. The release is the solution
// of a linear equation. The error of a tick is rounding only, with friction too. Dry friction acts on each
// axis by itself, like the friction of three joints, so along a diagonal it holds up to sqrt 3 times as much.
// Its static and sliding values are equal.
//
// Results have the same bits on every processor. No allocation. SimulatedState is the whole state.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "haptics/device.h"
#include "haptics/oscillator.h"

namespace thaum::haptics {

/// Simulated hand: a mass tied to a target by a spring and a damper. The defaults are assumed. They lie
/// between a loose arm and a firm grip of a stylus. The loose arm was measured on one person: 0.55 kg, 135
/// N/m, 6.5 N s/m (Scientific Reports 5:18004).
struct Hand {
    double mass = 0.15;      ///< mass of the hand (kg)
    double stiffness = 400;  ///< stiffness towards the target (N/m)
    double damping = 10;     ///< damping against the target's velocity (N s/m)
    /// Largest speed of the target (m/s); faster requests are followed at this speed.
    double max_target_speed = 3;
};

/// No hand: the bare device.
inline constexpr Hand no_hand{.mass = 0, .stiffness = 0, .damping = 0};

/// Constants of a simulated device and the hand that holds it.
struct SimulatedDevice {
    double mass{};          ///< mass of mechanism and hand, which move as one (kg)
    double stiffness{};     ///< stiffness of the spring from the hand's target to the tip (N/m)
    double hand_damping{};  ///< damping between hand and target (N s/m)
    double damping{};       ///< damping between device and ground (N s/m)
    double friction{};      ///< dry friction on each axis (N)
    double peak_force{};    ///< largest length of the force that the device exerts (N)
    double quantum{};       ///< motion of the tip per encoder count (m)
    vec3 reach{};           ///< half the edges of the workspace (m)
    double target_step{};   ///< largest motion of the target in a tick (m)
    int latency{};          ///< delay from a command to its force (ticks)
    double dt{};            ///< length of a tick (s)
    Oscillator oscillator{};
    /// Response of the oscillator (mass on the hand's spring and the dampers) over one tick.
    Response tick{};
};

/// Prepares a simulated device. `dt` is the length of a tick (s). The tick must be short against the hand's
/// oscillation: sqrt(stiffness / mass) dt <= 3.
SimulatedDevice simulated_device(const DeviceSpec& spec, const Hand& hand, double dt = tick_seconds);

/// State of a simulated device and its hand (device frame). It has no padding.
struct SimulatedState {
    vec3 position{};  ///< true position of the tip, not the measured one (m)
    vec3 velocity{};  ///< velocity of the tip (m/s); exactly zero on an axis that dry friction holds
    vec3 target{};    ///< place to which the hand wants to move the tip (m)
    vec3 force{};     ///< force that acted on the tip in the last tick (N)
    /// Commanded forces that have not acted yet, the next one first (N).
    std::array<vec3, max_latency> commanded{};
};
static_assert(sizeof(SimulatedState) == (4 + max_latency) * 3 * sizeof(double));

/// A device at rest, with the hand's target at the same position (m).
SimulatedState resting_at(vec3 position);

/// Position of the tip as the encoders report it (m): a whole number of quanta.
vec3 measured_position(const SimulatedDevice& device, const SimulatedState& state);

/// Advances the device by one tick. `target` is the target of the hand at the end of the tick (m). It is
/// clamped to the workspace and followed no faster than the hand can move. A target that is not finite is
/// ignored. `force` is the command computed from the position at the beginning of the tick (N). A force that
/// is not finite counts as zero. The end stops of the workspace are plastic and act at the end of the tick.
SimulatedState step(const SimulatedDevice& device, const SimulatedState& state, vec3 target, vec3 force);

/// Kinetic energy plus the energy of the hand's spring (J). It never grows while the target rests and no
/// force is commanded.
double energy(const SimulatedDevice& device, const SimulatedState& state);

}  // namespace thaum::haptics
