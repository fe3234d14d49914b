#include "input/collector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/units.h"

namespace thaum::input {
namespace {

// A trigger that was pressed counts as released when it is this far below the position at which it counts as
// pressed (share of its travel). This hysteresis keeps a trigger at its threshold from flickering.
constexpr double release_below_press = 0.1;
constexpr unsigned latch_shift = 32;
/// Wheel steps of a control that is held, per sample: the first step is at once, then there are 12 a second.
constexpr double wheel_steps_per_take = 0.012;

/// Returns the whole steps of `remainder` plus `amount`; `remainder` keeps the fraction. NaN, or a huge jump
/// from a faulty driver, gives no motion.
std::int64_t whole_steps(double amount, double& remainder) {
    constexpr double most = 1e9;
    if (!(std::abs(amount) <= most)) return 0;
    remainder += amount;
    const double whole = std::trunc(remainder);
    remainder -= whole;
    return static_cast<std::int64_t>(whole);
}

/// Returns the part of `total` that no earlier sample has taken, as far as a sample can hold it.
std::int32_t take_new(const std::atomic<std::int64_t>& total, std::int64_t& taken) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    const auto amount = std::clamp(total.load(std::memory_order_relaxed) - taken, -most, most);
    taken += amount;
    return static_cast<std::int32_t>(amount);
}

int level(double strength) { return static_cast<int>(std::lround(strength * 127)); }

std::uint64_t packed(int value, unsigned place) {
    return static_cast<std::uint64_t>(static_cast<std::uint8_t>(value)) << (8 * place);
}

std::int32_t signed_level(std::uint64_t levels, unsigned place) {
    return static_cast<std::int8_t>(static_cast<std::uint8_t>(levels >> (8 * place)));
}

bool is_button(Action action) { return static_cast<std::size_t>(action) < button_actions; }

std::uint32_t bit_of(Action action) { return 1U << static_cast<unsigned>(action); }

/// Bit of the action that selects a wand, 1 to max_wands.
std::uint32_t wand_bit(std::uint32_t wand) { return bit_of(wand_action(wand)); }

std::uint32_t all_wand_bits() {
    std::uint32_t bits = 0;
    for (std::uint32_t wand = 1; wand <= max_wands; ++wand) bits |= wand_bit(wand);
    return bits;
}

}  // namespace

HandsCollector::HandsCollector(Bindings bindings) { rebind(std::move(bindings)); }

// Functions of the main thread -----------------------------------------------------------------------

void HandsCollector::rebind(Bindings bindings) {
    bindings_ = std::move(bindings);
    bound_.clear();
    for (std::size_t action = 0; action < actions; ++action) {
        for (const auto& control : bindings_.controls[action]) {
            bound_.push_back({static_cast<Action>(action), control});
        }
    }
    controls_before_ = on_ = 0;
    publish();
}

void HandsCollector::set_look(double gain, bool inverted) {
    gain_ = gain;
    up_sign_ = inverted ? -1 : 1;
    publish();
}

void HandsCollector::set_turn_ramp(double seconds) {
    constexpr double most = 10;  // longest slow start (s), more than any useful one
    const double length = std::isfinite(seconds) ? std::clamp(seconds, 0.0, most) : 0;
    ramp_ticks_.store(static_cast<std::uint32_t>(thaum::ticks(length)), std::memory_order_relaxed);
}

void HandsCollector::set_sticks(const StickResponse& sticks) {
    sticks_ = sticks.checked();
    publish();
}

void HandsCollector::focus_lost() {
    for (auto& bound : bound_) update(bound, 0);
    controls_before_ = on_ = 0;
    publish();
}

void HandsCollector::key(int code, bool pressed) { press(Control::Source::key, code, pressed ? 1 : 0); }

void HandsCollector::mouse_button(int code, bool pressed) {
    press(Control::Source::mouse_button, code, pressed ? 1 : 0);
}

void HandsCollector::mouse_move(double right, double down) {
    if (!bindings_.mouse_look) return;
    right_.fetch_add(whole_steps(gain_ * right, right_rest_), std::memory_order_relaxed);
    up_.fetch_add(whole_steps(-up_sign_ * gain_ * down, up_rest_), std::memory_order_relaxed);
}

void HandsCollector::wheel(double steps) {
    if (!bindings_.mouse_look) return;
    const auto whole = whole_steps(steps, wheel_rest_);
    if (whole == 0) return;
    wheel_.fetch_add(whole, std::memory_order_relaxed);
    for (const auto& bound : bound_) {
        const bool turned =
            bound.control.source == Control::Source::wheel && (bound.control.direction > 0) == (whole > 0);
        if (!turned || !is_button(bound.action)) continue;
        if (toggles(bound.action))
            flip(bit_of(bound.action));
        else
            buttons_.fetch_or(std::uint64_t{bit_of(bound.action)} << latch_shift, std::memory_order_relaxed);
    }
    publish();
}

void HandsCollector::pad(const PadState& state) {
    const auto axis = [&](PadAxis a) { return state.axes[static_cast<std::size_t>(a)]; };
    const double dead = sticks_.dead_zone;
    const auto left = without_dead_zone({axis(PadAxis::left_x), axis(PadAxis::left_y)}, dead);
    const auto right = without_dead_zone({axis(PadAxis::right_x), axis(PadAxis::right_y)}, dead);
    set_axis(PadAxis::left_x, left.x);
    set_axis(PadAxis::left_y, left.y);
    set_axis(PadAxis::right_x, right.x);
    set_axis(PadAxis::right_y, right.y);
    set_axis(PadAxis::left_trigger, checked_push(axis(PadAxis::left_trigger)));
    set_axis(PadAxis::right_trigger, checked_push(axis(PadAxis::right_trigger)));
    for (auto& bound : bound_) {
        if (bound.control.source != Control::Source::pad_button) continue;
        update(bound, (state.buttons >> static_cast<unsigned>(bound.control.code) & 1U) != 0 ? 1 : 0);
    }
    publish();
}

void HandsCollector::press(Control::Source source, int code, double strength) {
    for (auto& bound : bound_) {
        if (bound.control.source == source && bound.control.code == code) update(bound, strength);
    }
    publish();
}

void HandsCollector::set_axis(PadAxis axis, double value) {
    for (auto& bound : bound_) {
        const auto& control = bound.control;
        if (control.source != Control::Source::pad_axis || control.code != static_cast<int>(axis)) continue;
        update(bound, std::max(value * control.direction, 0.0));
    }
}

void HandsCollector::update(Bound& bound, double strength) {
    const double threshold = bindings_.trigger_press - (bound.pressed ? release_below_press : 0);
    bound.strength = strength;
    bound.pressed = strength >= threshold;
}

/// Switches toggled actions, which stay on from one press to the next, on or off when they are pressed.
void HandsCollector::flip(std::uint32_t pressed) {
    for (const auto action : toggle_actions) {
        if (toggles(action)) on_ ^= pressed & bit_of(action);
    }
}

double HandsCollector::strength_of(Action action) const {
    if (toggles(action)) return (on_ & bit_of(action)) != 0 ? 1 : 0;
    double result = 0;
    for (const auto& bound : bound_) {
        if (bound.action == action) result = std::max(result, bound.strength);
    }
    return result;
}

void HandsCollector::publish() {
    std::uint32_t controls = 0;
    for (const auto& bound : bound_) {
        if (bound.pressed && is_button(bound.action)) controls |= bit_of(bound.action);
    }
    flip(controls & ~controls_before_);
    controls_before_ = controls;
    std::uint64_t held = on_;
    for (const auto& bound : bound_) {
        if (bound.pressed && is_button(bound.action) && !toggles(bound.action)) held |= bit_of(bound.action);
    }
    const auto pressed = held & ~std::uint64_t{held_before_};
    const auto released = std::uint64_t{held_before_} & ~held;
    held_before_ = static_cast<std::uint32_t>(held);
    // The bits for "held now" and "pressed since" change in one step, so that `take` cannot see a press twice
    // with a gap between.
    buttons_.fetch_or(pressed | pressed << latch_shift, std::memory_order_relaxed);
    buttons_.fetch_and(~released, std::memory_order_relaxed);

    const auto push = [&](Action plus, Action minus) { return strength_of(plus) - strength_of(minus); };
    const auto walk = [&](Action plus, Action minus) { return level(push(plus, minus)); };
    const auto turn = [&](Action plus, Action minus) {
        return level(deflection_for(push(plus, minus), sticks_.curve));
    };
    const int wheel_way = wheel_direction();
    if (wheel_way != 0 && wheel_way != wheel_way_before_)
        wheel_.fetch_add(wheel_way, std::memory_order_relaxed);
    wheel_way_before_ = wheel_way;
    const auto trigger = static_cast<int>(std::lround(strength_of(Action::fire) * 255));
    levels_.store(packed(walk(Action::move_right, Action::move_left), 0) |
                      packed(walk(Action::move_forward, Action::move_back), 1) |
                      packed(turn(Action::turn_right, Action::turn_left), 2) |
                      packed(static_cast<int>(up_sign_) * turn(Action::turn_up, Action::turn_down), 3) |
                      packed(trigger, 4) | packed(wheel_way, 5),
                  std::memory_order_relaxed);
}

/// Direction of the wheel from controls that are pressed: 1 away from the user, -1 towards the user, or 0.
int HandsCollector::wheel_direction() const {
    const auto pressed = [&](Action action) {
        return std::any_of(bound_.begin(), bound_.end(),
                           [&](const Bound& b) { return b.action == action && b.pressed; });
    };
    return (pressed(Action::farther) ? 1 : 0) - (pressed(Action::nearer) ? 1 : 0);
}

// Functions of the simulation thread -----------------------------------------------------------------

/// The wand whose key was pressed last. After its release, no other key that is still down takes over.
std::uint8_t HandsCollector::newest_wand(std::uint32_t down) {
    for (std::uint8_t wand = 1; wand <= max_wands; ++wand) {
        if ((down & ~wands_before_ & wand_bit(wand)) != 0) wand_ = wand;
    }
    if (wand_ != 0 && (down & wand_bit(wand_)) == 0) wand_ = 0;
    wands_before_ = down;
    return wand_;
}

/// Rate of a turn of the view (-127 to 127) during its slow start, from the rate that the control asks for. A
/// turn begins from rest or with a change of direction.
std::int32_t HandsCollector::ramped(std::int32_t level, Turn& turn) const {
    constexpr double least = 0.3;  // share of its full rate with which a turn begins
    if (level == 0) {
        turn.ticks = 0;
        return 0;
    }
    if (turn.positive != (level > 0)) turn = {.ticks = 0, .positive = level > 0};
    const auto length = ramp_ticks_.load(std::memory_order_relaxed);
    if (turn.ticks >= length) return level;
    const double share = least + (1 - least) * turn.ticks / length;
    ++turn.ticks;
    const auto grown = static_cast<std::int32_t>(std::lround(share * level));
    return grown != 0 ? grown : (level > 0 ? 1 : -1);
}

/// Whole wheel steps to add in this sample for a control that is held. Its first step was counted when it was
/// pressed.
std::int32_t HandsCollector::held_wheel(std::int32_t way) {
    if (way != wheel_way_taken_) wheel_held_ = 0;
    wheel_way_taken_ = way;
    return static_cast<std::int32_t>(whole_steps(way * wheel_steps_per_take, wheel_held_));
}

DeviceSample HandsCollector::take() {
    DeviceSample sample;
    sample.counts[hand::look_right] = take_new(right_, right_taken_);
    sample.counts[hand::look_up] = take_new(up_, up_taken_);
    sample.counts[hand::wheel] = take_new(wheel_, wheel_taken_);
    const auto levels = levels_.load(std::memory_order_relaxed);
    sample.counts[hand::wheel] += held_wheel(signed_level(levels, 5));
    sample.counts[hand::strafe] = signed_level(levels, 0);
    sample.counts[hand::forward] = signed_level(levels, 1);
    sample.counts[hand::turn_right] = ramped(signed_level(levels, 2), turn_right_);
    sample.counts[hand::turn_up] = ramped(signed_level(levels, 3), turn_up_);
    sample.counts[hand::trigger] = static_cast<std::int32_t>(levels >> 32U & 0xffU);
    const auto buttons = buttons_.fetch_and(0xffffffffU, std::memory_order_relaxed);
    const auto down = static_cast<std::uint32_t>(buttons | buttons >> latch_shift);
    sample.buttons = down & ~all_wand_bits();
    sample.wand = newest_wand(down & all_wand_bits());
    return sample;
}

}  // namespace thaum::input
