#include "haptics/safety.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/energy.h"

// The safety stage stops the force in two ways. Danger for the hand (a panic, a shut-off, a hand that is too
// fast) makes the force zero at once. With an old model, and for a player who wants no forces any more, the
// force ramps to zero, because nothing says that the last force was wrong. After either, the force returns
// from zero through the slew limit.
//
// Every comparison is written so that NaN falls on the safe side.

namespace thaum::haptics {
namespace {

// Largest force that a correct source asks for (SafetyLimits::excess), as a multiple of the device's peak.
constexpr double excess_over_peak = 4;
// Largest force that a tether may ask for (SafetyLimits::spring_excess), as a multiple of the device's peak.
// A small thing caught behind a corner stretches the lift wand's spring to 125 N before it slips away. That
// is 38 times the peak of a Touch. Such a force is clipped and is no fault.
constexpr double stretched_over_peak = 50;
/// Continuous force of a device that does not specify it, as a share of its peak. The smallest share of the
/// devices that do: a Premium holds 1.4 of 8.5 N, a Touch 0.88 of 3.3 N, a Falcon 3 of 8 N.
constexpr double unknown_continuous = 0.16;
constexpr double switching_slew = 40;  // rate at which the offset that hides a jump fades (N/s)
// Speed limit (m/s). A simulated hand that is flung across a Touch reaches 3.8 m/s, across a Premium 4.5 m/s.
// The limit is our choice; it has no source.
constexpr double fastest_hand = 4;
constexpr auto ramp_length = static_cast<std::uint32_t>(ticks(ramp_seconds));
// Ticks that the tip must stay below half the speed limit until a force that was cut because of speed
// returns.
constexpr std::uint32_t calm_ticks = 100;
// Excess is a wanted force beyond what any correct source asks for. Ticks with excess belong to one episode
// until this many ticks in a row are without excess.
constexpr std::uint32_t apart_ticks = 20;
constexpr std::uint32_t episode_ticks = 10'000;  // ticks after which an episode of excess is forgotten
// Length of a bin, over which the squared force is summed as heat (ticks).
constexpr std::uint32_t bin_ticks = 500;
// Tolerance for the end of a fade. Without it, rounding may make a fade one tick too long.
constexpr double almost_there = 1 + 1e-9;
// Shares of the thermal budget (the heat that the motors bear in 10 s) that a burst, a short force above the
// sustained one, may use. From the first share on the force is reduced; at the second one the burst is over.
// The rest of the budget is for a hand that presses on.
constexpr double warm_from = 0.8, burst_until = 0.9;
// Time constant with which a force reduced by heat rises to the largest force that can be sustained (s).
constexpr double rise_time = 0.5;
static_assert((thermal_bins - 2) * bin_ticks == ticks(thermal_window));

bool latched(const SafetyState& state, SafetyCause cause) {
    return state.latched == static_cast<std::uint32_t>(cause);
}

void latch(SafetyState& state, SafetyCause cause) {
    state.latched = std::max(state.latched, static_cast<std::uint32_t>(cause));
}

/// Shortens a force to the length `most` (N). It first scales by the largest component, because the length of
/// a huge vector overflows. The result is slightly shorter than `most`, so that rounding cannot exceed it.
vec3 shortened(vec3 force, double most) {
    constexpr double below = 1 - 2e-15;
    const double largest = std::max({std::abs(force.x), std::abs(force.y), std::abs(force.z)});
    if (largest > most) force *= most / largest;
    const double length = glm::length(force);
    return length > most ? force * (most / length * below) : force;
}

// ---- latches, gate and counters: the stage's memory of its input ------------------------------------------

void update_rearm(SafetyState& state, const SafetyInput& input) {
    if (!input.rearm || state.latched == 0) return;
    state.latched = 0;
    state.gate_open = 0;
    state.excess_ticks = 0;
    state.excess_count = 0;
}

void forget_old_episodes(SafetyState& state) {
    for (std::uint32_t i = 0; i < state.excess_count; ++i) ++state.episodes[i];
    if (state.excess_count == 0 || state.episodes[0] <= episode_ticks) return;
    state.episodes[0] = state.episodes[1];
    --state.excess_count;
}

void begin_episode(SafetyState& state) {
    if (state.excess_count == state.episodes.size()) return latch(state, SafetyCause::shut_off);
    state.episodes[state.excess_count++] = 0;
}

/// Counts episodes of excess, wanted forces beyond what any correct source asks for. One such tick may be a
/// glitch. Three episodes in ten seconds are a fault, and shut the device off.
void count_excess(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) {
    forget_old_episodes(state);
    const bool sane = is_finite(input.wanted) && glm::length(input.wanted - input.spring) <= limits.excess &&
                      glm::length(input.spring) <= limits.spring_excess;
    if (sane) {
        if (state.excess_ticks > 0) --state.excess_ticks;
        return;
    }
    if (state.excess_ticks == 0) begin_episode(state);
    state.excess_ticks = apart_ticks;
}

/// Returns true while the force must be zero because of speed: the hand is too fast, or was too fast and has
/// not calmed down.
bool update_speed(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) {
    const double net = glm::length(input.velocity);
    if (!(net <= limits.max_speed && input.path_speed <= limits.max_speed)) {
        state.fast_ticks = calm_ticks;
        return true;
    }
    if (state.fast_ticks == 0) return false;
    const double speed = std::max(net, input.path_speed);
    state.fast_ticks = speed < limits.max_speed / 2 ? state.fast_ticks - 1 : calm_ticks;
    return true;
}

/// Returns true if the haptic model is stale. Counts the ticks of a ramp of the force to zero. They are not
/// taken from the model's age: the age may jump, but the ramp must start at its beginning.
bool update_ramp(SafetyState& state, const SafetyInput& input) {
    const bool stale = input.model_age > freshest_ticks;
    state.ramp_ticks = stale || !input.on ? std::min(state.ramp_ticks + 1, ramp_length) : 0;
    return stale;
}

/// Opens the start gate, which holds back all force at first. The first force let through must be within the
/// cap, so that no large force meets a player at the start.
void update_gate(const SafetyLimits& limits, SafetyState& state, vec3 wanted) {
    if (state.gate_open != 0 || !is_finite(wanted) || !(glm::length(wanted) <= limits.cap)) return;
    state.gate_open = 1;
    state.fade = static_cast<std::uint32_t>(Fade::begins);
}

/// Processes the whole input in every tick, so that no condition hides another. Returns the gravest reason to
/// stop the force.
SafetyCause process(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) {
    update_rearm(state, input);
    count_excess(limits, state, input);
    if (input.panic) latch(state, SafetyCause::panic);
    update_gate(limits, state, input.wanted);
    const bool too_fast = update_speed(limits, state, input);
    const bool stale = update_ramp(state, input);
    if (latched(state, SafetyCause::panic)) return SafetyCause::panic;
    if (latched(state, SafetyCause::shut_off)) return SafetyCause::shut_off;
    if (!input.on) return SafetyCause::off;
    if (too_fast) return SafetyCause::over_speed;
    if (stale) return SafetyCause::stale;
    return state.gate_open == 0 ? SafetyCause::waiting : SafetyCause::none;
}

// ---- heat -------------------------------------------------------------------------------------------------

/// Heat of the last 10 s (N^2 s), the integral of the squared output. It covers up to one bin more than that,
/// never less: the oldest bin counts less and less while the newest is being filled.
double heat_of(const SafetyState& state) {
    const std::size_t oldest = (state.bin + 1) % thermal_bins;
    double sum = 0;
    for (const double heat : state.heat) sum += heat;
    return sum - state.heat[oldest] * ((state.tick + 1.0) / bin_ticks);
}

double budget_of(const SafetyLimits& limits) {
    return limits.continuous * limits.continuous * thermal_window;
}

/// Square of the largest force that can be sustained from now on (N^2). With this force, the heat stays
/// within the budget at the end of every coming bin, when the oldest bin no longer counts. While the force is
/// sustained, this limit never falls. It approaches a little less than the square of the continuous force,
/// because the bins span a little more than the 10 s.
double sustained(const SafetyLimits& limits, const SafetyState& state, double heat) {
    const double budget = budget_of(limits);
    const std::size_t oldest = (state.bin + 1) % thermal_bins;
    heat += state.heat[oldest] * ((state.tick + 1.0) / bin_ticks);
    double seconds = (bin_ticks - state.tick) * tick_seconds;
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < thermal_bins; ++i) {
        heat -= state.heat[(oldest + i) % thermal_bins];
        most = std::min(most, (budget - heat) / seconds);
        seconds += bin_ticks * tick_seconds;
    }
    return std::max(most, 0.0);
}

/// Force that the motors can still take (N). A burst after rest may use most of the budget. Once heat limits
/// the force, it rises only if a larger force can be sustained. Otherwise a hand that presses on would get a
/// burst whenever the last burst is 10 s old, and hardly any force in between.
double thermal_limit(const SafetyLimits& limits, const SafetyState& state) {
    const double budget = budget_of(limits), heat = heat_of(state), left = budget - heat;
    if (!(left > 0)) return 0;
    const bool held_back = state.heat_limit > 0;
    const double share = (left - (1 - burst_until) * budget) / ((burst_until - warm_from) * budget);
    const bool was_stopped = state.cause >= static_cast<std::uint32_t>(SafetyCause::waiting);
    if (share >= 1 && (!held_back || was_stopped)) return limits.cap;
    const double cool = std::clamp(share, 0.0, 1.0);
    double burst = limits.cap * cool * (2 - cool);  // its slope is 0 where the reduction starts
    double kept_up = std::sqrt(sustained(limits, state, heat));
    if (held_back) {
        const double before = state.heat_limit;
        burst = std::min(burst, before);
        kept_up = std::min(kept_up, before + (kept_up - before) * (tick_seconds / rise_time));
    }
    // `burst` falls at once with a cap that is lowered. So `falling` lets the force fall by `cap_slew` only.
    const double falling = glm::length(state.output) - cap_slew * tick_seconds;
    const double at_most = std::sqrt(left / tick_seconds);  // a larger force would exceed the budget at once
    return std::min({std::max({burst, kept_up, falling}), at_most, limits.cap});
}

void add_heat(SafetyState& state, vec3 force) {
    state.heat[state.bin] += glm::dot(force, force) * tick_seconds;
    if (++state.tick < bin_ticks) return;
    state.tick = 0;
    state.bin = static_cast<std::uint32_t>((state.bin + 1) % thermal_bins);
    state.heat[state.bin] = 0;
}

// ---- force ------------------------------------------------------------------------------------------------

/// Length by which the offset that hides a jump of the force fades in a tick (N). The less work offsets may
/// still do, the faster it fades.
double fade_step(const SafetyLimits& limits, const SafetyInput& input) {
    const double used = 1 - std::clamp(input.fade_energy / switch_energy, 0.0, 1.0);
    return (limits.slew + used * std::max(0.0, cap_slew - limits.slew)) * tick_seconds;
}

/// Sets the offset to the difference between the last output and the goal (the force that the sources now
/// want), so that the output makes no jump. The last output is cut to `most` (N), which it exceeds if the cap
/// has been lowered. The active sources' part of the offset is the difference between their parts of the last
/// output and of the goal.
void take_up(double most, SafetyState& state, vec3 goal, const SafetyInput& input) {
    state.remnant = shortened(state.output, most);
    state.offset = state.remnant - goal;
    const double asked = glm::length(input.wanted);
    const double share = asked > most ? most / asked : 1;
    const vec3 active = shortened(input.last_active, most) - share * input.active;
    state.active_offset = is_finite(active) ? active : vec3(0);
}

/// Adds the work that the offset did on the hand since the last tick. A step longer than any hand makes is a
/// measurement error and does no work. While the springs have a reserve, the work of the offset counts as at
/// most that of the whole output: if the offset gave way to a hand that presses in, the force would rise
/// twice as steeply as that of the springs alone. The same holds in the tick in which an offset begins, since
/// the last output did the work.
void add_fade_work(SafetyState& state, const SafetyInput& input, bool begins) {
    const vec3 step = input.tip - state.tip;
    double work = glm::dot(state.offset, step);
    if ((begins || input.reserve_force < HUGE_VAL) && work > 0)
        work = std::clamp(glm::dot(state.output, step), 0.0, work);
    if (glm::length(step) <= longest_step) state.fade_work = std::max(0.0, state.fade_work + work);
}

/// Work that an offset of `length` (N) may do (J). It is at least the energy of a spring with that force and
/// the device's largest stiffness, so that a small motion of the hand does not take the whole force away.
double work_of_offset(double length, const SafetyInput& input) {
    const double of_spring = input.stiffness > 0 ? length * length / (2 * input.stiffness) : 0;
    return std::clamp(input.fade_energy, std::min(of_spring, switch_energy), switch_energy);
}

/// Starts the fade of the offset that hides a jump of the wanted force; the output stays what it was. If
/// another offset was still fading, the work that it did in its last tick counts for the new one. Otherwise
/// no offset would ever fade by its work while the force jumps in every tick.
void begin_fade(const SafetyLimits& limits, double most, SafetyState& state, vec3 goal,
                const SafetyInput& input) {
    const bool goes_on = glm::length(state.offset) > fade_step(limits, input);
    take_up(most, state, goal, input);
    state.initial_offset = glm::length(state.offset);
    state.fade_work = 0;
    state.fade_budget = work_of_offset(state.initial_offset, input);
    state.fade = static_cast<std::uint32_t>(Fade::running);
    if (goes_on) add_fade_work(state, input, true);
}

/// Lets the offset hide a jump of sources whose forces still jump for some ticks after a switch. The work
/// that the offset may do stays the same, so that such jumps give the hand no further energy.
void settle(double most, SafetyState& state, vec3 goal, const SafetyInput& input) {
    take_up(most, state, goal, input);
    state.initial_offset = std::max(state.initial_offset, glm::length(state.offset));
}

/// Length of the offset that its work so far allows (N); zero once it has done all its work. A relaxing
/// spring follows the same law: its force falls in proportion to the distance that it moves the hand.
double length_after_work(const SafetyState& state) {
    if (!(state.fade_budget > 0)) return 0;
    const double left = std::clamp(1 - state.fade_work / state.fade_budget, 0.0, 1.0);
    return state.initial_offset * std::sqrt(left);
}

/// Largest share of the offset, 0 to 1, whose distance from the remnant (what is left of the force before the
/// switch) is at most the length of the goal. While the goal does not change, the share is 1. Without this
/// limit, an offset that cancels a goal would pull the hand where no source does once that goal ends.
double part_that_hides(const SafetyState& state, vec3 goal) {
    const double square = glm::dot(state.offset, state.offset);
    if (!(square > 0)) return 1;
    const double nearest = glm::dot(state.offset, state.remnant) / square;
    const vec3 across = nearest * state.offset - state.remnant;
    const double room = glm::dot(goal, goal) - glm::dot(across, across);
    return std::clamp(nearest + std::sqrt(std::max(0.0, room) / square), 0.0, 1.0);
}

/// Smallest share of the offset, 0 to 1, with which the output does not jump. It does not jump if it changes
/// by at most `SafetyInput::change` plus the change of a spring of the device's stiffness while the tip
/// moves. If it jumps with every share, the result is the share with the smallest jump.
double steady_part(const SafetyState& state, vec3 goal, const SafetyInput& input) {
    const double square = glm::dot(state.offset, state.offset);
    if (!(input.stiffness > 0 && square > 0)) return 0;
    const vec3 jump = goal - state.output;
    const double room = input.change + input.stiffness * glm::length(input.tip - state.tip);
    const double nearest = -glm::dot(jump, state.offset) / square;
    const vec3 across = jump + nearest * state.offset;
    const double spare = room * room - glm::dot(across, across);
    return std::clamp(nearest - std::sqrt(std::max(0.0, spare) / square), 0.0, 1.0);
}

vec3 shorter_by(vec3 force, double step) {
    const double size = glm::length(force);
    return size > step ? force * (1 - step / size) : vec3(0);
}

vec3 without_offset(SafetyState& state, vec3 goal) {
    state.fade = static_cast<std::uint32_t>(Fade::over);
    state.offset = state.active_offset = {};
    return goal;
}

/// Returns the force after a switch: the goal (what the sources want, within the limits), which is never
/// delayed, plus the fading offset. The offset only gets shorter.
vec3 faded(const SafetyLimits& limits, double most, SafetyState& state, vec3 goal, const SafetyInput& input) {
    if (input.settles && state.fade == static_cast<std::uint32_t>(Fade::over))
        state.fade = static_cast<std::uint32_t>(Fade::begins);
    if (state.fade == static_cast<std::uint32_t>(Fade::over)) return goal;
    if (state.fade == static_cast<std::uint32_t>(Fade::begins))
        begin_fade(limits, most, state, goal, input);
    else
        add_fade_work(state, input, false);
    if (input.settles) settle(most, state, goal, input);
    const double step = fade_step(limits, input), size = glm::length(state.offset);
    const double steady = steady_part(state, goal, input);
    // Time always shortens the offset by `slew`, so that every fade ends.
    const double longest = size - limits.slew * tick_seconds;
    if (!(longest > step * (almost_there - 1))) return without_offset(state, goal);
    state.remnant = shorter_by(state.remnant, step);
    const vec3 before = state.offset;
    const double share = std::max(0.0, std::min(size, length_after_work(state)) - step) / size;
    state.offset *= share;
    const double wished = share * part_that_hides(state, goal);
    const double kept = std::min(std::max(wished, steady), longest / size);
    state.offset = kept * before;
    state.active_offset *= kept;
    // A sum beyond the cap is shortened, not its parts: so the offset only gets shorter, and the output does
    // not jump when the goal reaches the cap.
    const vec3 force = goal + state.offset, within = shortened(force, most);
    if (within != force) state.offset = within - goal;
    if (state.offset == vec3(0)) return without_offset(state, goal);
    return within;
}

/// The next output of a ramp to zero: the last output, times a factor that makes the ramp linear from any
/// start. The last factor is zero.
vec3 ramped_down(const SafetyState& state) {
    const auto left = static_cast<double>(ramp_length - state.ramp_ticks);
    return state.output * (left / (left + 1));
}

SafetyCause shortening(const SafetyLimits& limits, double most, vec3 wanted) {
    if (glm::length(wanted) <= most) return SafetyCause::none;
    return most < limits.cap ? SafetyCause::warm : SafetyCause::capped;
}

/// Largest force of a ramp to zero (N): the limit by the springs' reserve of energy, but no less than a force
/// that is no jump from the last output.
double max_of_ramp(const SafetyState& state, const SafetyInput& input) {
    const double size = glm::length(state.output);
    const double outward = size > 0 ? glm::dot(state.output, input.tip - state.tip) / size : 0;
    const double falls = cap_slew * tick_seconds + input.stiffness * std::max(0.0, outward);
    return std::max(input.reserve_force, size - falls);
}

/// Whether a stopped force ramps to zero, as with an old model. If the hand is too fast, the force is zero at
/// once.
bool ramps(const SafetyState& state, SafetyCause cause) {
    return (cause == SafetyCause::stale || cause == SafetyCause::off) && state.fast_ticks == 0;
}

/// Moves the cap in use, the largest allowed force, towards the player's, and returns the limits with it.
/// Each move counts as a switch, so an offset fades the change. To a lower cap, the cap in use falls from the
/// last output, so that the force does not jump.
SafetyLimits with_moved_cap(SafetyLimits limits, SafetyState& state) {
    if (limits.cap != state.cap) state.fade = static_cast<std::uint32_t>(Fade::begins);
    const double lower = std::min(state.cap, glm::length(state.output)) - cap_slew * tick_seconds;
    state.cap = limits.cap >= state.cap ? limits.cap : std::max(limits.cap, lower);
    limits.cap = state.cap;
    return limits;
}

vec3 final_force(double most, vec3 force) {
    const vec3 last = shortened(force, most);
    return is_finite(last) ? last : vec3(0);
}

}  // namespace

SafetyLimits with_share(SafetyLimits limits, double share) {
    const double part = share > 0 ? std::min(share, 1.0) : 0.0;  // 0 for NaN
    limits.cap = part * (limits.excess / excess_over_peak);
    return limits;
}

SafetyLimits safety_limits(const DeviceSpec& spec, double share) {
    const double part = share > 0 ? std::min(share, 1.0) : 0.0;  // 0 for NaN
    return {.cap = part * spec.peak_force,
            .excess = excess_over_peak * spec.peak_force,
            .spring_excess = stretched_over_peak * spec.peak_force,
            .continuous =
                spec.continuous_force > 0 ? spec.continuous_force : unknown_continuous * spec.peak_force,
            .slew = switching_slew,
            .max_speed = fastest_hand};
}

vec3 make_safe(const SafetyLimits& wished, SafetyState& state, const SafetyInput& input) {
    SafetyCause cause = process(wished, state, input);
    const SafetyLimits limits = with_moved_cap(wished, state);
    const double most = thermal_limit(limits, state);
    const vec3 wanted = is_finite(input.wanted) ? input.wanted : vec3(0);
    if (input.switched || cause != SafetyCause::none) state.fade = static_cast<std::uint32_t>(Fade::begins);

    const bool follows = cause == SafetyCause::none;
    vec3 force{}, target{};
    if (follows) {
        target = shortened(wanted, most);
        const vec3 brake = is_finite(input.brake) ? shortened(input.brake, most) : vec3(0);
        force = faded(limits, most, state, shortened(target + brake, most), input);
        cause = shortening(limits, most, wanted);
    } else if (ramps(state, cause)) {
        force = shortened(ramped_down(state), max_of_ramp(state, input));
    }
    if (!follows) state.offset = state.active_offset = {};
    const bool held_back = follows ? cause == SafetyCause::warm : state.heat_limit > 0 && most < limits.cap;
    state.heat_limit = held_back ? most : 0;
    state.output = final_force(most, force);
    state.unrequested = follows ? state.output - target : state.output;
    state.tip = input.tip;
    state.cause = static_cast<std::uint32_t>(cause);
    add_heat(state, state.output);
    return state.output;
}

}  // namespace thaum::haptics
