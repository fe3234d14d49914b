#include "haptics/energy.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "haptics/detail/energy_step.h"
#include "haptics/safety.h"

namespace thaum::haptics {
namespace {

constexpr double still = 1e-6;  // speed below which damping takes out no energy (m/s)
constexpr std::uint32_t kept = max_latency + 1;
/// Last share of the energy that active sources may give in a second. While they use it up, their force
/// fades, so that it does not end with a jump.
constexpr double fading_share = 0.2;
/// Force with which a spring that may give no energy any more meets a hand that presses in (N): with a force
/// of zero it would never receive any energy.
constexpr double min_force = 0.1;
static_assert((active_bins - 2) * active_bin_ticks == ticks(1));

/// Largest work that active sources have done from any moment of the last second until now (J). The work is
/// summed in bins of 50 ticks. The oldest bin counts less and less while the newest is being filled, so that
/// the result does not jump.
double max_active_work(const PassivityObserver& observer) {
    const std::size_t oldest = (observer.active_bin + 1) % active_bins;
    double most = 0, later = 0;
    for (std::size_t back = 0; back + 1 < active_bins; ++back) {
        const ActiveBin& bin = observer.active[(observer.active_bin + active_bins - back) % active_bins];
        most = std::max(most, later + bin.most);
        later += bin.sum;
    }
    const double left = 1 - (observer.active_tick + 1.0) / active_bin_ticks;
    return most + left * std::max(0.0, later + observer.active[oldest].most - most);
}

/// Adds the work of active sources in one tick (J).
void add_active_work(PassivityObserver& observer, double work) {
    ActiveBin& bin = observer.active[observer.active_bin];
    bin.sum += work;
    bin.most = std::max(0.0, bin.most + work);
    if (work != 0 || observer.active_work != 0) observer.active_work = max_active_work(observer);
    if (++observer.active_tick < active_bin_ticks) return;
    observer.active_tick = 0;
    observer.active_bin = static_cast<std::uint32_t>((observer.active_bin + 1) % active_bins);
    observer.active[observer.active_bin] = {};
}

/// Takes the energy that the springs gave to the hand in a tick (J; negative: received) from the reserve, the
/// energy that they may still give.
void use_reserve(PassivityObserver& observer, double given, double stored) {
    if (observer.held_back == HeldBack::no) return;
    const double held = stored + std::clamp(reserve_energy - observer.created, 0.0, reserve_energy);
    const double most = observer.held_back == HeldBack::by_work ? HUGE_VAL : held;
    observer.reserve = std::clamp(observer.reserve - given, 0.0, most);
    observer.work_reserve = std::max(0.0, observer.work_reserve - given);
}

}  // namespace

void observe(PassivityObserver& observer, vec3 position, vec3 world_step, double stored, int latency,
             double supplied) {
    if (!is_finite(position) || !is_finite(world_step) || !std::isfinite(supplied)) {
        observer.has_position = 0;
        return;
    }
    const vec3 step = position - observer.position;
    if (observer.has_position != 0 && glm::length(step) <= longest_step) {
        const auto back = static_cast<std::uint32_t>(std::clamp(latency, 0, max_latency));
        const auto& force = observer.forces[(observer.newest + kept - back) % kept];
        const double given = glm::dot(force.passive, step) - glm::dot(force.world, world_step) -
                             observer.forces[observer.newest].share * supplied;
        observer.created += given;
        use_reserve(observer, given, stored);
        // Only the stored part of the energy received can come back. Damping has dissipated the rest.
        observer.created = std::max(observer.created, -stored);
        observer.most_created = std::max(observer.most_created, observer.created);
        add_active_work(observer, glm::dot(force.active, step));
    }
    observer.position = position;
    observer.has_position = 1;
}

double surplus(const PassivityObserver& observer, double held) {
    return std::max(observer.created, observer.created + held - energy_slack);
}

vec3 passivity_control(double energy, vec3 velocity, double most) {
    const double speed = glm::length(velocity);
    if (!(energy > 0) || !(speed > still) || !std::isfinite(speed)) return vec3(0);
    return -std::min(energy / (speed * speed * tick_seconds), most) * velocity;
}

vec3 steady_brake(PassivityObserver& observer, vec3 wished, vec3 braked, vec3 last_output) {
    constexpr double no_force =
        1e-6;  // largest force that counts as rounding error, so that its direction means nothing (N)
    const double step = observer.held_back == HeldBack::by_energy ? held_brake_step : brake_step;
    const double size_of_braked = glm::length(braked), before = glm::length(observer.brake);
    const double most = size_of_braked > no_force ? size_of_braked : 0;
    vec3 brake = observer.brake + limited(wished - observer.brake, step);
    const vec3 along = most > 0 ? braked : last_output;
    const double size = glm::length(along);
    const double against = size > 0 ? -glm::dot(brake, along) / size : before;
    if (against > most) brake = size > 0 ? brake + (against - most) / size * along : vec3(0);
    observer.brake = limited(brake, std::max(most, before - step));
    return observer.brake;
}

double pending_work(const PassivityObserver& observer, vec3 step, int latency) {
    double work = 0;
    for (int back = 0; back < std::min(latency, max_latency); ++back)
        work += glm::dot(
            observer.forces[(observer.newest + kept - static_cast<std::uint32_t>(back)) % kept].passive,
            step);
    return work;
}

vec3 within_budget(const PassivityObserver& observer, vec3 active) {
    constexpr double fading = fading_share * active_budget;
    const double left = active_budget - observer.active_work;
    return left >= fading ? active : std::max(0.0, left / fading) * active;
}

double fade_energy(const PassivityObserver& observer, double pending) {
    // The springs may still give their reserve to the hand, so the reserve counts as energy already given.
    // `created` falls by energy that springs receive, but the offset's work stays at most `switch_energy`.
    const double reserve = observer.held_back == HeldBack::by_energy ? observer.reserve : 0;
    const double passive =
        reserve_energy + switch_energy - (observer.created + reserve) - std::max(0.0, pending);
    const double active =
        switch_energy * (active_budget - observer.active_work) / (fading_share * active_budget);
    return std::clamp(std::min(passive, active), 0.0, switch_energy);
}

double change_of_fade(const PassivityObserver& observer, vec3 force, vec3 step, double pending,
                      double stiffness) {
    const double size2 = glm::dot(force, force);
    const double outward = size2 > 0 ? glm::dot(force, step) / std::sqrt(size2) : 0;
    if (!(outward > 0)) return steady_change;
    // Lower bound of `left`, the energy that may still be created (J): it bounds how fast the force falls.
    constexpr double least = 0.001;
    const double left = std::max(least, max_slow_creation - observer.created - std::max(0.0, pending));
    return std::max(steady_change, (size2 / (2 * left) - stiffness) * outward);
}

void hold_back(PassivityObserver& observer) {
    const double running = observer.held_back == HeldBack::by_energy ? observer.reserve : 0;
    const double work = observer.held_back != HeldBack::no ? observer.work_reserve : 0;
    observer.held_back = HeldBack::by_energy;
    observer.reserve = std::max(running, reserve_energy - observer.created);
    observer.work_reserve = std::max(work, observer.reserve);
}

void forgive(PassivityObserver& observer, bool springs_pull) {
    // Time constants of forgetting (s): `soon` for created energy beyond twice `reserve_energy`, `slowly` for
    // all created energy while the hand feels no spring.
    constexpr double soon = 2, slowly = 20;
    observer.created -= std::max(0.0, observer.created - 2 * reserve_energy) * (tick_seconds / soon);
    if (!springs_pull) observer.created -= std::max(0.0, observer.created) * (tick_seconds / slowly);
}

void release_if_covered(PassivityObserver& observer, const HeldSprings& springs, double stiffness) {
    if (observer.held_back == HeldBack::no || !(stiffness > 0)) return;
    if (observer.held_back == HeldBack::by_work && springs.from_field) return;
    // `nearly`: share of the energy of a spring with the device's stiffness that the springs must have
    // received. It is below 1 because the force lags the hand by a tick, so that such a spring receives a
    // little less than it holds. `settled`: largest created energy that counts as zero (J).
    constexpr double nearly = 0.8, settled = 1e-6;
    const double pull = springs.pull;
    const double owed = std::max(springs.energy - energy_slack, nearly * pull * pull / (2 * stiffness));
    const bool may_push = springs.may_lie_ahead || observer.created > settled;
    if (pull > 0 ? observer.created + owed > 0 : may_push) return;
    observer.held_back = springs.may_lie_ahead ? HeldBack::by_work : HeldBack::no;
    observer.reserve = springs.may_lie_ahead ? observer.work_reserve : 0;
}

double force_of_reserve(const PassivityObserver& observer, double outward, double pending, double stiffness) {
    if (observer.held_back == HeldBack::no || !(stiffness > 0)) return HUGE_VAL;
    const double left = std::max(0.0, observer.reserve - std::max(0.0, pending));
    const double ahead = stiffness * outward;
    if (ahead < 0) return std::max(std::sqrt(2 * stiffness * left), std::min(-ahead, min_force));
    return std::max(0.0, std::sqrt(2 * stiffness * left) - ahead);
}

// The safety stage's cap and heat limit scale all sources alike. The controller's brake counts as passive,
// and so does the offset that fades after a jump, except for the part that active sources left. The offset
// returns energy that was received and hardly any more, since the springs' reserve limits it.
void record_output(PassivityObserver& observer, vec3 output, vec3 passive, vec3 active, vec3 world,
                   vec3 unrequested, vec3 active_offset) {
    const vec3 wanted = passive + active;
    const double size2 = glm::dot(wanted, wanted);
    const double share = size2 > 0 ? std::clamp(glm::dot(output - unrequested, wanted) / size2, 0.0, 1.0) : 0;
    const bool sane = is_finite(passive) && is_finite(active) && is_finite(world) && is_finite(unrequested) &&
                      std::isfinite(share);
    observer.newest = (observer.newest + 1) % kept;
    auto& force = observer.forces[observer.newest];
    force.share = sane ? share : 0;
    force.passive = sane ? share * passive + unrequested - active_offset : vec3(0);
    force.world = sane ? share * world : vec3(0);
    force.active = output - force.passive;
}

void record_ramp(PassivityObserver& observer, vec3 output) {
    const CommandedForce last = observer.forces[observer.newest];
    const vec3 before = last.passive + last.active;
    const double size2 = glm::dot(before, before);
    const double left = size2 > 0 ? std::clamp(glm::dot(output, before) / size2, 0.0, 1.0) : 0;
    observer.newest = (observer.newest + 1) % kept;
    const vec3 active = std::isfinite(left) ? left * last.active : vec3(0);
    observer.forces[observer.newest] = {.passive = output - active, .active = active};
}

// ---- the servo's step -------------------------------------------------------------------------------------

namespace {

/// Potential energy of a primitive (J) if the proxy is at this place; the minimum is 0, and a directed force
/// counts as 0.
double potential(const Primitive& primitive, vec3 proxy) {
    const vec3 off = proxy - primitive.position;
    const double along = glm::dot(off, primitive.direction);
    switch (primitive.kind) {
        case PrimitiveKind::point: return primitive.strength * glm::length(off);
        case PrimitiveKind::line: return primitive.strength * glm::length(off - along * primitive.direction);
        case PrimitiveKind::plane: return primitive.strength * std::max(0.0, -along);
        case PrimitiveKind::directed: break;
    }
    return 0;
}

/// Stored energy of a spring (J) that would hold `energy` at `stretch` (m) if the cap (N) let all of its
/// force through.
double within_cap(double energy, double stretch, double cap) {
    const double pull = 2 * energy / stretch;
    if (!(pull > cap)) return energy;
    return cap * stretch * (1 - cap / (2 * pull));
}

/// Energy of the tether's spring, without its detents, the places into which the tip snaps (J).
double tether_energy(const Tether& tether, vec3 tip, double cap) {
    if (!(tether.stiffness > 0)) return 0;
    const vec3 off = tip - tether.anchor;
    return within_cap(tether.stiffness * glm::dot(off, off) / 2, glm::length(off), cap);
}

/// Energy of the spring between the tip and the proxy, the point on which the primitives act (J).
double coupling_energy(const ServoState& state, const HapticModel& model, vec3 tip, double cap) {
    const vec3 off = tip - state.proxy;
    return within_cap(model.coupling.stiffness * glm::dot(off, off) / 2, glm::length(off), cap);
}

/// Energy that the springs of tether and primitives hold (J). A force is felt only up to the cap, the largest
/// allowed force, so the hand never put in the energy of a larger force.
double spring_energy(const ServoState& state, const HapticModel& model, const Tether& tether, vec3 tip,
                     double cap) {
    double held = tether_energy(tether, tip, cap);
    if (state.primitives != 0 && conservative(model.primitives)) {
        held += coupling_energy(state, model, tip, cap);
        for (Primitive primitive : model.primitives.items()) {
            primitive.strength = std::min(primitive.strength, cap);
            held += potential(primitive, state.proxy);
        }
    }
    return held;
}

/// Upper bound of the energy that surfaces and the tether's detents (places into which the tip snaps) hold
/// (J).
double other_energy(const Tether& tether, const SurfaceForces& surfaces, double cap) {
    const double notches = tether.stiffness > 0 ? tether.detents.depth * tether.detents.width / pi : 0;
    return notches + (surfaces.active ? 0 : within_cap(surfaces.stored, surfaces.stretch, cap));
}

/// Largest force that a spring exerts at the device now (N): less than the cap while the motors are warm,
/// zero while the output is stopped. A spring that is stretched meanwhile received less than its potential
/// energy. The account must not take the difference for created energy.
double max_felt_force(const Servo& servo, const SafetyState& safety) {
    const bool whole = safety.cause <= static_cast<std::uint32_t>(SafetyCause::capped);
    return whole ? servo.limits.cap : glm::length(safety.output);
}

bool is_stopped(const SafetyState& safety) {
    return safety.cause >= static_cast<std::uint32_t>(SafetyCause::waiting);
}

/// Whether the springs may hold energy now that they did not receive: a source switched, the output was
/// stopped, or the player has raised the largest force.
bool may_hold_more(const Servo& servo, const ServoState& state, const Tip& tip) {
    return tip.switched || tip.stops || state.samples <= 1 || is_stopped(state.safety) ||
           servo.limits.cap > state.safety.cap;
}

/// Energy of a spring with the device's largest stiffness that has the force of the last tick (J).
double energy_of_output(const Servo& servo, const SafetyState& safety) {
    if (!(servo.max_stiffness > 0)) return 0;
    return glm::dot(safety.output, safety.output) / (2 * servo.max_stiffness);
}

/// Limits the springs, which pull with `pull` (N), to the largest force that their reserve, the energy that
/// they may still give, allows. Returns this limit (N). Unless it `may_jump`, the limit moves slowly: in a
/// tick by at most `fall` (N) down or `reserve_step` up, beyond what the force of a spring changes while the
/// tip moves by `moved` (m).
double limit_to_reserve(const Servo& servo, const ServoState& state, double pull, bool may_jump, double fall,
                        vec3 moved, Sources& sources) {
    const vec3 step = tip_motion(state, servo.quantum);
    const vec3 way = pull > 0 ? sources.springs / pull : vec3(0);
    double most = force_of_reserve(state.energy, glm::dot(step, way),
                                   pending_work(state.energy, step, servo.latency), servo.max_stiffness);
    if (state.energy.held_back == HeldBack::by_work && !(pull > most)) return most;
    if (!may_jump) {
        const double relaxed = servo.max_stiffness * glm::dot(moved, way), last = state.energy.spring_force;
        most = std::clamp(most, std::min(last, servo.limits.cap) - fall - std::max(0.0, relaxed),
                          last + reserve_step + std::max(0.0, -relaxed));
    }
    if (!(pull > most)) return most;
    const double share = most / pull;
    sources.passive -= (1 - share) * sources.springs;
    for (vec3* part : {&sources.springs, &sources.world, &sources.tether}) *part *= share;
    return most;
}

/// Energy that the tether will create until the force of this tick has acted (J). The device delays every
/// force and holds it for a tick, while the spring already relaxes. In that time, a hand at 2 m/s crosses the
/// whole stretch that the largest force of a Falcon (a small device of 8 N) allows.
double expected_creation(const Servo& servo, const PassivityObserver& observer, const Tether& tether,
                         const Tip& tip) {
    if (!(tether.stiffness > 0)) return 0;
    const double cap = servo.limits.cap;
    const vec3 step = (tip.velocity - tether.anchor_velocity) * tick_seconds;
    const vec3 pull = limited(tether.stiffness * (tether.anchor - tip.position), cap);
    const double work = pending_work(observer, step, servo.latency) + glm::dot(pull, step);
    const double ahead = tether_energy(tether, tip.position + (servo.latency + 1.0) * step, cap);
    return std::max(0.0, work + ahead - tether_energy(tether, tip.position, cap));
}

/// Energy that the brake, the damping of the passivity controller, takes out of the hand in this tick (J).
/// Soon after a switch, springs can give the hand no more than the reserve, whatever they hold.
double energy_to_take_out(const PassivityObserver& observer, double held) {
    if (observer.held_back != HeldBack::by_energy) return surplus(observer, held);
    return surplus(observer, std::min(held, observer.reserve)) * (tick_seconds / repayment_time);
}

/// Largest damping with which the passivity controller brakes the hand (N s/m). A step of one encoder count
/// in a tick reads as a velocity, and damping turns it into a force. A force above `max_of_a_count` would
/// shake a tip that hardly moves. In a faster motion one count matters less, so the damping may be larger.
double controller_damping(const Servo& servo, vec3 velocity) {
    constexpr double max_of_a_count = 0.28;  // largest force by one encoder count (N)
    if (!(servo.quantum > 0)) return servo.max_damping;
    const double of_a_count = servo.quantum / tick_seconds;
    const double counts = std::max(1.0, glm::length(velocity) / (2 * of_a_count));
    return std::min(servo.max_damping, max_of_a_count / of_a_count * counts);
}

/// Brake (damping force) that takes the energy `taken` (J) out of a hand that feels the sources (N).
vec3 brake_sources(const Servo& servo, ServoState& state, double taken, const Sources& sources) {
    PassivityObserver& energy = state.energy;
    if (!(taken > 0) && energy.brake == vec3(0)) return vec3(0);
    vec3 brake{};
    // The velocity is computed only where it is needed, because it takes half the time of a quiet step.
    if (taken > 0) {
        const vec3 velocity = prompt_velocity(state, servo.quantum);
        brake = passivity_control(taken, velocity, controller_damping(servo, velocity));
    }
    const bool held_back = energy.held_back == HeldBack::by_energy;
    // In a fluid the brake acts at once and without the limits of `steady_brake`. With them, a flow that is
    // felt late created more than the 0.02 J that are allowed.
    if (state.fluid.number != 0 && !held_back) return energy.brake = brake;
    return steady_brake(energy, brake, held_back ? sources.springs : sources.passive, state.safety.output);
}

/// Work of the forces that have not acted yet, for the budget of an offset that may fade in this tick (J). In
/// a quiet tick no offset fades. The result is then 0, because computing the motion of the tip would take a
/// third of the time of the step. The conditions are those on which make_safe() begins a fade or goes on.
double work_beside_fade(const Servo& servo, const ServoState& state, const Tip& tip) {
    const SafetyState& safety = state.safety;
    const bool may_fade = safety.fade != static_cast<std::uint32_t>(Fade::over) || safety.gate_open == 0 ||
                          tip.jumps || state.energy.unsettled != 0 || servo.limits.cap != safety.cap;
    if (!may_fade || servo.latency == 0) return 0;
    return pending_work(state.energy, tip_motion(state, servo.quantum), servo.latency);
}

/// Limits the change of the force after a switch, and holds the springs back until they hold no more energy
/// than they received. In a tick in which the springs `may_give` more than before, and while the primitives
/// still move to their place after a switch, the limit may jump: the fading offset hides the jump.
EnergyLimits limits_after_switch(const Servo& servo, ServoState& state, const Tip& tip, bool may_give,
                                 const HeldSprings& springs, Sources& sources) {
    PassivityObserver& energy = state.energy;
    EnergyLimits limits;
    const bool fades = state.safety.fade != static_cast<std::uint32_t>(Fade::over);
    if (!fades && energy.held_back == HeldBack::no) return limits;
    const vec3 moved = tip.position - state.safety.tip;
    limits.change = change_of_fade(energy, energy.forces[energy.newest].passive, moved,
                                   pending_work(energy, moved, servo.latency), servo.max_stiffness);
    if (energy.held_back == HeldBack::no) return limits;
    const bool by_work = energy.held_back == HeldBack::by_work;
    const bool may_jump = may_give || energy.unsettled != 0;
    const double fall = reserve_step + limits.change - steady_change;
    limits.reserve_force = limit_to_reserve(servo, state, springs.pull, may_jump, fall, moved, sources);
    if (!by_work) forgive(energy, springs.pull > 0);
    if (!may_give && !fades && !(limits.reserve_force < springs.pull))
        release_if_covered(energy, springs, servo.max_stiffness);
    return limits;
}

}  // namespace

EnergyLimits update_energy(const Servo& servo, ServoState& state, const HapticModel& model,
                           const Tether& tether, const Tip& tip, const SurfaceForces& surfaces,
                           const FluidForces& fluid, Sources& sources) {
    const double felt = max_felt_force(servo, state.safety);
    const double springs = spring_energy(state, model, tether, tip.position, servo.limits.cap);
    const double held =
        felt < servo.limits.cap ? spring_energy(state, model, tether, tip.position, felt) : springs;
    const bool stopped = is_stopped(state.safety), may_give = may_hold_more(servo, state, tip);
    double stored = (stopped ? held : springs) +
                    other_energy(tether, surfaces, stopped ? felt : servo.limits.cap) + fluid.stored;
    if (tip.stops) stored = std::max(stored, energy_of_output(servo, state.safety));
    // A tethered hand touches no surfaces, so only the anchor, the tether's other end, moves.
    const vec3 step = tether.stiffness > 0 ? tether.anchor_velocity * tick_seconds : surfaces.world_step;
    observe(state.energy, tip.position, step, stored, servo.latency, fluid.supplied);
    sources.active = within_budget(state.energy, sources.active);
    if (may_give && servo.max_stiffness > 0) hold_back(state.energy);
    const bool from_field = model.primitives.by_proxy();
    const HeldSprings pulling{.energy = stored - fluid.stored,
                              .pull = glm::length(sources.springs),
                              .from_field = from_field,
                              .may_lie_ahead = from_field && conservative(model.primitives)};
    EnergyLimits limits = limits_after_switch(servo, state, tip, may_give, pulling, sources);
    state.energy.spring_force = std::min(pulling.pull, limits.reserve_force);
    // A field of forces may hold energy that was there before the hand came. The reserve limits it, so the
    // hand must not be braked for it: only the spring from the tip to the proxy counts then.
    const bool by_work = state.energy.held_back == HeldBack::by_work;
    const double returned =
        by_work ? std::min(held, coupling_energy(state, model, tip.position, felt)) : held;
    const double taken =
        energy_to_take_out(state.energy, returned + expected_creation(servo, state.energy, tether, tip));
    limits.brake = brake_sources(servo, state, taken, sources);
    limits.fade_energy = fade_energy(state.energy, work_beside_fade(servo, state, tip));
    return limits;
}

void record_force(ServoState& state, vec3 output, const Sources& sources) {
    if (is_stopped(state.safety)) return record_ramp(state.energy, output);
    record_output(state.energy, output, sources.passive, sources.active, sources.world,
                  state.safety.unrequested, state.safety.active_offset);
}

}  // namespace thaum::haptics
