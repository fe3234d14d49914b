// haptics/energy.h: the books of energy at the device's port (haptics.md, "Energy"): an observer after the last stage, and a
// controller that adds the damping which keeps the passive sources passive (time-domain passivity; Hannaford and Ryu 2002).
//
// Passive sources (tether, primitives, surfaces) may give back what they were given, by the hand or by the world that moves the
// other end, and no more. Active sources (pulses, lean, what a switch leaves) may push the hand, within a budget.
//
// A force that is commanded acts over the tick that follows, so its work is known one tick later, from what the device then measures.
#pragma once
#include <array>
#include <cstdint>

#include "core/maths.h"
#include "haptics/device.h"

namespace thaum::haptics {

/// N, commanded in one tick, by kind of source.
struct CommandedForce {
    vec3 passive{}, active{};
    vec3 world{};    ///< of the passive force, by what the world moves
    double share{};  ///< of what the sources wanted, 0 to 1
};

/// All that a tick leaves behind; no padding.
struct PassivityObserver {
    vec3 position{};                                        ///< m, as measured at the last tick
    std::array<CommandedForce, most_latency + 1> forces{};  ///< the newest at `newest`, and back from there
    double
        created{};  ///< J, by passive sources: above 0, more than they got; never below minus what they store
    double most_created{};  ///< J, the most it ever was
    double active_work{};   ///< J, by active sources, of the last second or so
    std::uint32_t newest{};
    std::uint32_t has_position{};  ///< 1: the position is that of the last tick
};
static_assert(sizeof(PassivityObserver) ==
              (3 + 10 * (most_latency + 1) + 3) * sizeof(double) + 2 * sizeof(std::uint32_t));

inline constexpr double longest_step = 0.05;  ///< m, of a tick

/// J that active sources may give in about a second.
inline constexpr double active_budget = 0.5;

/// Books the work of the last tick, now that the device has measured where it led. world_step: m, by which the world moved the other end
/// of what `world` pulls at. stored: J, that the passive sources hold now. latency: ticks, of the device. supplied: J, that the world gave
/// otherwise to what was wanted in the last tick. A step that no hand makes was measured wrongly at one of its ends: it is no work, or one
/// bad pose would keep the controller busy for ever.
void observe(PassivityObserver& book, vec3 position, vec3 world_step, double stored, int latency,
             double supplied = 0);

/// Energy that a spring may have created while it still holds more (J). Whatever is beyond it is taken out at once.
inline constexpr double energy_slack = 0.003;

/// Energy that the controller has to take out (J); 0 or less: none. held: energy that springs hold, and what they will create before
/// the next force acts (J). A controller that waits until springs have given back all they hold begins too late: a damper at the
/// device's limit takes out less than a stretched spring gives back.
double surplus(const PassivityObserver& book, double held);

/// Force against the velocity (m/s) that takes out `energy` (J) within the next tick, with at most `most` N s/m (N).
vec3 passivity_control(double energy, vec3 velocity, double most);

/// Work of the passive forces that were commanded and have not acted yet, if the tip moves by `step` (m) in every tick (J).
double pending_work(const PassivityObserver& book, vec3 step, int latency);

/// The active force as its budget allows: beyond it nothing that pushes along the velocity.
vec3 within_budget(const PassivityObserver& book, vec3 active, vec3 velocity);

/// Books the force that the device is told (N). passive, active: what the sources wanted. world: the part of `passive` that pulls at
/// something which the world moves. unrequested: the part of `output` that no source wanted, the controller's brake and what fades after a switch.
void record_output(PassivityObserver& book, vec3 output, vec3 passive, vec3 active, vec3 world,
                   vec3 unrequested = {});

}  // namespace thaum::haptics
