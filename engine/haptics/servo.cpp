#include "haptics/servo.h"

#include <algorithm>
#include <cmath>

#include "haptics/felt_patch.h"

namespace thaum::haptics {
namespace {

/// Stores a position and returns the velocity over the window, or the filled part of it (m/s). Over one tick,
/// an encoder's quantum would be noise of centimetres per second. A position that is not finite gives NaN
/// when it arrives and when it is the oldest; the safety stage cuts the force on both.
vec3 store_position(ServoState& state, vec3 position) {
    auto& ring = state.positions;
    const bool full = state.samples == velocity_window;
    const vec3 oldest = full ? ring[state.next_position] : ring[0];
    const std::uint32_t span = state.samples;
    ring[state.next_position] = position;
    state.next_position = static_cast<std::uint32_t>((state.next_position + 1) % velocity_window);
    if (!full) ++state.samples;
    if (span == 0) return is_finite(position) ? vec3(0) : position;
    return (position - oldest) / (span * tick_seconds);
}

bool newer(std::uint32_t number, std::uint32_t than) {
    const std::uint32_t ahead = number - than;  // wraps like the numbers
    return ahead != 0 && ahead < 1U << 31U;
}

bool playing(const PlayingPulse& pulse) { return pulse.at < pulse.length; }

/// Returns true if the new pulse ends one that is still playing.
bool start_pulse(ServoState& state, const Pulse& pulse) {
    if (!newer(pulse.number, state.last_pulse)) return false;
    state.last_pulse = pulse.number;
    PlayingPulse& slot = state.pulses[state.next_pulse];
    const bool cuts_off = playing(slot);
    slot = {pulse.peak, pulse.length, 0};
    state.next_pulse = static_cast<std::uint32_t>((state.next_pulse + 1) % pulses_at_once);
    return cuts_off;
}

vec3 play_pulses(ServoState& state) {
    vec3 force{};
    for (PlayingPulse& pulse : state.pulses) {
        if (!playing(pulse)) continue;
        force += pulse.peak * half_sine(pulse.at, pulse.length);
        ++pulse.at;
    }
    return force;
}

// ---- steady force and tether ------------------------------------------------------------------------------

/// Returns true if one of them appeared, ended or jumped.
bool detect_source_switch(ServoState& state, const HapticModel& model) {
    const bool jumped =
        model.steady_force.number != state.steady_force_number || model.tether.number != state.tether_number;
    state.steady_force_number = model.steady_force.number;
    state.tether_number = model.tether.number;
    return jumped;
}

// ---- primitives ---------------------------------------------------------------------------------------------------

/// Residual up to which the balance counts as solved (N). Beyond it, the spring to the best proxy gives the
/// better of two forces. It is right for the found proxy even if the shares of the primitives are unknown.
constexpr double solved_residual = 1e-9;

/// Ticks after a jump of the set in which the proxy may still find its place: modes read their fields where it was.
constexpr std::uint32_t unsettled_ticks = first_ticks;

/// Ticks after a resume in which the offset of the switch takes up what the sources change. Velocities come back with the
/// second sample, and the damping of springs and fluids with them. So few ticks hardly weaken a kick that begins then.
constexpr std::uint32_t resume_ticks = 3;

/// Returns true if the set appeared, ended or jumped.
bool detect_set_switch(ServoState& state, const HapticModel& model) {
    const auto count = static_cast<std::uint32_t>(model.primitives.items().size());
    const bool jumped = count != state.primitives || (count != 0 && model.set_number != state.set_number);
    state.set_number = count == 0 ? 0 : model.set_number;
    if (jumped) state.settling = {};
    auto& unsettled = state.energy.unsettled;
    unsettled = jumped && count != 0 ? unsettled_ticks : unsettled - std::min(unsettled, 1U);
    return jumped;
}

/// Moves the proxy to the balance of spring and primitives. Returns the force on the hand (N). The force is
/// zero if the tip's position is not finite or out of range; the coupling then starts anew.
vec3 feel_primitives(ServoState& state, const HapticModel& model, vec3 tip, vec3 velocity) {
    const vec3 before = state.primitives == 0 ? tip : state.proxy;
    const Spring spring = effective_spring(model.coupling, tip, velocity, before, tick_seconds);
    const Balance found = balance(model.primitives, spring);
    const bool usable = std::isfinite(found.residual);
    state.primitives = usable ? static_cast<std::uint32_t>(model.primitives.items().size()) : 0;
    if (!usable) {
        state.settling = {};
        state.proxy = tip;
        return vec3(0);
    }
    state.proxy = found.proxy;
    if (model.primitives.by_proxy())
        state.proxy = settle(
            state.settling, {before, found.proxy, tip, spring, model.coupling.stiffness, model.field_motion});
    const bool balanced = state.proxy == found.proxy && found.residual <= solved_residual;
    return (balanced ? found.force : spring.stiffness * (state.proxy - spring.centre)) + state.settling.lag;
}

// ---- switches -------------------------------------------------------------------------------------------------------

/// Returns true if the patch jumped.
bool detect_patch_jump(ServoState& state, const HapticModel& model) {
    const bool jumped = model.patch_number != state.patch_number;
    state.patch_number = model.patch_number;
    if (jumped) {
        state.surface = {.proxy = model.start, .begun = 1};
        state.contact_offset = {};
    }
    return jumped;
}

/// Share of the device's damping by which the viscosity of a space changes in a tick. Beside each other, two materials may
/// differ tenfold, and which of them is at the tip is known by whole voxels.
constexpr double viscosity_pace = 1.0 / 32;

/// Leads the viscosity to that of the space. Returns true if the space became viscous or free.
bool follow_viscosity(const Servo& servo, ServoState& state, const HapticModel& model) {
    const double wanted = model.viscosity > 0 ? std::min(model.viscosity, servo.most_damping) : 0;
    const bool jumped = (wanted > 0) != (state.viscosity > 0);
    const double pace = viscosity_pace * servo.most_damping, before = state.viscosity;
    state.viscosity = jumped ? wanted : std::clamp(wanted, before - pace, before + pace);
    return jumped;
}

/// Sources that appeared, ended or jumped with the model of this tick.
struct Switches {
    bool patch{};  ///< true: the patch of surfaces jumped
    bool any{};    ///< true: there is at least one
};

Switches detect_switches(const Servo& servo, ServoState& state, const HapticModel& model) {
    const bool set = detect_set_switch(state, model);
    const bool source = detect_source_switch(state, model);
    const bool lost = has_lost_body(model.patch, state.surface);
    const bool patch = detect_patch_jump(state, model);
    const bool fluid = detect_fluid_switch(state.fluid, model.fluid);
    const bool viscosity = follow_viscosity(servo, state, model);
    return {.patch = patch, .any = set || source || lost || patch || fluid || viscosity};
}

struct Tip {
    vec3 position{}, velocity{};
    bool switched{};  ///< a source appeared, ended or jumped
    bool stops{};     ///< the model is stale, or the player wants no forces
};

// ---- energy -------------------------------------------------------------------------------------------------------

/// Forces on the tip by kind of source (N).
struct Sources {
    vec3 passive{}, active{};
    vec3 world{};    ///< part of the passive force whose other end the world holds
    vec3 springs{};  ///< part of the passive force that can give energy back
    vec3 tether{};   ///< part of the springs by the tether
};

/// A directed force has no minimum of energy. It may push for ever and is an active source.
bool conservative(const PrimitiveSet& set) {
    const auto items = set.items();
    return std::none_of(items.begin(), items.end(),
                        [](const Primitive& p) { return p.kind == PrimitiveKind::directed; });
}

/// Adds the force of the primitives to the sources. Without primitives, the proxy follows the tip.
void add_primitives(ServoState& state, const HapticModel& model, const Tip& tip, Sources& sources) {
    if (model.primitives.items().empty()) {
        state.proxy = tip.position;
        state.primitives = 0;
        return;
    }
    const vec3 force = feel_primitives(state, model, tip.position, tip.velocity);
    if (!conservative(model.primitives)) {
        sources.active += force;
        return;
    }
    sources.passive += force;
    sources.springs += force;
}

/// Adds the forces of a viscous space and of a stirred fluid to the sources. Returns the latter.
FluidForces add_fluid(const Servo& servo, ServoState& state, const HapticModel& model,
                      const ServoSample& sample, vec3 velocity, Sources& sources) {
    if (state.viscosity > 0) sources.passive -= state.viscosity * prompt_velocity(state, servo.quantum);
    if (state.fluid.number == 0) return {};
    const FluidForces fluid = feel_fluid(model.fluid, state.fluid,
                                         {sample.position, velocity, sample.model_age, servo.most_damping});
    sources.passive += fluid.passive;
    sources.active += fluid.active;
    return fluid;
}

/// Potential of a primitive, above its minimum (J).
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

/// Energy of the tether's spring, without its detents (J).
double tether_energy(const Tether& tether, vec3 tip, double cap) {
    if (!(tether.stiffness > 0)) return 0;
    const vec3 off = tip - tether.anchor;
    return within_cap(tether.stiffness * glm::dot(off, off) / 2, glm::length(off), cap);
}

/// Energy that tether and primitives hold (J). Energy beyond the cap was never put in.
double spring_energy(const ServoState& state, const HapticModel& model, const Tether& tether, vec3 tip,
                     double cap) {
    double held = tether_energy(tether, tip, cap);
    if (state.primitives != 0 && conservative(model.primitives)) {
        const vec3 off = tip - state.proxy;
        held += within_cap(model.coupling.stiffness * glm::dot(off, off) / 2, glm::length(off), cap);
        for (Primitive primitive : model.primitives.items()) {
            primitive.strength = std::min(primitive.strength, cap);
            held += potential(primitive, state.proxy);
        }
    }
    return held;
}

/// Most energy that surfaces and detents hold (J).
double other_energy(const Tether& tether, const SurfaceForces& surfaces, double cap) {
    const double notches = tether.stiffness > 0 ? tether.detents.depth * tether.detents.width / pi : 0;
    return notches + (surfaces.active ? 0 : within_cap(surfaces.stored, surfaces.stretch, cap));
}

/// Largest force that a spring exerts at the device now (N): less than the cap while the motors are warm,
/// zero while the output is stopped. A spring stretched meanwhile holds less than its potential, and the
/// difference was not created.
double largest_felt_force(const Servo& servo, const SafetyState& safety) {
    const bool whole = safety.cause <= static_cast<std::uint32_t>(SafetyCause::capped);
    return whole ? servo.limits.cap : glm::length(safety.output);
}

bool is_stopped(const SafetyState& safety) {
    return safety.cause >= static_cast<std::uint32_t>(SafetyCause::waiting);
}

/// Whether the springs may hold energy now that they did not receive: a source switched, the output was stopped, or the
/// player has raised the largest force.
bool may_hold_more(const Servo& servo, const ServoState& state, const Tip& tip) {
    return tip.switched || tip.stops || state.samples <= 1 || is_stopped(state.safety) ||
           servo.limits.cap > state.safety.cap;
}

/// Energy of a spring of the device's stiffness that has the force of the last tick (J).
double energy_of_output(const Servo& servo, const SafetyState& safety) {
    if (!(servo.most_stiffness > 0)) return 0;
    return glm::dot(safety.output, safety.output) / (2 * servo.most_stiffness);
}

/// Limits the springs, which pull with `pull` (N), to the force that their reserve allows. Returns that force (N).
double limit_to_reserve(const Servo& servo, const ServoState& state, double pull, Sources& sources) {
    const vec3 step = tip_motion(state, servo.quantum);
    const double outward = pull > 0 ? glm::dot(step, sources.springs) / pull : 0;
    const double most = force_of_reserve(
        state.energy, outward, pending_work(state.energy, step, servo.latency), servo.most_stiffness);
    if (!(pull > most)) return most;
    const double share = most / pull;
    sources.passive -= (1 - share) * sources.springs;
    for (vec3* part : {&sources.springs, &sources.world, &sources.tether}) *part *= share;
    return most;
}

/// Energy that the tether will create until the force of this tick has acted (J). The device holds every
/// force for a tick and delays it; meanwhile the spring relaxes. A hand at 2 m/s crosses the whole spring of
/// a Falcon in that time.
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

/// Energy that the controller takes out in this tick (J). Springs that are held back give no more than their reserve.
double energy_to_take_out(const PassivityObserver& observer, double held) {
    if (observer.held_back == 0) return surplus(observer, held);
    return surplus(observer, std::min(held, observer.reserve)) * (tick_seconds / repayment_time);
}

/// What the energy account allows in this tick (N).
struct EnergyLimits {
    vec3 brake{};                    ///< damping that keeps passive sources passive
    double reserve_force{HUGE_VAL};  ///< largest force of springs
};

/// Moves the anchor of a tether on to the present, for a model that is `age` ticks old. A model that is too
/// old gives no force, so its anchor stops there.
Tether moved_on(Tether tether, std::uint32_t age) {
    tether.anchor += tether.anchor_velocity * (std::min(age, freshest_ticks) * tick_seconds);
    return tether;
}

/// Largest damping of the passivity controller (N s/m). One encoder count in a tick is a velocity, too. If it is worth
/// more than this force, the controller shakes a tip that hardly moves. In a faster motion a count matters less.
double controller_damping(const Servo& servo, vec3 velocity) {
    constexpr double most_of_a_count = 0.28;  // largest force that one count may be worth (N)
    if (!(servo.quantum > 0)) return servo.most_damping;
    const double of_a_count = servo.quantum / tick_seconds;
    const double counts = std::max(1.0, glm::length(velocity) / (2 * of_a_count));
    return std::min(servo.most_damping, most_of_a_count / of_a_count * counts);
}

/// The brake that takes out `taken` (J) from a hand that feels the sources (N).
vec3 brake_sources(const Servo& servo, ServoState& state, double taken, const Sources& sources) {
    PassivityObserver& energy = state.energy;
    if (!(taken > 0) && energy.brake == vec3(0)) return vec3(0);
    vec3 brake{};
    // Without it, skips the velocity, which takes half the time of a quiet step.
    if (taken > 0) {
        const vec3 velocity = prompt_velocity(state, servo.quantum);
        brake = passivity_control(taken, velocity, controller_damping(servo, velocity));
    }
    const bool held_back = energy.held_back != 0;
    // The brake of a fluid acts at once and without a limit. With the limit, a flow that comes late created more than the
    // 0.02 J that are allowed.
    if (state.fluid.number != 0 && !held_back) return energy.brake = brake;
    return steady_brake(energy, brake, glm::length(held_back ? sources.springs : sources.passive));
}

/// Updates the passivity observer. Limits active sources to their budget, and after a switch the springs to their
/// reserve.
EnergyLimits update_energy(const Servo& servo, ServoState& state, const HapticModel& model,
                           const Tether& tether, const Tip& tip, const SurfaceForces& surfaces,
                           const FluidForces& fluid, Sources& sources) {
    const double felt = largest_felt_force(servo, state.safety);
    const double springs = spring_energy(state, model, tether, tip.position, servo.limits.cap);
    const double held =
        felt < servo.limits.cap ? spring_energy(state, model, tether, tip.position, felt) : springs;
    const bool stopped = is_stopped(state.safety), may_give = may_hold_more(servo, state, tip);
    double stored = (stopped ? held : springs) +
                    other_energy(tether, surfaces, stopped ? felt : servo.limits.cap) + fluid.stored;
    if (tip.stops) stored = std::max(stored, energy_of_output(servo, state.safety));
    // A tethered hand touches nothing else.
    const vec3 step = tether.stiffness > 0 ? tether.anchor_velocity * tick_seconds : surfaces.world_step;
    observe(state.energy, tip.position, step, stored, servo.latency, fluid.supplied);
    sources.active = within_budget(state.energy, sources.active);
    EnergyLimits limits;
    if (may_give && servo.most_stiffness > 0) hold_back(state.energy);
    const double pull = glm::length(sources.springs);
    if (state.energy.held_back != 0) {
        limits.reserve_force = limit_to_reserve(servo, state, pull, sources);
        forgive(state.energy, pull > 0);
        const bool fades = state.safety.fade != static_cast<std::uint32_t>(Fade::over);
        if (!may_give && !fades)
            release_if_covered(
                state.energy,
                {.energy = stored - fluid.stored,
                 .pull = pull,
                 .may_lie_ahead = model.primitives.by_proxy() && conservative(model.primitives)},
                servo.most_stiffness);
    }
    const double taken =
        energy_to_take_out(state.energy, held + expected_creation(servo, state.energy, tether, tip));
    limits.brake = brake_sources(servo, state, taken, sources);
    return limits;
}

void record_force(ServoState& state, vec3 output, const Sources& sources) {
    if (is_stopped(state.safety)) return record_ramp(state.energy, output);
    record_output(state.energy, output, sources.passive, sources.active, sources.world,
                  state.safety.unrequested);
}

}  // namespace

/// (n/pi) (cos(pi k/n) - cos(pi (k+1)/n)), written as a product so that no nearly equal numbers are
/// subtracted.
double half_sine(std::uint32_t at, std::uint32_t length) {
    if (at >= length) return 0;
    const double half_tick = pi / (2.0 * length);
    return det::sin(half_tick) / half_tick * det::sin((2.0 * at + 1) * half_tick);
}

Servo servo_of(const DeviceSpec& spec, double share) {
    return {.limits = safety_limits(spec, share),
            .most_damping = spec.max_damping,
            .latency = spec.latency,
            .quantum = spec.position_quantum,
            .most_stiffness = spec.max_stiffness};
}

SafetyLimits limits_of(const Servo& servo, std::uint32_t percent) {
    return percent == 0 ? servo.limits : with_share(servo.limits, percent / 100.0);
}

double detent_force(const Detents& detents, double along) {
    if (!(detents.depth > 0)) return 0;
    double force = 0;
    for (const double place : detents.places) {
        const double off = (along - place) / detents.width;
        if (std::abs(off) < 0.5) force -= detents.depth * det::sin(2 * pi * off);
    }
    return force;
}

vec3 tether_force(const Tether& tether, vec3 tip, vec3 velocity) {
    if (!(tether.stiffness > 0)) return vec3(0);
    const vec3 off = tip - tether.anchor;
    const double notch = detent_force(tether.detents, glm::dot(off, tether.detents.axis));
    return -tether.stiffness * off - tether.damping * (velocity - tether.anchor_velocity) +
           notch * tether.detents.axis;
}

ServoState resumed(const ServoState& before) {
    ServoState state;
    state.safety = before.safety;
    state.safety.output = vec3(0);
    state.safety.gate_open = state.safety.fade = 0;
    state.safety.fast_ticks = state.safety.ramp_ticks = 0;
    state.safety.cause = static_cast<std::uint32_t>(SafetyCause::stale);
    state.last_pulse = before.last_pulse;
    state.energy.created = std::max(before.energy.created, 0.0);
    state.energy.active_work = before.energy.active_work;
    state.energy.active = before.energy.active;
    state.energy.active_bin = before.energy.active_bin;
    state.energy.active_tick = before.energy.active_tick;
    state.energy.most_created = before.energy.most_created;
    state.energy.unsettled = resume_ticks;
    return state;
}

vec3 tip_velocity(const ServoState& state) {
    if (state.samples < 2) return vec3(0);
    const auto& ring = state.positions;
    const auto at = [&](std::size_t back) {
        return ring[(state.next_position + velocity_window - 1 - back) % velocity_window];
    };
    const std::uint32_t span = state.samples - 1;
    return (at(0) - at(span)) / (span * tick_seconds);
}

vec3 prompt_velocity(const ServoState& state, double quantum) {
    if (state.samples < 2) return vec3(0);
    const double slack = std::max(quantum, finest_motion);
    const auto& ring = state.positions;
    const auto at = [&](std::uint32_t back) {
        return ring[(state.next_position + velocity_window - 1 - back) % velocity_window];
    };
    const auto straight = [&](vec3 step, std::uint32_t span) {
        for (std::uint32_t i = 1; i < span; ++i) {
            const vec3 off = glm::abs(at(0) - static_cast<double>(i) * step - at(i));
            if (!(std::max({off.x, off.y, off.z}) <= slack)) return false;
        }
        return true;
    };
    vec3 step = at(0) - at(1);
    for (std::uint32_t span = 2; span < state.samples; ++span) {
        const vec3 mean = (at(0) - at(span)) / static_cast<double>(span);
        if (!straight(mean, span)) break;
        step = mean;
    }
    return step / tick_seconds;
}

vec3 tip_motion(const ServoState& state, double quantum) {
    return prompt_velocity(state, quantum) * tick_seconds;
}

double path_speed(const ServoState& state, double quantum) {
    if (state.samples < 2) return 0;
    const auto& ring = state.positions;
    const std::uint32_t oldest = state.samples == velocity_window ? state.next_position : 0;
    double path = 0;
    for (std::uint32_t i = 1; i < state.samples; ++i)
        path += glm::distance(ring[(oldest + i - 1) % velocity_window], ring[(oldest + i) % velocity_window]);
    const std::uint32_t steps = state.samples - 1;
    const double rounded =
        std::sqrt(3.0) * quantum * steps;  // half a quantum at each end of a step, along each axis
    const double least = path - rounded;
    return least < 0 ? 0 : least / (steps * tick_seconds);
}

vec3 servo_step(const Servo& device, ServoState& state, const HapticModel& model, const ServoSample& sample) {
    Servo servo = device;
    servo.limits = limits_of(device, model.force_percent);
    const vec3 velocity = store_position(state, sample.position);
    const bool cut_off = start_pulse(state, model.pulse);
    const Switches switches = detect_switches(servo, state, model);
    const SurfaceForces surfaces =
        feel_surfaces(state, model, sample.model_age, {sample.position, velocity, switches.patch});
    const Tether tether = moved_on(model.tether, sample.model_age);
    const vec3 spring = tether_force(tether, sample.position, velocity);
    Sources sources{
        .active = play_pulses(state) + model.steady_force.force, .world = spring, .tether = spring};
    (surfaces.active ? sources.active : sources.world) += surfaces.force;
    sources.passive = sources.springs = sources.world;
    const bool stops = !model.on || sample.model_age > freshest_ticks;
    const Tip tip{sample.position, velocity, switches.any || surfaces.switched, stops};
    add_primitives(state, model, tip, sources);
    const FluidForces fluid = add_fluid(servo, state, model, sample, velocity, sources);
    const EnergyLimits energy = update_energy(servo, state, model, tether, tip, surfaces, fluid, sources);
    const vec3 output = make_safe(servo.limits, state.safety,
                                  {.wanted = sources.passive + sources.active,
                                   .spring = sources.tether,
                                   .brake = energy.brake,
                                   .tip = sample.position,
                                   .velocity = velocity,
                                   .path_speed = path_speed(state, servo.quantum),
                                   .reserve_force = energy.reserve_force,
                                   .fade_energy = fade_energy(state.energy),
                                   .stiffness = servo.most_stiffness,
                                   .model_age = sample.model_age,
                                   .switched = cut_off || tip.switched,
                                   .settles = state.energy.unsettled != 0,
                                   .on = model.on,
                                   .panic = model.panic,
                                   .rearm = model.rearm});
    record_force(state, output, sources);
    return output;
}

}  // namespace thaum::haptics
