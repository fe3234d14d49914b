// haptics/energy.h: energy bookkeeping at the device (haptics.md, "Energy"): a passivity observer after the
// last stage, and a passivity controller. The controller adds the damping that keeps passive sources passive
// (time-domain passivity; Hannaford and Ryu 2002).
//
// Passive sources (tether, primitives, surfaces) may return the energy that they received, and no more. They
// receive it from the hand, or from the world that moves the spring's other end. Active sources (pulses,
// steady force, the ramp of an old model) may push the hand within a budget.
//
// A commanded force acts over the tick that follows. Its work is known one tick later, from the position that
// the device then measures.
#pragma once
#include <array>
#include <cstdint>

#include "core/maths.h"
#include "haptics/device.h"

namespace thaum::haptics {

/// Force commanded in one tick, by kind of source (N).
struct CommandedForce {
    vec3 passive{}, active{};
    vec3 world{};    ///< part of the passive force that acts on things of the world
    double share{};  ///< commanded share of the force that the sources asked for, 0 to 1
};

/// State of the passivity observer; no padding.
struct PassivityObserver {
    vec3 position{};  ///< measured position at the last tick (m)
    /// Commanded forces, a ring buffer with the newest at `newest`.
    std::array<CommandedForce, most_latency + 1> forces{};
    /// Energy created by passive sources (J); > 0: they gave more than they got. It never falls below minus their
    /// stored energy.
    double created{};
    double most_created{};  ///< largest value of `created` so far (J)
    double active_work{};   ///< work of active sources in the last second or so (J)
    std::uint32_t newest{};
    std::uint32_t has_position{};  ///< 1: `position` is the one of the last tick
};
static_assert(sizeof(PassivityObserver) ==
              (3 + 10 * (most_latency + 1) + 3) * sizeof(double) + 2 * sizeof(std::uint32_t));

inline constexpr double longest_step = 0.05;  ///< largest plausible motion of the tip in a tick (m)

/// Energy that active sources may give in about a second (J).
inline constexpr double active_budget = 0.5;

/// Adds the work of the last tick, once the device has measured the resulting position. `world_step` is the
/// motion of the world's end of the spring (m). `stored` is the energy that the passive sources hold now (J).
/// `latency` is the device's delay (ticks). `supplied` is other energy that the world gave to the forces
/// asked for in the last tick (J). A step longer than `longest_step` is a measurement error and does no work;
/// otherwise one bad position would keep the controller active for ever.
void observe(PassivityObserver& observer, vec3 position, vec3 world_step, double stored, int latency,
             double supplied = 0);

/// Energy that a spring may have created while it still holds more (J). Energy beyond it is taken out at
/// once.
inline constexpr double energy_slack = 0.003;

/// Energy that the controller has to take out (J); 0 or less: none. `held` is the energy that springs hold,
/// plus the energy that they will create before the next force acts (J). The controller must not wait until
/// the springs have returned all of it. A damper at the device's limit takes out less than a stretched spring
/// gives back.
double surplus(const PassivityObserver& observer, double held);

/// Force against the velocity (m/s) that takes out `energy` (J) within the next tick (N). Its damping is at
/// most `most` (N s/m).
vec3 passivity_control(double energy, vec3 velocity, double most);

/// Work of the passive forces that are commanded but have not acted yet (J), if the tip moves by `step` (m)
/// in every tick.
double pending_work(const PassivityObserver& observer, vec3 step, int latency);

/// Limits the active force to its budget: beyond the budget, it no longer pushes along the velocity (N).
vec3 within_budget(const PassivityObserver& observer, vec3 active, vec3 velocity);

/// Records the force commanded to the device (N). `passive` and `active` are the forces that the sources
/// asked for. `world` is the part of `passive` that acts on moving things of the world. `unrequested` is the
/// part of `output` that no source asked for: the controller's brake and the fading offset of a switch.
void record_output(PassivityObserver& observer, vec3 output, vec3 passive, vec3 active, vec3 world,
                   vec3 unrequested = {});

}  // namespace thaum::haptics
