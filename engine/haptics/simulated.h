// haptics/simulated.h: a force feedback device made of numbers, held by a hand made of numbers. Mouse, pad and bots hold
// one: they move the hand's target, so that forces move the probe as they would a real one.
//
//     target ---- hand's spring and damper ----[ mechanism + hand's mass ]---- viscous damping, dry friction ---- ground
//                                                        ^ force: saturated, delayed
//
// The hand grips rigidly: one body on each axis. Skin would make two, joined by a spring so stiff (a few kN/m on 50 g) that it
// rings above the servo's own band and cannot be told from a rigid grip at 1 kHz; and with one body both the motion and
// the moments at which dry friction stops it and lets go have closed forms.
//
// In a tick the force is constant and the target moves evenly, so between two such moments the motion is exact
// (haptics/oscillator.h). The moment of a stop is the first zero of the velocity, found by a bracketed Newton's method to
// rounding; the moment of letting go is a linear equation. So the error of a tick is that of rounding, with friction too.
// Dry friction acts on each axis by itself, as the friction of three joints does, with equal static and sliding values: along
// a diagonal it holds up to sqrt 3 times as much.
//
// The same bits on every processor. No allocation. SimulatedState is all that a tick leaves behind.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "haptics/device.h"
#include "haptics/oscillator.h"

namespace thaum::haptics {

/// A mass on a spring and damper to where it wants to be. The defaults are assumed: between a loose arm (measured in one
/// person: 0.55 kg, 135 N/m, 6.5 N s/m; Scientific Reports 5:18004) and a firm grip of a stylus.
struct Hand {
    double mass = 0.15;           ///< kg
    double stiffness = 400;       ///< N/m
    double damping = 10;          ///< N s/m, against the target's velocity
    double max_target_speed = 3;  ///< m/s, of its target; what asks for more is followed at this speed
};

/// The bare device.
inline constexpr Hand no_hand{.mass = 0, .stiffness = 0, .damping = 0};

/// What no tick changes.
struct SimulatedDevice {
    double mass{};          ///< kg, mechanism and hand
    double stiffness{};     ///< N/m, the hand's
    double hand_damping{};  ///< N s/m, to the target
    double damping{};       ///< N s/m, to the ground
    double friction{};      ///< N, on each axis
    double peak_force{};    ///< N
    double quantum{};       ///< m
    vec3 reach{};           ///< m, half the workspace
    double target_step{};   ///< m, the most that the target moves in a tick
    int latency{};          ///< ticks
    double dt{};            ///< s, of a tick
    Oscillator oscillator{};
    Response tick{};  ///< over dt
};

/// dt in s, so short that the held device takes more than a sixth of a second-order period: sqrt(stiffness / mass) dt <= 3.
SimulatedDevice simulated_device(const DeviceSpec& spec, const Hand& hand, double dt = tick_seconds);

/// Device frame. 12 vectors of doubles without padding.
struct SimulatedState {
    vec3 position{};                             ///< m, of the tip: true, not as measured
    vec3 velocity{};                             ///< m/s; exactly zero on an axis that dry friction holds
    vec3 target{};                               ///< m, of the hand
    vec3 force{};                                ///< N, that acted on the tip in the last tick
    std::array<vec3, most_latency> commanded{};  ///< N, on their way: first the one that acts next
};
static_assert(sizeof(SimulatedState) == (4 + most_latency) * 3 * sizeof(double));

/// At rest, the hand wanting to be there.
SimulatedState resting_at(vec3 position);

/// Where the encoders say that the tip is, m: a whole number of quanta.
vec3 measured_position(const SimulatedDevice& device, const SimulatedState& state);

/// One tick. target (m) is where the hand wants to be at its end; it is kept in the workspace, and followed not faster than
/// the hand can; one that is not finite is ignored. force (N) is the command computed from the position at its beginning;
/// one that is not finite counts as zero. The end stops of the workspace are plastic and act at the end of the tick.
SimulatedState step(const SimulatedDevice& device, const SimulatedState& state, vec3 target, vec3 force);

/// J, of motion and of the hand's spring: never grows while the target rests and no force is commanded.
double energy(const SimulatedDevice& device, const SimulatedState& state);

}  // namespace thaum::haptics
