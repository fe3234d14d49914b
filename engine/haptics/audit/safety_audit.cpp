#include "haptics/audit/safety_audit.h"

#include <cmath>
#include <numeric>

namespace thaum::haptics {
namespace {

// The limits below are written here again instead of taken from the safety stage (haptics/safety.h). A wrong
// number there would otherwise be wrong here too, and the audit would not notice.

// Time over which the motors' heat, the mean square of the force, is averaged (ticks).
constexpr std::uint64_t window_ticks = 10'000;
// Longest time over which the safety stage may sum squared forces (ticks). It forgets old ticks only in whole
// groups, so its sum may hold some ticks that are older than the 10 s of the average.
constexpr std::uint64_t memory_ticks = 11'000;
constexpr double longest_hand_step = 0.05;  // longest plausible motion of the tip in a tick (m)
// Share of the largest allowed mean square of the force (the limit that keeps the motors cool) below which
// the safety stage may not scale a force down.
constexpr double surely_cool = 0.8 * (1 - 1e-9);
// Largest age of a haptic model (description of the world near the hand) at which the device still gets the
// full force (ticks).
constexpr std::uint64_t fresh_for = 20;
constexpr double ramp_to_zero = 50;  // time in which a force is ramped to zero (ticks)
// Largest fall of the output in a tick after the cap, the largest allowed force, was lowered (N).
constexpr double cap_falls_by = 0.4;
// When the wanted force jumps, the safety stage adds an offset that keeps the output where it was, and then
// fades it. This is the largest work on the hand by that offset (J).
constexpr double energy_of_a_switch = 0.01;
constexpr std::uint64_t calm_after = 100;  // time at low speed after which a force that was cut because of
                                           // speed returns (ticks)
// Ticks in which the wanted force is far too large belong to one episode if at most `episodes_apart` ticks
// lie between them. Three episodes that start within `episodes_within` ticks shut the device off.
constexpr std::uint64_t episodes_apart = 20;
constexpr std::uint64_t episodes_within = 10'000;

double length_of_vector(vec3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double rounding(vec3 v) { return 1e-12 * (1 + length_of_vector(v)); }

/// Distance of a point from the line segment between zero and `end`.
double distance_from_line(vec3 point, vec3 end) {
    const double square = glm::dot(end, end);
    const double along = square > 0 ? glm::clamp(glm::dot(point, end) / square, 0.0, 1.0) : 0;
    return length_of_vector(point - along * end);
}

/// Distance of a point from the parallelogram of all a * u + b * v, with a and b from 0 to 1.
double distance_from_parts(vec3 point, vec3 u, vec3 v) {
    // Part of v at right angles to u. It is computed in two passes, since after one subtraction rounding
    // leaves a small part along u.
    vec3 across = v;
    for (int pass = 0; pass < 2 && u != vec3(0); ++pass) across -= u * (glm::dot(across, u) / glm::dot(u, u));
    const double height = glm::dot(v, across);
    if (u != vec3(0) && height > 1e-24 * glm::dot(v, v)) {
        const double b = glm::dot(point, across) / height;
        const vec3 offset = point - b * v;
        const double a = glm::dot(offset, u) / glm::dot(u, u);
        if (a >= 0 && a <= 1 && b >= 0 && b <= 1) return length_of_vector(offset - a * u);
    }
    return std::fmin(std::fmin(distance_from_line(point, u), distance_from_line(point, v)),
                     std::fmin(distance_from_line(point - v, u), distance_from_line(point - u, v)));
}

/// Finds by bisection the largest share of `change`, 0 to 1, that leads from `force` to a point within the
/// cap (largest allowed force); 0 if none does.
double share_within(double cap, vec3 force, vec3 change) {
    const auto within = [&](double share) {
        return length_of_vector(force + share * change) <= cap * (1 + 1e-15);
    };
    const double square = glm::dot(change, change);
    double inside = square > 0 ? glm::clamp(-glm::dot(force, change) / square, 0.0, 1.0) : 0;
    if (within(1)) return 1;
    if (!within(inside)) return 0;
    double outside = 1;
    for (int halvings = 0; halvings < 60; ++halvings) {
        const double middle = (inside + outside) / 2;
        (within(middle) ? inside : outside) = middle;
    }
    return inside;
}

vec3 finite_or_zero(vec3 v) { return is_finite(v) ? v : vec3(0); }

vec3 within_cap(vec3 wanted, double cap) {
    const double largest =
        std::fmax(std::fmax(std::fabs(wanted.x), std::fabs(wanted.y)), std::fabs(wanted.z));
    if (largest == 0) return {};
    const vec3 unit_sized = wanted / largest;  // every component is at most 1, so the length cannot overflow
    const double size = length_of_vector(unit_sized);
    return largest * size <= cap ? wanted : unit_sized * (cap / size);
}

}  // namespace

const char* name(SafetyRule rule) {
    constexpr std::array<const char*, safety_rules> names{"finite",  "cap",      "budget",  "slew",
                                                          "unasked", "stale",    "waiting", "over_speed",
                                                          "off",     "shut_off", "panic"};
    return names[static_cast<std::size_t>(rule)];
}

SafetyAudit::SafetyAudit() : squared_outputs_(memory_ticks) {}

std::uint64_t SafetyAudit::violations() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

double SafetyAudit::warmth() const {
    return std::sqrt(std::fmax(window_sum_, 0) / static_cast<double>(window_ticks));
}

void SafetyAudit::record(const SafetyLimits& limits, const SafetyInput& input, vec3 output) {
    ++now_;
    count(SafetyRule::finite, !is_finite(output));
    output = finite_or_zero(output);
    follow_latches(limits, input);
    follow_hand(limits, input);
    follow_ramp(input);
    const SafetyLimits current = follow_cap(limits);
    if (!judge_stopped(input, output)) judge_following(current, input, output);
    tip_ = input.tip;
    heat(output);
    judge_always(current, output);
    last_output_ = output;
}

void SafetyAudit::count(SafetyRule rule, bool broken) {
    if (broken) ++counts_[static_cast<std::size_t>(rule)];
}

void SafetyAudit::follow_latches(const SafetyLimits& limits, const SafetyInput& input) {
    if (input.rearm && (panicked_ || shut_off_)) {
        panicked_ = shut_off_ = gate_open_ = false;
        last_excess_ = 0;
        episodes_ = {};
    }
    if (input.panic) panicked_ = true;

    const double size = is_finite(input.wanted) ? length_of_vector(input.wanted) : HUGE_VAL;
    if (size <= limits.cap) gate_open_ = true;
    const double spring = length_of_vector(input.spring),
                 excess = length_of_vector(input.wanted - input.spring);
    if (is_finite(input.wanted) && excess <= limits.excess && spring <= limits.spring_excess) return;
    if (last_excess_ == 0 || now_ - last_excess_ > episodes_apart) {
        episodes_ = {episodes_[1], episodes_[2], now_};
        if (episodes_[0] != 0 && now_ - episodes_[0] <= episodes_within) shut_off_ = true;
    }
    last_excess_ = now_;
}

void SafetyAudit::follow_hand(const SafetyLimits& limits, const SafetyInput& input) {
    const bool known = is_finite(input.velocity) && !std::isnan(input.path_speed);
    const double speed = known ? std::fmax(length_of_vector(input.velocity), input.path_speed) : HUGE_VAL;
    if (now_ - last_too_fast_ > calm_after) last_too_fast_ = 0;
    const bool cut_out = last_too_fast_ != 0;
    if (speed > limits.max_speed || (cut_out && speed >= limits.max_speed / 2)) last_too_fast_ = now_;
}

void SafetyAudit::follow_ramp(const SafetyInput& input) {
    if (input.model_age <= fresh_for && input.on)
        last_felt_ = now_;
    else if (last_felt_ + 1 == now_)
        ramp_start_ = last_output_;
}

/// Returns the limits with the cap (largest allowed force) that holds in this tick. When the game lowers the
/// cap, the limit falls tick by tick from the last output down to it. Each change of the cap counts as a
/// switch: a jump of the force, which the safety stage fades.
SafetyLimits SafetyAudit::follow_cap(SafetyLimits limits) {
    if (limits.cap != cap_) next_is_switch_ = true;
    const double falling = std::fmin(cap_, length_of_vector(last_output_)) - cap_falls_by;
    cap_ = limits.cap >= cap_ ? limits.cap : std::fmax(limits.cap, falling);
    limits.cap = cap_;
    return limits;
}

void SafetyAudit::judge_always(const SafetyLimits& limits, vec3 output) {
    count(SafetyRule::cap, length_of_vector(output) > limits.cap);
    const double most = limits.continuous * limits.continuous * static_cast<double>(window_ticks);
    count(SafetyRule::budget, window_sum_ > most * (1 + 1e-9));
}

/// Whether the output has the direction that it had when the ramp to zero began, and is no longer than the
/// ramp allows in this tick.
bool SafetyAudit::is_on_ramp(vec3 output) const {
    const double left = 1 - static_cast<double>(now_ - last_felt_) / ramp_to_zero;
    if (!(left > 0)) return output == vec3(0);
    return distance_from_line(output, ramp_start_ * left) <= rounding(ramp_start_);
}

/// Checks the output while a condition stops the force, such as a panic or an old haptic model. The first
/// force after it then counts as a switch (a jump that has to be faded). Returns false if nothing stops the
/// force.
bool SafetyAudit::judge_stopped(const SafetyInput& input, vec3 output) {
    const bool stale = last_felt_ != now_;
    const bool felt = output != vec3(0);
    if (panicked_) {
        count(SafetyRule::panic, felt);
    } else if (shut_off_) {
        count(SafetyRule::shut_off, felt);
    } else if (!input.on) {
        count(SafetyRule::off, last_too_fast_ != 0 ? felt : !is_on_ramp(output));
    } else if (last_too_fast_ != 0) {
        count(SafetyRule::over_speed, felt);
    } else if (stale) {
        count(SafetyRule::stale, !is_on_ramp(output));
    } else if (!gate_open_) {
        count(SafetyRule::waiting, felt);
    } else {
        return false;
    }
    next_is_switch_ = true;
    unscaled_ = offset_known_ = true;
    may_be_fading_ = false;
    offset_ = {};
    return true;
}

bool SafetyAudit::is_cool(const SafetyLimits& limits) const {
    const double budget = limits.continuous * limits.continuous * static_cast<double>(window_ticks);
    return memory_sum_ <= surely_cool * budget;
}

/// Length by which the offset that hides a jump of the force fades in a tick (N). While the offset may still
/// do all of its work on the hand, the step is that of the slew limit, the rate of an ordinary fade. The less
/// work it may still do (SafetyInput::fade_energy), the nearer the step is to the larger `cap_falls_by`, so
/// that the offset ends sooner.
double fading_step(const SafetyLimits& limits, const SafetyInput& input) {
    const double slow = limits.slew * tick_seconds;
    const double left = std::fmin(1, std::fmax(0, input.fade_energy / energy_of_a_switch));
    return std::fmax(slow, slow * left + cap_falls_by * (1 - left));
}

/// Starts a fade at a switch (a jump of the wanted force). Checks that the output does not jump there. It may
/// become shorter at once if the motors are warm or the cap has been lowered.
void SafetyAudit::begin_fade(const SafetyLimits& limits, const SafetyInput& input, vec3 goal, vec3 output,
                             bool cool) {
    const bool may_shrink = !cool || length_of_vector(last_output_) > limits.cap;
    const double moved =
        may_shrink ? distance_from_line(output, last_output_) : length_of_vector(output - last_output_);
    const double step = limits.slew * tick_seconds;
    // No jump is counted if an offset (the force that hides a jump) of an earlier fade was still there. That
    // offset becomes shorter in this tick too, by the work that it did on the hand, so the output may change
    // by more. `fade_on` computes by how much, if the offset is known.
    if (!may_be_fading_)
        count(SafetyRule::slew, moved > fading_step(limits, input) * (1 + 1e-8) + rounding(last_output_));

    remnant_ = within_cap(last_output_, limits.cap);
    offset_ = remnant_ - goal;
    initial_length_ = length_of_vector(offset_);
    const double of_spring =
        input.stiffness > 0 ? initial_length_ * initial_length_ / (2 * input.stiffness) : 0;
    fade_budget_ = std::fmax(std::fmax(0, input.fade_energy), std::fmin(of_spring, energy_of_a_switch));
    fade_work_ = 0;
    const double longest = length_of_vector(last_output_) + length_of_vector(goal);
    last_fading_ = now_ + static_cast<Moment>(longest / step) + 1;
    next_is_switch_ = false;
    offset_known_ = offset_known_ || !may_be_fading_;
    may_be_fading_ = true;
}

/// Largest share of the offset, 0 to 1, that only hides the switch (jump of the wanted force) and does no
/// more: the largest with |share * offset - remnant| <= |goal|. The remnant is the output before the switch,
/// shortened by as much as time shortens the offset. The goal is the output without the offset. If no share
/// fulfils this, the result is the share with the smallest left side.
double SafetyAudit::share_that_hides(vec3 goal) const {
    const double square = glm::dot(offset_, offset_);
    if (!(square > 0)) return 1;
    const double nearest = glm::clamp(glm::dot(offset_, remnant_) / square, 0.0, 1.0);
    return std::fmax(nearest, share_within(length_of_vector(goal), -remnant_, offset_));
}

/// Smallest share of the offset, 0 to 1, with which the output does not jump, found by bisection. It does not
/// jump if it changes by at most the allowed change plus that of a spring of the device's stiffness while the
/// tip moves. If it jumps with every share, the result is the share with the smallest jump.
double SafetyAudit::steady_share(vec3 goal, const SafetyInput& input) const {
    const double square = glm::dot(offset_, offset_);
    if (!(input.stiffness > 0 && square > 0)) return 0;
    const double room = input.change + input.stiffness * length_of_vector(input.tip - tip_);
    const auto jumps = [&](double share) {
        return length_of_vector(goal + share * offset_ - last_output_) > room;
    };
    double steady = glm::clamp(glm::dot(last_output_ - goal, offset_) / square, 0.0, 1.0);
    if (jumps(steady)) return steady;
    if (!jumps(0)) return 0;
    double jumping = 0;
    for (int halvings = 0; halvings < 60; ++halvings) {
        const double middle = (jumping + steady) / 2;
        (jumps(middle) ? jumping : steady) = middle;
    }
    return steady;
}

/// Shortens the offset, the force that hides a jump, in one tick:
/// - to the length that the work it has done on the hand still allows, less one step (fading_step),
/// - to the share of this length that only hides the switch (share_that_hides),
/// - by less than that if the output would jump (steady_share),
/// - but at least by the step of the slowest fade (`limits.slew`), so that every fade ends,
/// - and finally until the sum of offset and goal, the output without the offset, is within the cap.
///
/// In the first tick of a fade, and while springs may give only a limited reserve of energy after a switch,
/// the work of the offset counts as at most that of the whole output.
void SafetyAudit::fade_on(const SafetyLimits& limits, vec3 goal, const SafetyInput& input, bool begins,
                          bool goes_on) {
    const vec3 moved = begins && !goes_on ? vec3(0) : input.tip - tip_;
    double work = glm::dot(offset_, moved);
    if ((begins || input.reserve_force < HUGE_VAL) && work > 0)
        work = std::fmin(work, std::fmax(0, glm::dot(last_output_, moved)));
    if (length_of_vector(moved) <= longest_hand_step) fade_work_ = std::fmax(0, fade_work_ + work);
    if (input.settles) {
        remnant_ = within_cap(last_output_, limits.cap);
        offset_ = remnant_ - goal;
        initial_length_ = std::fmax(initial_length_, length_of_vector(offset_));
        const double ticks_left = length_of_vector(offset_) / (limits.slew * tick_seconds);
        last_fading_ = std::max(last_fading_, now_ + static_cast<Moment>(ticks_left) + 1);
    }
    const double size = length_of_vector(offset_), step = fading_step(limits, input);
    const double remnant = length_of_vector(remnant_);
    remnant_ *= remnant > step ? 1 - step / remnant : 0;
    const double spared = fade_budget_ > 0 ? std::fmax(0, 1 - fade_work_ / fade_budget_) : 0;
    const double left = std::fmin(size, initial_length_ * std::sqrt(spared)) - step;
    const double longest = size - limits.slew * tick_seconds;
    const double share = left > 0 ? left / size : 0, steady = steady_share(goal, input);
    const vec3 whole = offset_;
    offset_ *= share;
    const double wished = std::fmax(steady, share * share_that_hides(goal));
    offset_ = longest > 0 ? whole * std::fmin(longest / size, wished) : vec3(0);
    offset_ = within_cap(goal + offset_, limits.cap) - goal;
}

void SafetyAudit::judge_following(const SafetyLimits& limits, const SafetyInput& input, vec3 output) {
    const bool cool = is_cool(limits);
    const vec3 wanted = within_cap(finite_or_zero(input.wanted), limits.cap);
    const vec3 brake = within_cap(finite_or_zero(input.brake), limits.cap);
    const vec3 goal = within_cap(wanted + brake, limits.cap);
    const bool begins = next_is_switch_ || input.switched || (input.settles && !may_be_fading_);
    const bool goes_on = may_be_fading_ && length_of_vector(offset_) > fading_step(limits, input);
    if (begins) begin_fade(limits, input, goal, output, cool);
    const bool all_of_it = brake == vec3(0) && length_of_vector(output - goal) <= rounding(goal);
    unscaled_ = cool && (unscaled_ || all_of_it);
    offset_known_ = offset_known_ && unscaled_;
    if (offset_known_) {
        fade_on(limits, goal, input, begins, goes_on);
        const vec3 expected = within_cap(goal + offset_, limits.cap);
        const double tolerance = rounding(expected) + 1e-8 * limits.slew * tick_seconds;
        count(SafetyRule::slew, length_of_vector(output - expected) > tolerance);
        may_be_fading_ = offset_known_ = offset_ != vec3(0);
    } else if (!may_be_fading_) {
        const double off =
            unscaled_ ? length_of_vector(output - goal) : distance_from_parts(output, wanted, brake);
        count(SafetyRule::unasked, off > rounding(wanted));
    }
    if (now_ > last_fading_) may_be_fading_ = offset_known_ = false;
}

void SafetyAudit::heat(vec3 output) {
    const auto at = static_cast<std::size_t>(now_ % memory_ticks);
    const auto leaves_window = static_cast<std::size_t>((now_ + memory_ticks - window_ticks) % memory_ticks);
    const double square = glm::dot(output, output);
    memory_sum_ += square - squared_outputs_[at];
    window_sum_ += square - squared_outputs_[leaves_window];
    squared_outputs_[at] = square;
    if (at != 0) return;
    // The sums over 10 s and over `memory_ticks` are computed anew once in `memory_ticks`, so that rounding
    // does not accumulate. Index 0 is the newest output; after it come the oldest, which only `memory_sum_`
    // contains.
    const auto in_memory_only = static_cast<std::ptrdiff_t>(memory_ticks - window_ticks);
    const double older =
        std::accumulate(squared_outputs_.begin() + 1, squared_outputs_.begin() + 1 + in_memory_only, 0.0);
    window_sum_ = std::accumulate(squared_outputs_.begin() + 1 + in_memory_only, squared_outputs_.end(),
                                  squared_outputs_[0]);
    memory_sum_ = window_sum_ + older;
}

}  // namespace thaum::haptics
