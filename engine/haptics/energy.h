// haptics/energy.h: energy bookkeeping at the device (HAPTICS.md, "Energy and switches"): a passivity
// observer after the last stage, and a passivity controller. The controller adds the damping that keeps
// passive sources passive (time-domain passivity; Hannaford and Ryu 2002).
//
// Passive sources (tether, primitives, surfaces, viscous spaces, a fluid's drag and walls) may return
// the energy that they received, and no more. They receive it from the hand, or from the world that
// moves the spring's other end. Active sources (pulses, steady and directed forces, a fluid's flow)
// may push the hand within a budget.
//
// A switch (a source of force comes, ends or jumps) may leave springs that hold more energy than they
// received: after material grew at the hand, after the largest force was raised, or after forces were
// switched on again. No damper takes that much energy out of a hand that rests. So from a switch on, a
// reserve holds the springs back: the energy that they received and still hold, plus `reserve_energy`. They
// pull no harder than a spring of the device's largest stiffness k with that energy, F <= sqrt(2 k reserve).
// A hand that yields feels the spring relax, and a hand that presses in again stretches it from there. The
// reserve is computed from the account `created`, which a switch does not reset. So many switches together
// give no more than one. Created energy is forgotten in the course of time only (`forgive`).
//
// A field of forces (haptic modes) may hold more energy than can be seen at the place of the hand. Example: a
// body of even density appears around the hand. The hand feels nothing in its midst, but is pushed out as
// soon as it moves to the body's edge. So the reserve of springs that are chosen from a field does not end
// while there are such springs. Once the springs hold no more than they received, the reserve counts all the
// work that the hand has done since the first switch, also against drag: the springs give no more than this
// work and the reserve of the beginning.
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
    vec3 world{};    ///< part of `passive` that acts on moving things of the world
    double share{};  ///< share of the force asked for by the sources that was commanded, 0 to 1
};

/// Length of a bin, a span of time over which the work of active sources is summed (ticks).
inline constexpr std::uint32_t active_bin_ticks = 50;
/// Number of bins, spans of 50 ticks in which the work of active sources is summed: those of one second, the
/// bin being filled, and one older than a second that counts less and less. Without the last one, the force
/// would jump when the work of a bin is forgotten.
inline constexpr std::size_t active_bins = 22;

/// Work of active sources in one bin.
struct ActiveBin {
    double sum{};   ///< work of active sources in the bin (J)
    double most{};  ///< largest work of active sources from any tick of the bin to its end, at least 0 (J)
};

/// Whether a reserve limits the energy that springs give after a switch (a source of force came, ended or
/// jumped), and what adds to this reserve.
enum class HeldBack : std::uint32_t {
    no,         ///< no reserve: the springs are not limited
    by_energy,  ///< the energy that the springs received and still hold adds to the reserve
    by_work,    ///< all the work that the hand does on the springs of a field adds to the reserve
};

/// State of the passivity observer, the account of the energy that sources gave the hand; no padding.
struct PassivityObserver {
    vec3 position{};  ///< measured position at the last tick (m)
    /// Commanded forces, a ring buffer with the newest at `newest`.
    std::array<CommandedForce, max_latency + 1> forces{};
    /// Energy created by passive sources (J); > 0: they gave more than they got. It never falls
    /// below minus their stored energy.
    double created{};
    double most_created{};  ///< largest value of `created` so far (J)
    /// Largest work of active sources from any tick of the last second until now (J).
    double active_work{};
    std::array<ActiveBin, active_bins> active{};  ///< work of active sources in spans of 50 ticks, a ring
    /// Energy that springs may still give after a switch (a source of force came, ended or jumped), unless
    /// `held_back` is `no` (J).
    double reserve{};
    /// Value that `reserve` would have if it counted the hand's work (`by_work`) since the first switch (J).
    double work_reserve{};
    std::uint32_t active_bin{};    ///< index of the bin of `active` that is being filled
    std::uint32_t active_tick{};   ///< number of ticks so far in that bin
    std::uint32_t newest{};        ///< index of the last command in `forces`
    std::uint32_t has_position{};  ///< 1: `position` was measured in the last tick; 0: it is unknown
    HeldBack held_back{};          ///< whether `reserve` limits the springs, and what adds to it
    std::uint32_t unsettled{};     ///< ticks left in which the sources' forces may still jump after a switch
    vec3 brake{};                  ///< force that took excess energy out of the hand in the last tick (N)
    double spring_force{};         ///< length of the springs' force in the last tick (N)
};
static_assert(sizeof(PassivityObserver) ==
              (8 + 10 * (max_latency + 1) + 4 + 2 * active_bins) * sizeof(double) +
                  6 * sizeof(std::uint32_t));

inline constexpr double longest_step = 0.05;  ///< largest plausible motion of the tip in a tick (m)

/// Energy that active sources may give in any second (J).
inline constexpr double active_budget = 0.5;

/// Energy that springs may give after a switch beyond what they received (J). The sum of this, of the work of
/// the fading offset, and of the energy that a tick's delay adds stays below 0.02 J.
inline constexpr double reserve_energy = 0.008;

/// Adds the work of the last tick, once the device has measured the resulting position. `world_step` is the
/// motion of the world's end of the spring (m). `stored` is the energy that the passive sources hold now (J).
/// `latency` is the device's delay (ticks). `supplied` is other energy that the world gave to the forces
/// asked for in the last tick (J). A step longer than `longest_step` is a measurement error and does no work;
/// otherwise one bad position would keep the controller active for ever.
void observe(PassivityObserver& observer, vec3 position, vec3 world_step, double stored, int latency,
             double supplied = 0);

/// Tolerance of the passivity controller (J). The controller computes the energy that would be created if the
/// springs gave back all the energy that they hold now. It takes out at once what this energy has above the
/// tolerance.
inline constexpr double energy_slack = 0.003;

/// Time constant with which the passivity controller takes out energy that a switch (a jump of a source)
/// created (s). The reserve bounds that energy, so there is no haste, and a brake that took all of it at once
/// would be a jump of the force.
inline constexpr double repayment_time = 0.1;

/// Energy that the passivity controller has to take out of the hand (J); 0 or less: none. `held` is the
/// energy that springs hold, plus the energy that they will create before the next force acts (J). The
/// controller must not wait until the springs have returned all of it: a damper at the device's limit takes
/// out less energy than a stretched spring gives back.
double surplus(const PassivityObserver& observer, double held);

/// Force against the velocity (m/s) that takes out `energy` (J) within the next tick (N). Its damping is at
/// most `most` (N s/m).
vec3 passivity_control(double energy, vec3 velocity, double most);

/// Largest change of the brake (the force that takes excess energy out of the hand) in a tick (N):
/// `brake_step` in general, `held_brake_step` while springs are held back after a switch. `held_brake_step`
/// and `reserve_step` together stay below `steady_change`, the largest change of the output.
inline constexpr double brake_step = 0.3, held_brake_step = 0.15;

/// Moves the brake, a damping force, towards `wished`, the one that the passivity controller asks for (N). It
/// moves by at most `brake_step` or `held_brake_step`, since a brake that began at once would be a jump.
/// The brake's component against the force that it brakes, `braked` (N), is at most as large as that force.
/// So it can cancel the force, but cannot pull a hand that leaves a wall back into the wall. A brake stronger
/// than `braked` becomes weaker by such a step in each tick. If `braked` is zero, the brake has no component
/// against the last output (N).
vec3 steady_brake(PassivityObserver& observer, vec3 wished, vec3 braked, vec3 last_output);

/// Work of the passive forces that are commanded but have not acted yet (J), if the tip moves by `step` (m)
/// in every tick.
double pending_work(const PassivityObserver& observer, vec3 step, int latency);

/// Limits the force of active sources, which may push the hand, to their budget of energy in a second (N).
/// The force fades while the last fifth of the budget is used. The part against the motion, which does
/// negative work, fades too: otherwise the force would jump whenever the hand turns.
vec3 within_budget(const PassivityObserver& observer, vec3 active);

/// Work that the offset which hides a jump of the force may do on the hand now (J). It is less soon after
/// other jumps, so that the offsets of many jumps together do no more than that of one, and less while the
/// budget of active sources runs out. `pending` is the work of forces that have not acted yet (J).
double fade_energy(const PassivityObserver& observer, double pending);

/// Largest energy that passive sources may create while the output changes slowly at a switch (J). If a slow
/// change would create more, the output changes faster.
inline constexpr double max_slow_creation = 0.019;

/// Largest change in a tick of a force that fades (N), beyond that of a spring with the device's `stiffness`
/// k (N/m). `step` is the motion of the tip (m), `pending` the work of forces that have not acted yet (J). A
/// hand that yields at the speed v gets F^2 v / (2 (r + k v)) from a force F that falls by r (N/s) in time
/// and by k for each metre. Only where that is more energy than may still be created, the force falls faster
/// than `steady_change`: as fast as a spring that holds just this energy.
double change_of_fade(const PassivityObserver& observer, vec3 force, vec3 step, double pending,
                      double stiffness);

/// Begins a reserve, the energy that springs may still give after a switch. A reserve by energy that is
/// already running is not reduced. A reserve that counts the hand's work (HeldBack::by_work) is set aside
/// until the springs hold no more than they received.
void hold_back(PassivityObserver& observer);

/// Forgets a part of the created energy, which passive sources gave in excess, in a tick while springs are
/// held back. Created energy beyond twice `reserve_energy`, as after a device has lost its position, is
/// forgotten within seconds. All of it is forgotten within tens of seconds if the springs do not pull at all.
void forgive(PassivityObserver& observer, bool springs_pull);

/// Energy and force of the springs after a switch (a jump of the force), when they may hold too much energy.
struct HeldSprings {
    double energy{};    ///< energy that the springs hold (J)
    double pull{};      ///< length of the springs' force (N)
    bool from_field{};  ///< the springs are chosen from a field (by haptic modes)
    /// The springs may push as soon as the hand moves, even if they do not pull now, as within a body of even
    /// density.
    bool may_lie_ahead{};
};

/// Ends the reserve, the limit of the energy that springs give after a switch, once they hold no more energy
/// than they received. For springs that do not pull, it ends once `created` is about zero and they cannot
/// push as soon as the hand moves. The reserve of springs from a field does not end, but counts the hand's
/// work from then on (HeldBack::by_work). `stiffness` is the device's largest (N/m).
void release_if_covered(PassivityObserver& observer, const HeldSprings& springs, double stiffness);

/// Largest force of the springs that the reserve allows (N); infinite if the springs are not held back.
/// `outward` is the motion of the tip along their force in a tick (m). `pending` is the work of their forces
/// that are commanded but have not acted yet (J). `stiffness` is the device's largest (N/m).
double force_of_reserve(const PassivityObserver& observer, double outward, double pending, double stiffness);

/// Largest change in a tick of the force that the reserve, the energy that springs may still give, allows
/// (N), beyond that of a spring with the device's stiffness.
inline constexpr double reserve_step = 0.3;

/// Records the force commanded to the device (N). `passive` and `active` are the forces that the sources
/// asked for. `world` is the part of `passive` that acts on moving things of the world. `unrequested` is the
/// part of `output` that no source asked for: the controller's brake and the fading offset of a switch.
/// `active_offset` is the part of that offset that active sources left; it counts as active.
void record_output(PassivityObserver& observer, vec3 output, vec3 passive, vec3 active, vec3 world,
                   vec3 unrequested = {}, vec3 active_offset = {});

/// Records a force that ramps to zero (N). Each kind of source keeps its part of the last force.
void record_ramp(PassivityObserver& observer, vec3 output);

}  // namespace thaum::haptics
