// haptics/servo.h: the servo step, a pure function from the device's measurement to its force.
//
//     servo_step(servo, state, model, sample) -> force
//
// It runs inside the tick for simulated devices, and in a thread at 1 kHz for a real one. It takes no lock,
// allocates nothing, opens no file and reads no clock. The haptic model is its only knowledge of the world: a
// small plain struct that the simulation makes in each tick. The cost therefore does not grow with the scene.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"
#include "haptics/energy.h"
#include "haptics/fluid_touch.h"
#include "haptics/primitives/balance.h"
#include "haptics/primitives/settling.h"
#include "haptics/pulse.h"
#include "haptics/safety.h"
#include "haptics/surface/surface.h"
#include "haptics/tether.h"
#include "haptics/tip.h"

namespace thaum::haptics {

/// Motion of the world in the device frame while the player turns or walks: a place p moves at velocity +
/// spin x p. The velocities of a patch's bodies include this motion. It is also given separately because it
/// must not push the hand.
struct FrameMotion {
    vec3 velocity{};  ///< velocity of the world at the frame's origin (m/s)
    vec3 spin{};      ///< angular velocity about the frame's origin (rad/s)
};

/// All that the servo knows of the world near the hand; the simulation publishes it in each tick.
struct HapticModel {
    Pulse pulse{};  ///< newest kick that the hand is to feel
    SteadyForce steady_force{};
    Tether tether{};
    bool on{true};  ///< the player wants forces
    bool panic{};   ///< a panic key is down
    bool rearm{};   ///< the player asks for forces again after a panic or shut-off
    /// Largest force chosen by the player (% of the device's peak); 0: the cap of Servo::limits.
    std::uint8_t force_percent{};
    /// Changes when the primitives (elementary forces on the proxy) jump, not when they move smoothly. A jump
    /// is a switch, which the safety stage fades.
    std::uint32_t set_number{};
    PrimitiveSet primitives{};  ///< forces on the proxy (m, N, device frame); usually empty, at no cost
    /// Spring and damper from the tip to the proxy on which the primitives act.
    ProxyCoupling coupling{.stiffness = 300};
    SurfacePatch patch{};  ///< surfaces near the tip; usually empty, at no cost
    /// Motion of the world as the player turns or walks; the bodies' motion includes it.
    FrameMotion frame_motion{};
    /// Viscosity of the space around the tip, for a hand that draws a stroke (N s/m); usually 0, at no cost.
    /// At most the damping that the device renders takes effect.
    double viscosity{};
    vec3 start{};  ///< place in free space at which the proxy of the surfaces starts after a jump (m)
    /// Changes when the patch (the surfaces near the tip) is a new one, as after a teleport; the force is
    /// then faded.
    std::uint64_t patch_number{};
    FluidTouch fluid{};  ///< fluid around the tip; usually number 0, at no cost
    /// How far the field from which the primitives are made (such as a crystal that turns) has moved at the
    /// tip since the last model (m). While it is 0, the force on a hand that rests hardly changes
    /// (haptics/primitives/settling.h).
    double field_motion{};
};
static_assert(sizeof(Pulse) == sizeof(vec3) + 2 * sizeof(std::uint32_t) &&
                  sizeof(SteadyForce) == sizeof(vec3) + 8 &&
                  sizeof(Detents) == sizeof(vec3) + (max_detents + 2) * sizeof(double) &&
                  sizeof(Tether) == 2 * sizeof(vec3) + 3 * sizeof(double) + sizeof(Detents) &&
                  sizeof(HapticModel) == sizeof(Pulse) + sizeof(SteadyForce) + sizeof(Tether) + 8 +
                                             sizeof(PrimitiveSet) + sizeof(ProxyCoupling) +
                                             sizeof(SurfacePatch) + sizeof(FrameMotion) + sizeof(vec3) + 24 +
                                             sizeof(FluidTouch),
              "no padding: the bytes of past models are hashed");

/// Input of the servo in one tick besides the haptic model: the device's measurement and the model's age.
struct ServoSample {
    vec3 position{};            ///< measured position of the tip (m, device frame)
    std::uint32_t model_age{};  ///< ticks since the haptic model was made
};

/// Constants of the servo: what the device can do, and the limits of its force.
struct Servo {
    SafetyLimits limits{};
    /// Largest damping that the device renders (N s/m). It limits a viscous space, a fluid's drag, and the
    /// brake that takes excess energy out of the hand; 0 switches them off.
    double max_damping{};
    int latency{};     ///< delay from a measured position to the force computed from it (ticks)
    double quantum{};  ///< motion of the tip per encoder count (m)
    /// Largest stiffness that the device renders (N/m). After a switch, springs that hold more energy than
    /// they received pull no harder than a spring of this stiffness with that energy; 0: no such limit.
    double max_stiffness{};
};

/// Servo constants of a device. `share` is the player's cap as a share of the device's peak, 0 to 1.
Servo servo_of(const DeviceSpec& spec, double share);

/// Limits of a servo whose player has chosen a largest force of `percent` of the
/// device's peak; 0: those of the servo.
SafetyLimits limits_of(const Servo& servo, std::uint32_t percent);

/// Bodies that were near the tip (in the patch of surfaces) in the last tick. A touched body that is not
/// among them is new, so its force may jump.
struct SeenBodies {
    std::array<double, surface_body_capacity> stiffness{};  ///< contact stiffness of each body (N/m)
    std::array<std::uint32_t, surface_body_capacity> keys{};
    std::uint64_t count{};
};

/// State of the servo, kept from tick to tick; no padding.
struct ServoState {
    SafetyState safety{};
    std::array<vec3, velocity_window> positions{};  ///< last measured positions of the tip (m), a ring buffer
    std::array<PlayingPulse, pulses_at_once> pulses{};
    /// Place on which the primitives acted last (m, device frame); at the tip without primitives.
    vec3 proxy{};
    std::uint32_t next_position{};
    std::uint32_t samples{};     ///< number of measured positions so far, up to velocity_window
    std::uint32_t last_pulse{};  ///< Pulse::number of the newest pulse that was started
    std::uint32_t next_pulse{};
    std::uint32_t primitives{};  ///< number of primitives that acted in the last tick
    std::uint32_t set_number{};  ///< HapticModel::set_number of the last tick; another one means a jump
    std::uint64_t steady_force_number{};
    std::uint64_t tether_number{};
    PassivityObserver energy{};
    SurfaceState surface{};
    /// Displacement from the tip to the point that touches surfaces (m). It takes up the depth by which the
    /// motion of the player's frame would have pressed the tip into them.
    vec3 contact_offset{};
    std::uint64_t patch_number{};
    FluidTouchState fluid{};
    double viscosity{};   ///< viscosity of the space that acted in the last tick (N s/m)
    Settling settling{};  ///< limits of the motion of the primitives' proxy
    SeenBodies seen{};
};
static_assert(sizeof(ServoState) ==
              sizeof(SafetyState) + velocity_window * sizeof(vec3) + pulses_at_once * sizeof(PlayingPulse) +
                  2 * sizeof(vec3) + 6 * sizeof(std::uint32_t) + 3 * sizeof(std::uint64_t) +
                  sizeof(PassivityObserver) + sizeof(SurfaceState) + sizeof(FluidTouchState) +
                  sizeof(double) + sizeof(Settling) + sizeof(SeenBodies));
static_assert(sizeof(SeenBodies) ==
              surface_body_capacity * (sizeof(double) + sizeof(std::uint32_t)) + sizeof(std::uint64_t));

/// Time constant with which ServoState::contact_offset decays if nothing is in the way (s).
inline constexpr double contact_offset_decay = 0.3;

/// Advances the servo by one tick. Returns the force for the device (N, device frame).
vec3 servo_step(const Servo& servo, ServoState& state, const HapticModel& model, const ServoSample& sample);

/// State for a device that is back after it was disconnected. It keeps the motors' heat, the safety stage's
/// counters and reasons for which the force stays zero, the used part of the energy budget, and the number of
/// the last pulse. The force starts at zero and grows slowly.
ServoState resumed(const ServoState& before);

}  // namespace thaum::haptics
