// haptics/servo.h: the servo step, one pure function from what the device measures to the force it is told:
//
//     servo_step(servo, state, model, sample) -> force
//
// It runs inside the tick for simulated devices, and is what a thread at 1 kHz runs for a real one: no lock, no
// allocation, no file, no clock. The model is all that it knows of the world: a small plain struct that the simulation makes each
// tick, so that the cost does not grow with the scene.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"
#include "haptics/balance.h"
#include "haptics/energy.h"
#include "haptics/fluid_touch.h"
#include "haptics/safety.h"
#include "haptics/surface.h"

namespace thaum::haptics {

/// A kick: half a sine wave over `length` ticks. An active source: it may push the hand. It starts and ends at zero, so it is
/// no switch for the slew limit, which would leave little of it: 1.2 N in 15 ms rises at 251 N/s.
struct Pulse {
    vec3 peak{};             ///< N, device frame
    std::uint32_t length{};  ///< ticks, > 0
    std::uint32_t number{};  ///< from 1, counts up; one newer than the servo has seen starts a pulse
};

/// A force that changes slowly and does not depend on where the tip is: a charge that grows, a weight. An active source.
struct Lean {
    vec3 force{};            ///< N, device frame
    std::uint64_t number{};  ///< another one where the force jumps, which is a switch
};

inline constexpr std::size_t most_detents = 3;

/// Notches along a line, each drawing the tip to its middle: the negative slope of a potential, so they create no energy.
struct Detents {
    vec3 axis{};                                ///< unit, device frame; through the tether's anchor
    std::array<double, most_detents> places{};  ///< m, along the axis from the anchor
    double depth{};                             ///< N, where they draw most; 0: there are none
    double width{};                             ///< m, of each, > 0; not more than they are apart
};

/// A spring and damper from the tip to a point: a held thing, a slingshot. A passive source where the point stands still; where
/// it is a thing of the world, the world gets the opposite force.
struct Tether {
    vec3 anchor{};           ///< m, device frame
    vec3 anchor_velocity{};  ///< m/s
    double stiffness{};      ///< N/m; 0: there is none
    double damping{};        ///< N s/m
    Detents detents{};
    std::uint64_t number{};  ///< another one where it comes, goes or jumps, which is a switch
};

/// How the world moves over the device's frame because who holds it turns or walks: a place p by velocity + spin x p. The bodies of
/// a patch move by it too; here it stands by itself, because it may not push the hand.
struct Drift {
    vec3 velocity{};  ///< m/s
    vec3 spin{};      ///< rad/s, about the frame's origin
};

/// What the simulation publishes each tick.
struct HapticModel {
    Pulse pulse{};  ///< the newest
    Lean lean{};
    Tether tether{};
    bool on{true};  ///< the player wants forces
    bool panic{};   ///< somebody's panic key is down
    bool rearm{};
    std::uint8_t spare{};
    std::uint32_t
        set_number{};  ///< another one where the primitives jump, which is a switch; not where they glide
    PrimitiveSet primitives{};                 ///< device frame, m; empty, the usual case: they cost nothing
    ProxyCoupling coupling{.stiffness = 300};  ///< of the tip to the proxy that the primitives act on
    SurfacePatch patch{};                      ///< empty, the usual case: it costs nothing
    Drift drift{};                             ///< of its surfaces
    vec3 start{};                              ///< m, where the proxy begins after a jump: a free place
    std::uint64_t patch_number{};              ///< another one where the patch jumps, which is a switch
    FluidTouch fluid{};                        ///< number 0, the usual case: it costs nothing
};
static_assert(sizeof(Pulse) == sizeof(vec3) + 2 * sizeof(std::uint32_t) && sizeof(Lean) == sizeof(vec3) + 8 &&
                  sizeof(Detents) == sizeof(vec3) + (most_detents + 2) * sizeof(double) &&
                  sizeof(Tether) == 2 * sizeof(vec3) + 3 * sizeof(double) + sizeof(Detents) &&
                  sizeof(HapticModel) == sizeof(Pulse) + sizeof(Lean) + sizeof(Tether) + 8 +
                                             sizeof(PrimitiveSet) + sizeof(ProxyCoupling) +
                                             sizeof(SurfacePatch) + sizeof(Drift) + sizeof(vec3) + 8 +
                                             sizeof(FluidTouch),
              "no padding: the bytes of past models are hashed");

/// What a device measured.
struct ServoSample {
    vec3 position{};            ///< m, device frame
    std::uint32_t model_age{};  ///< ticks since the model was made
};

/// What no tick changes.
struct Servo {
    SafetyLimits limits{};
    double most_damping{};  ///< N s/m, that the device can render: what the passivity controller may add, and
                            ///< what a fluid's drag may be; 0: there is neither
    int latency{};          ///< ticks, the device's
    double quantum{};       ///< m, of its positions
};

/// share: the player's cap as a part of the device's peak, 0 to 1.
Servo servo_of(const DeviceSpec& spec, double share);

inline constexpr std::size_t pulses_at_once = 4;   ///< a fifth takes the place of the oldest: a switch
inline constexpr std::size_t velocity_window = 8;  ///< ticks over which the tip's velocity is taken

struct PlayingPulse {
    vec3 peak{};
    std::uint32_t length{};
    std::uint32_t at{};  ///< ticks played; == length: over
};

/// All that a tick leaves behind; no padding.
struct ServoState {
    SafetyState safety{};
    std::array<vec3, velocity_window> positions{};  ///< a ring of the last samples
    std::array<PlayingPulse, pulses_at_once> pulses{};
    vec3 proxy{};  ///< m, device frame; the tip where there are no primitives
    std::uint32_t next_position{};
    std::uint32_t samples{};     ///< so far, up to velocity_window
    std::uint32_t last_pulse{};  ///< number of the newest that was started
    std::uint32_t next_pulse{};
    std::uint32_t primitives{};  ///< how many acted in the last tick
    std::uint32_t set_number{};  ///< of these
    std::uint64_t lean_number{};
    std::uint64_t tether_number{};
    EnergyBook energy{};
    SurfaceState surface{};
    vec3
        shift{};  ///< m, from the tip to where it feels surfaces: what the drift would have pressed into them
    std::uint64_t patch_number{};
    FluidTouchState fluid{};
};
static_assert(sizeof(ServoState) == sizeof(SafetyState) + velocity_window * sizeof(vec3) +
                                        pulses_at_once * sizeof(PlayingPulse) + 2 * sizeof(vec3) +
                                        6 * sizeof(std::uint32_t) + 3 * sizeof(std::uint64_t) +
                                        sizeof(EnergyBook) + sizeof(SurfaceState) + sizeof(FluidTouchState));

inline constexpr double shift_time = 0.3;  ///< s, in which the shift fades where nothing is in the way

/// The force for the device, N, device frame.
vec3 servo_step(const Servo& servo, ServoState& state, const HapticModel& model, const ServoSample& sample);

/// What is left of the state after a device was out of touch: how warm its motors are, what was latched and counted, what of the
/// energy budget is used up, and which pulses are over. The force begins at zero, and slowly.
ServoState resumed(const ServoState& before);

/// m/s, of the tip, over the window or what there is of it; zero before the second sample.
vec3 tip_velocity(const ServoState& state);

inline constexpr double finest_motion =
    5e-5;  ///< deviation from a line that is taken for noise, at least (m)

/// Velocity of the tip with the least delay that the quantum (m) allows: the mean over the longest part of the window in which the
/// samples lie on a line within one quantum, but at least `finest_motion` (m/s). At rest that is the whole window, in a quick turn two
/// samples. A damper that acts on a velocity of four ticks ago makes a stiff spring swing instead of calming it.
/// Source: first-order adaptive windowing, Janabi-Sharifi, Hayward and Chen 2000.
vec3 prompt_velocity(const ServoState& state, double quantum);

/// m/s, along the way from sample to sample, less what a quantum (m) can add to it: a tip that is here and there in turn has no
/// velocity over the window, and is fast all the same. Over the window, because a sample may come late and the next one soon.
double path_speed(const ServoState& state, double quantum);

/// On the tip, N, with its velocity in m/s.
vec3 tether_force(const Tether& tether, vec3 tip, vec3 velocity);

/// Along the axis of the detents, N, `along` metres from the anchor.
double detent_force(const Detents& detents, double along);

/// Mean force of a pulse over its tick `at`, as a part of its peak: exact, so that the impulse is 2/pi peak length.
double half_sine(std::uint32_t at, std::uint32_t length);

}  // namespace thaum::haptics
