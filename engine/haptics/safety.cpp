#include "haptics/safety.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/energy.h"

// The stage holds the force back in two ways. Danger for the hand (a panic, a shut-off, a hand that is
// too fast) makes the force zero at once. With an old model, and for a player who wants no forces any
// more, it ramps to zero, because nothing says that the last force was wrong. After either, the force
// returns from zero through the slew limit.
//
// Every comparison is written so that NaN falls on the safe side.

namespace thaum::haptics {
namespace {

constexpr double excess_over_peak = 4;  // multiple of the device's peak
// Multiple of the device's peak. A small thing caught behind a corner stretches the lift wand's spring to 125
// N before it slips away. That is 38 times the peak of a Touch. Such a force is clipped and is no fault.
constexpr double stretched_over_peak = 50;
/// Continuous force of a device that does not tell its own, as a share of its peak. The smallest share of the
/// known ones: a Premium holds 1.4 of 8.5 N, a Touch 0.88 of 3.3 N, a Falcon 3 of 8 N.
constexpr double unknown_continuous = 0.16;
constexpr double switching_slew = 40;  // change of force at a switch (N/s)
// Speed limit (m/s). A simulated hand that is flung across a Touch reaches 3.8 m/s, across a Premium 4.5 m/s.
// Chosen, without a source.
constexpr double fastest_hand = 4;
constexpr auto ramp_length = static_cast<std::uint32_t>(ticks(ramp_seconds));
// Ticks below half the speed limit before an over-speed cut ends.
constexpr std::uint32_t calm_ticks = 100;
constexpr std::uint32_t apart_ticks = 20;  // ticks without excess between two episodes of it
constexpr std::uint32_t episode_ticks = 10'000;
constexpr std::uint32_t bin_ticks = 500;
// Without it, rounding may leave a slew one tick short of its end.
constexpr double almost_there = 1 + 1e-9;
// Shares of the thermal budget: a burst is held back from the first one and ends at the second one. The rest
// is for a hand that presses on.
constexpr double warm_from = 0.8, burst_until = 0.9;
// Time constant with which a held-back force rises to the sustained one (s).
constexpr double rise_time = 0.5;
static_assert((thermal_bins - 2) * bin_ticks == ticks(thermal_window));

bool latched(const SafetyState& state, SafetyCause cause) {
    return state.latched == static_cast<std::uint32_t>(cause);
}

void latch(SafetyState& state, SafetyCause cause) {
    state.latched = std::max(state.latched, static_cast<std::uint32_t>(cause));
}

/// Shortens a force to `most`. Components come first because the length of a huge vector overflows. The
/// result ends slightly below `most`, so that rounding cannot exceed it.
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

/// Counts episodes of excess. One wild tick may be a glitch. Three bursts in ten seconds are a fault, and
/// shut the device off.
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

/// Returns true while the hand is too fast, or was too fast and has not calmed down.
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

/// Returns true if the model is stale. Counts the ticks of the ramp itself because the age may jump; the ramp
/// then still starts at its beginning.
bool update_ramp(SafetyState& state, const SafetyInput& input) {
    const bool stale = input.model_age > freshest_ticks;
    state.ramp_ticks = stale || !input.on ? std::min(state.ramp_ticks + 1, ramp_length) : 0;
    return stale;
}

/// Opens the start gate. The first force let through must be in range, so that no large force meets a player
/// at the start (003).
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

// ---- heat
// ---------------------------------------------------------------------------------------------------------

/// Heat of the window (N^2 s). It covers up to one bin more than the window, never less: the oldest bin fades
/// while the newest fills.
double heat_of(const SafetyState& state) {
    const std::size_t oldest = (state.bin + 1) % thermal_bins;
    double sum = 0;
    for (const double heat : state.heat) sum += heat;
    return sum - state.heat[oldest] * ((state.tick + 1.0) / bin_ticks);
}

double budget_of(const SafetyLimits& limits) {
    return limits.continuous * limits.continuous * thermal_window;
}

/// Square of the largest force that can be sustained from now on (N^2): at the end of no bin, when another
/// has faded, does the heat exceed the budget. Sustaining it never lowers it, since what was possible stays
/// possible. It approaches the square of the continuous force, less the cost of the bin beyond the window.
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

/// Force that the motors can still take (N). A burst after rest may use most of the budget. While the force
/// is held back, it rises only if a larger force can be sustained. Otherwise a hand that presses on would get
/// a burst whenever the last one leaves the window, and nothing in between.
double thermal_limit(const SafetyLimits& limits, const SafetyState& state) {
    const double budget = budget_of(limits), heat = heat_of(state), left = budget - heat;
    if (!(left > 0)) return 0;
    const bool held_back = state.heat_limit > 0;
    const double share = (left - (1 - burst_until) * budget) / ((burst_until - warm_from) * budget);
    const bool was_stopped = state.cause >= static_cast<std::uint32_t>(SafetyCause::waiting);
    if (share >= 1 && (!held_back || was_stopped)) return limits.cap;
    const double cool = std::clamp(share, 0.0, 1.0);
    double burst = limits.cap * cool * (2 - cool);  // no kink where it starts
    double kept_up = std::sqrt(sustained(limits, state, heat));
    if (held_back) {
        const double before = state.heat_limit;
        burst = std::min(burst, before);
        kept_up = std::min(kept_up, before + (kept_up - before) * (tick_seconds / rise_time));
    }
    // A cap that is lowered lowers the burst. The force comes down to both alike.
    const double falling = glm::length(state.output) - cap_slew * tick_seconds;
    const double at_most = std::sqrt(left / tick_seconds);  // stays within the budget in this tick
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

/// Length by which the offset fades in a tick (N): the less work it may still do, the more.
double fade_step(const SafetyLimits& limits, const SafetyInput& input) {
    const double used = 1 - std::clamp(input.fade_energy / switch_energy, 0.0, 1.0);
    return (limits.slew + used * std::max(0.0, cap_slew - limits.slew)) * tick_seconds;
}

/// Lets the offset take up the difference between the last output and the sources. The last output may exceed
/// the present limit, because the cap may have been lowered.
void take_up(double most, SafetyState& state, vec3 goal) {
    state.remnant = shortened(state.output, most);
    state.offset = state.remnant - goal;
}

/// Adds the offset's work since the last tick. A step that no hand makes is a measurement error and
/// does no work. With a reserve, springs that resist count against the offset: if it gave way to a hand
/// that presses in, the force would rise twice as steeply as the springs alone. Of an offset that
/// begins, the last output did the work.
void add_fade_work(SafetyState& state, const SafetyInput& input, bool begins) {
    const vec3 step = input.tip - state.tip;
    double work = glm::dot(state.offset, step);
    if ((begins || input.reserve_force < HUGE_VAL) && work > 0)
        work = std::clamp(glm::dot(state.output, step), 0.0, work);
    if (glm::length(step) <= longest_step) state.fade_work = std::max(0.0, state.fade_work + work);
}

/// Work that an offset of `length` (N) may do (J). It is at least that of a spring of the device's stiffness,
/// so that a small motion of the hand does not take the whole force away.
double work_of_offset(double length, const SafetyInput& input) {
    const double of_spring = input.stiffness > 0 ? length * length / (2 * input.stiffness) : 0;
    return std::clamp(input.fade_energy, std::min(of_spring, switch_energy), switch_energy);
}

/// Starts a switch. The output stays. But if another offset still faded, the work of its last tick counts:
/// else no offset would ever give way while there is a switch in every tick.
void begin_fade(const SafetyLimits& limits, double most, SafetyState& state, vec3 goal,
                const SafetyInput& input) {
    const bool goes_on = glm::length(state.offset) > fade_step(limits, input);
    take_up(most, state, goal);
    state.initial_offset = glm::length(state.offset);
    state.fade_work = 0;
    state.fade_budget = work_of_offset(state.initial_offset, input);
    state.fade = static_cast<std::uint32_t>(Fade::running);
    if (goes_on) add_fade_work(state, input, true);
}

/// Lets the offset take up a jump of sources that settle after a switch. Its budget of work stays.
void settle(double most, SafetyState& state, vec3 goal) {
    take_up(most, state, goal);
    state.initial_offset = std::max(state.initial_offset, glm::length(state.offset));
}

/// Length that the work done so far allows (N). An offset that falls in proportion to the distance along it,
/// like a relaxing spring, follows this law exactly. It is zero when it has done all its work.
double length_after_work(const SafetyState& state) {
    if (!(state.fade_budget > 0)) return 0;
    const double left = std::clamp(1 - state.fade_work / state.fade_budget, 0.0, 1.0);
    return state.initial_offset * std::sqrt(left);
}

/// Length that the offset keeps in this tick even if it has done all its work (N): it makes no larger jump
/// than a spring of the device's stiffness and a cap that comes down.
double min_length(const SafetyState& state, const SafetyInput& input, double size) {
    if (!(input.stiffness > 0 && size > 0)) return 0;
    const double outward = glm::dot(state.offset, input.tip - state.tip) / size;
    return size - cap_slew * tick_seconds - input.stiffness * std::max(0.0, outward);
}

/// Largest share of the offset, 0 to 1, that is no farther from what is left of the last force than the
/// goal is long. While the goal stays, it is all of it. An offset that hides a goal which ends would else
/// pull the hand where no source does.
double part_that_hides(const SafetyState& state, vec3 goal) {
    const double square = glm::dot(state.offset, state.offset);
    if (!(square > 0)) return 1;
    const double nearest = glm::dot(state.offset, state.remnant) / square;
    const vec3 across = nearest * state.offset - state.remnant;
    const double room = glm::dot(goal, goal) - glm::dot(across, across);
    return std::clamp(nearest + std::sqrt(std::max(0.0, room) / square), 0.0, 1.0);
}

/// Smallest share of the offset, 0 to 1, with which the output jumps no farther than a cap that comes down
/// and a spring of the device's stiffness explain; if none does, the share with the smallest jump.
double steady_part(const SafetyState& state, vec3 goal, const SafetyInput& input) {
    const double square = glm::dot(state.offset, state.offset);
    if (!(input.stiffness > 0 && square > 0)) return 0;
    const vec3 jump = goal - state.output;
    const double room = cap_slew * tick_seconds + input.stiffness * glm::length(input.tip - state.tip);
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
    state.offset = {};
    return goal;
}

/// Returns the force after a switch: the goal, which is never delayed, plus the fading offset. The offset
/// only gets shorter.
vec3 faded(const SafetyLimits& limits, double most, SafetyState& state, vec3 goal, const SafetyInput& input) {
    if (input.settles && state.fade == static_cast<std::uint32_t>(Fade::over))
        state.fade = static_cast<std::uint32_t>(Fade::begins);
    if (state.fade == static_cast<std::uint32_t>(Fade::over)) return goal;
    if (state.fade == static_cast<std::uint32_t>(Fade::begins))
        begin_fade(limits, most, state, goal, input);
    else
        add_fade_work(state, input, false);
    if (input.settles) settle(most, state, goal);
    const double step = fade_step(limits, input), size = glm::length(state.offset);
    state.remnant = shorter_by(state.remnant, step);
    const double worked = std::max(length_after_work(state), min_length(state, input, size));
    const double left = std::min(size, worked) - step;
    if (!(left > step * (almost_there - 1))) return without_offset(state, goal);
    const double steady = steady_part(state, goal, input), share = left / size;
    const vec3 before = state.offset;
    state.offset *= share;
    const double hiding = share * part_that_hides(state, goal);
    state.offset = std::min(std::max(hiding, steady), share) * before;
    // The nearest force within the cap: so the offset gets shorter, and a goal that
    // comes to the cap makes no jump.
    const vec3 force = goal + state.offset, within = shortened(force, most);
    if (within != force) state.offset = within - goal;
    if (state.offset == vec3(0)) return without_offset(state, goal);
    return within;
}

/// Scales the last output, so that the ramp is linear from any start; the last factor is zero.
vec3 ramped_down(const SafetyState& state) {
    const auto left = static_cast<double>(ramp_length - state.ramp_ticks);
    return state.output * (left / (left + 1));
}

SafetyCause shortening(const SafetyLimits& limits, double most, vec3 wanted) {
    if (glm::length(wanted) <= most) return SafetyCause::none;
    return most < limits.cap ? SafetyCause::warm : SafetyCause::capped;
}

/// Largest force of a ramp to zero (N): that of the reserve, or else one that
/// is no jump from the last output.
double max_of_ramp(const SafetyState& state, const SafetyInput& input) {
    const double size = glm::length(state.output);
    const double outward = size > 0 ? glm::dot(state.output, input.tip - state.tip) / size : 0;
    const double falls = cap_slew * tick_seconds + input.stiffness * std::max(0.0, outward);
    return std::max(input.reserve_force, size - falls);
}

/// Whether a stopped force ramps down. A hand that is too fast gets none at once.
bool ramps(const SafetyState& state, SafetyCause cause) {
    return (cause == SafetyCause::stale || cause == SafetyCause::off) && state.fast_ticks == 0;
}

/// Moves the cap in force to the player's, and returns the limits with it. Each move is a switch. A lower cap
/// comes down from the last output, so that the force does not jump.
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
    if (!follows) state.offset = {};
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
