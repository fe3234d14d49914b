#include "input/collector.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

namespace thaum::input {
namespace {

std::optional<int> length_code_of(std::string_view name) {
    return name.size() == 1 ? std::optional<int>(name[0]) : static_cast<int>(name.size()) * 1000 + name[3];
}

HandsCollector mouse() {
    return HandsCollector(default_bindings(DeviceKind::keyboard_mouse, length_code_of));
}
HandsCollector pad() { return HandsCollector(default_bindings(DeviceKind::pad, length_code_of)); }

constexpr int left_button = 0;

PadState pad_with(PadAxis axis, double value) {
    PadState state;
    state.axes[static_cast<std::size_t>(axis)] = value;
    return state;
}

TEST(InputCollector, MotionIsTakenOnce) {
    auto hands = mouse();
    hands.mouse_move(3, -2);
    hands.mouse_move(4, -2);
    const auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::look_right], 7);
    EXPECT_EQ(sample.counts[hand::look_up], 4);
    EXPECT_EQ(hands.take(), DeviceSample{});
}

TEST(InputCollector, FractionsAndHugeMotionAreKept) {
    auto hands = mouse();
    std::int64_t sum = 0;
    for (int i = 0; i < 1000; ++i) {
        hands.mouse_move(0.25, 0);
        sum += hands.take().counts[hand::look_right];
    }
    EXPECT_EQ(sum, 250);
    for (int i = 0; i < 5; ++i) hands.mouse_move(1e9, 0);
    hands.mouse_move(NAN, INFINITY);
    sum = 0;
    for (int i = 0; i < 5; ++i) sum += hands.take().counts[hand::look_right];
    EXPECT_EQ(sum, 5000000000);
}

TEST(InputCollector, ShortPressShowsForOneTick) {
    auto hands = mouse();
    hands.mouse_button(left_button, true);
    hands.mouse_button(left_button, false);
    EXPECT_TRUE(hands.take().down(Button::fire));
    EXPECT_FALSE(hands.take().down(Button::fire));
    hands.mouse_button(left_button, true);
    EXPECT_TRUE(hands.take().down(Button::fire));
    EXPECT_TRUE(hands.take().down(Button::fire));
    EXPECT_EQ(hands.take().counts[hand::trigger], 255);
    hands.mouse_button(left_button, false);
    EXPECT_FALSE(hands.take().down(Button::fire));
}

TEST(InputCollector, TheWandIsTheKeyPressedLast) {
    auto hands = mouse();
    const auto wand = [&] {
        const auto sample = hands.take();
        EXPECT_EQ(sample.buttons, 0U) << "a wand's key is no button";
        return sample.wand;
    };
    EXPECT_EQ(wand(), 0U);
    hands.key('1', true);
    EXPECT_EQ(wand(), 1U);
    hands.key('9', true);
    EXPECT_EQ(wand(), 9U);
    EXPECT_EQ(wand(), 9U);
    hands.key('9', false);
    EXPECT_EQ(wand(), 0U) << "the key that was held before selects nothing again";
    hands.key('1', false);
    hands.key('6', true);
    hands.key('6', false);
    EXPECT_EQ(wand(), 6U) << "a short press shows for one tick";
    EXPECT_EQ(wand(), 0U);
}

TEST(InputCollector, TwoControlsOfOneAction) {
    auto bindings = default_bindings(DeviceKind::keyboard_mouse, length_code_of);
    bindings.controls[static_cast<std::size_t>(Action::fire)].push_back({Control::Source::key, 'x', 0});
    HandsCollector hands(bindings);
    hands.key('x', true);
    hands.mouse_button(left_button, true);
    hands.key('x', true);  // a repeated press of the same key changes nothing
    hands.key('x', false);
    EXPECT_TRUE(hands.take().down(Button::fire));
    EXPECT_TRUE(hands.take().down(Button::fire));
    hands.mouse_button(left_button, false);
    EXPECT_FALSE(hands.take().down(Button::fire));
}

TEST(InputCollector, KeysMove) {
    auto hands = mouse();
    hands.key('w', true);
    hands.key('a', true);
    hands.key('q', true);  // a key that is not bound has no effect
    auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::forward], 127);
    EXPECT_EQ(sample.counts[hand::strafe], -127);
    hands.key('d', true);
    EXPECT_EQ(hands.take().counts[hand::strafe], 0);
    hands.key('a', false);
    EXPECT_EQ(hands.take().counts[hand::strafe], 127);
}

TEST(InputCollector, WheelCountsAndPresses) {
    auto hands = mouse();
    hands.wheel(-0.5);
    EXPECT_EQ(hands.take(), DeviceSample{});
    hands.wheel(-0.5);
    auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::wheel], -1);
    EXPECT_TRUE(sample.down(Button::next_wand));
    EXPECT_FALSE(sample.down(Button::previous_wand));
    EXPECT_EQ(hands.take(), DeviceSample{});
    hands.wheel(3);
    sample = hands.take();
    EXPECT_EQ(sample.counts[hand::wheel], 3);
    EXPECT_TRUE(sample.down(Button::previous_wand));
}

TEST(InputCollector, SticksHaveARoundDeadZone) {
    auto hands = pad();
    hands.pad(pad_with(PadAxis::left_x, 0.14));
    EXPECT_EQ(hands.take().counts[hand::strafe], 0);
    hands.pad(pad_with(PadAxis::left_x, -1));
    EXPECT_EQ(hands.take().counts[hand::strafe], -127);
    hands.pad(pad_with(PadAxis::right_y, 0.578));  // halfway from the edge of the dead zone to the end
    EXPECT_EQ(hands.take().counts[hand::turn_up], 64);

    PadState corner;
    corner.axes = {1, 1, NAN, 5, 0, 0};
    hands.pad(corner);
    const auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::strafe], 90);
    EXPECT_EQ(sample.counts[hand::forward], 90);
    EXPECT_EQ(sample.counts[hand::turn_right], 0);
    EXPECT_EQ(sample.counts[hand::turn_up], 127);
}

TEST(InputCollector, TriggerIsAnalogueAndDoesNotChatter) {
    auto hands = pad();
    hands.pad(pad_with(PadAxis::right_trigger, 0.25));
    auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::trigger], 64);
    EXPECT_FALSE(sample.down(Button::fire));
    for (const double pull : {0.31, 0.29, 0.31, 0.25, 0.21}) {
        hands.pad(pad_with(PadAxis::right_trigger, pull));
        EXPECT_TRUE(hands.take().down(Button::fire)) << pull;
    }
    hands.pad(pad_with(PadAxis::right_trigger, 0.19));
    EXPECT_FALSE(hands.take().down(Button::fire));
    hands.pad(pad_with(PadAxis::right_trigger, 1));
    EXPECT_EQ(hands.take().counts[hand::trigger], 255);
}

TEST(InputCollector, PadButtonsAndUnplugging) {
    auto hands = pad();
    PadState state;
    state.buttons = 1U << static_cast<unsigned>(PadButton::a);
    state.axes[0] = 1;
    hands.pad(state);
    EXPECT_TRUE(hands.take().down(Button::jump));
    hands.pad({});
    EXPECT_EQ(hands.take(), DeviceSample{});
}

/// Each finger has only one thing to do: one thumb walks, the other moves the ladle, and the index fingers
/// hold and drop.
TEST(InputCollector, APadStirsAndDropsWithBothThumbsOnTheSticks) {
    auto hands = pad();
    PadState state;
    const auto push = [&](PadAxis axis, double way) { state.axes[static_cast<std::size_t>(axis)] = way; };
    push(PadAxis::left_trigger, 1);
    push(PadAxis::right_x, 1);
    push(PadAxis::left_y, 1);
    push(PadAxis::right_trigger, 1);
    hands.pad(state);
    const auto sample = hands.take();
    EXPECT_TRUE(sample.down(Button::stir) && sample.down(Button::fire));
    EXPECT_GT(sample.counts[hand::turn_right], 0);
    EXPECT_GT(sample.counts[hand::forward], 0);
    push(PadAxis::left_trigger, 0);
    hands.pad(state);
    EXPECT_FALSE(hands.take().down(Button::stir));
}

TEST(InputCollector, LosingFocusLetsGoOfEverything) {
    auto hands = mouse();
    hands.key('w', true);
    hands.mouse_button(left_button, true);
    hands.take();
    hands.focus_lost();
    EXPECT_EQ(hands.take(), DeviceSample{});
    hands.key('w', false);  // the system reports the release late, or never
    EXPECT_EQ(hands.take(), DeviceSample{});
    hands.key('w', true);
    EXPECT_EQ(hands.take().counts[hand::forward], 127);
    hands.rebind(default_bindings(DeviceKind::keyboard_mouse, length_code_of));
    EXPECT_EQ(hands.take(), DeviceSample{});
}

/// Sums of motion and of wheel steps over many events or samples (counts).
struct Counts {
    std::int64_t right = 0, up = 0, wheel = 0;
    bool operator==(const Counts&) const = default;
};

/// Takes samples, and sums their counts and presses.
struct SampleReader {
    HandsCollector& hands;
    Counts counts{};
    bool was_down = false;
    std::atomic<int> presses{0};  ///< number of presses that have ended

    void take() {
        const auto sample = hands.take();
        counts.right += sample.counts[hand::look_right];
        counts.up += sample.counts[hand::look_up];
        counts.wheel += sample.counts[hand::wheel];
        const bool down = sample.down(Button::fire);
        // A press is counted only after the release, so that the next press is seen as a new one.
        if (was_down && !down) presses.fetch_add(1);
        was_down = down;
    }
};

/// Moves the mouse, turns the wheel and presses a button. Each press is shorter than a tick, and the sender
/// waits until the reader has counted it.
struct EventSender {
    HandsCollector& hands;
    const SampleReader& reader;
    Counts counts{};
    int presses = 0;

    void send(int events) {
        for (int i = 0; i < events; ++i) {
            const int wheel = i % 5 == 0 ? 1 : 0;
            hands.mouse_move(i % 7, -(i % 3));
            hands.wheel(wheel);
            counts.right += i % 7;
            counts.up += i % 3;
            counts.wheel += wheel;
            if (i % 64 != 0 || reader.presses.load() < presses) continue;
            ++presses;
            hands.mouse_button(left_button, true);
            hands.mouse_button(left_button, false);
        }
    }
};

// One thread sends events. The other takes samples as fast as it can.
TEST(InputCollector, TwoThreadsLoseNothingAndCountNothingTwice) {
    auto hands = mouse();
    SampleReader reader{hands};
    EventSender sender{hands, reader};
    std::atomic<bool> done{false};
    std::jthread events_thread([&] {
        sender.send(200'000);
        done = true;
    });
    while (!done) reader.take();
    events_thread.join();
    reader.take();
    reader.take();
    EXPECT_EQ(reader.counts, sender.counts);
    EXPECT_GT(sender.presses, 0);
    EXPECT_EQ(reader.presses.load(), sender.presses);
}

Bindings toggling(DeviceKind kind, Action action) {
    auto b = default_bindings(kind, length_code_of);
    b.toggled[static_cast<std::size_t>(action)] = true;
    return b;
}

TEST(InputCollector, AToggleStaysOnFromOnePressToTheNext) {
    HandsCollector hands(toggling(DeviceKind::keyboard_mouse, Action::fire));
    for (const bool on : {true, false, true}) {
        hands.mouse_button(left_button, true);
        auto sample = hands.take();
        EXPECT_EQ(sample.down(Button::fire), on);
        hands.mouse_button(left_button, false);
        hands.key(*length_code_of("a"), true);  // a toggle does not affect other actions
        sample = hands.take();
        EXPECT_EQ(sample.down(Button::fire), on);
        EXPECT_EQ(sample.counts[hand::trigger], on ? 255 : 0);
        EXPECT_EQ(sample.counts[hand::strafe], -127);
        hands.key(*length_code_of("a"), false);
    }
    hands.focus_lost();
    EXPECT_FALSE(hands.take().down(Button::fire));
    // After the focus was lost, the first press turns the toggled action on again.
    hands.mouse_button(left_button, true);
    EXPECT_TRUE(hands.take().down(Button::fire));
}

TEST(InputCollector, ATriggerTogglesOncePerPull) {
    HandsCollector hands(toggling(DeviceKind::pad, Action::fire));
    for (const double pull : {0.1, 0.5, 0.9, 0.25, 0.6}) hands.pad(pad_with(PadAxis::right_trigger, pull));
    hands.take();
    EXPECT_EQ(hands.take().counts[hand::trigger], 255);
    hands.pad(pad_with(PadAxis::right_trigger, 0));
    hands.pad(pad_with(PadAxis::right_trigger, 1));
    hands.take();
    EXPECT_FALSE(hands.take().down(Button::fire));
}

TEST(InputCollector, AWheelStepTogglesToo) {
    auto b = toggling(DeviceKind::keyboard_mouse, Action::trace);
    b.of(Action::trace) = {{Control::Source::wheel, 0, 1}};
    HandsCollector hands(b);
    hands.wheel(1);
    EXPECT_TRUE(hands.take().down(Button::trace));
    EXPECT_TRUE(hands.take().down(Button::trace));
    hands.wheel(-1);
    EXPECT_TRUE(hands.take().down(Button::trace));
    hands.wheel(1);
    hands.take();
    EXPECT_FALSE(hands.take().down(Button::trace));
}

TEST(InputCollector, AHeldButtonTurnsTheWheelAtOnceAndThenTwelveTimesASecond) {
    HandsCollector hands(default_bindings(DeviceKind::pad, length_code_of));
    PadState up, down;
    up.buttons = 1U << static_cast<unsigned>(PadButton::up);
    down.buttons = 1U << static_cast<unsigned>(PadButton::down);
    const auto steps_of = [&](int takes) {
        std::int32_t steps = 0;
        for (int i = 0; i < takes; ++i) steps += hands.take().counts[hand::wheel];
        return steps;
    };
    EXPECT_EQ(steps_of(1000), 0);
    hands.pad(up);
    EXPECT_EQ(steps_of(1), 1);
    hands.pad(up);
    EXPECT_EQ(steps_of(1000), 12);
    hands.pad(down);
    EXPECT_EQ(steps_of(1001), -13);
    hands.pad({});
    EXPECT_EQ(steps_of(1000), 0);
    hands.pad(up);
    hands.pad({});
    EXPECT_EQ(steps_of(10), 1) << "a press between two samples is not lost";
    hands.pad(down);
    hands.focus_lost();
    EXPECT_EQ(steps_of(1000), -1) << "the press, but nothing after the focus was lost";
}

TEST(InputCollector, LookCanBeScaledAndTurnedAround) {
    auto hands = mouse();
    hands.set_look(0.25, true);
    for (int i = 0; i < 10; ++i) hands.mouse_move(2, -2);
    auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::look_right], 5);
    EXPECT_EQ(sample.counts[hand::look_up], -5);
    auto stick = pad();
    stick.set_look(1, true);
    stick.pad(pad_with(PadAxis::right_y, 1));
    EXPECT_EQ(stick.take().counts[hand::turn_up], -127);
    stick.set_look(1, false);
    EXPECT_EQ(stick.take().counts[hand::turn_up], 127);
}

// ---- slow start of turns ----------------------------------------------------------------------------------

TEST(InputCollector, ATurnGrowsToItsLevelOverTheRamp) {
    auto hands = pad();
    hands.set_turn_ramp(0.1);
    hands.pad(pad_with(PadAxis::right_x, 1));
    const int first = hands.take().counts[hand::turn_right];
    EXPECT_NEAR(first, 0.3 * 127, 1);
    int before = first;
    for (int tick = 1; tick < 100; ++tick) {
        const int current = hands.take().counts[hand::turn_right];
        EXPECT_GE(current, before) << tick;
        before = current;
    }
    EXPECT_EQ(hands.take().counts[hand::turn_right], 127);
    EXPECT_EQ(hands.take().counts[hand::turn_right], 127);
}

TEST(InputCollector, ATurnBeginsAnewAtRestAndByAnotherDirection) {
    auto hands = pad();
    hands.set_turn_ramp(0.05);
    const auto held_for = [&](double value, int ticks) {
        hands.pad(pad_with(PadAxis::right_x, value));
        int last = 0;
        for (int i = 0; i < ticks; ++i) last = hands.take().counts[hand::turn_right];
        return last;
    };
    EXPECT_EQ(held_for(1, 60), 127);
    EXPECT_NEAR(held_for(-1, 1), -0.3 * 127, 1);
    EXPECT_EQ(held_for(-1, 60), -127);
    EXPECT_EQ(held_for(0, 1), 0);
    EXPECT_NEAR(held_for(-1, 1), -0.3 * 127, 1);
}

TEST(InputCollector, ASlowStartNeverStopsAFineTurnAndLeavesTheRestAlone) {
    auto hands = pad();
    hands.set_turn_ramp(0.2);
    auto state = pad_with(PadAxis::right_y, 0.16);  // a position just outside the dead zone
    state.axes[static_cast<std::size_t>(PadAxis::left_x)] = 1;
    hands.pad(state);
    const auto sample = hands.take();
    EXPECT_EQ(sample.counts[hand::turn_up], 1);
    EXPECT_EQ(sample.counts[hand::strafe], 127);
    for (const double broken : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
        hands.set_turn_ramp(broken);
        hands.pad(pad_with(PadAxis::right_x, 1));
        EXPECT_EQ(hands.take().counts[hand::turn_right], 127) << broken;
        hands.pad({});
        hands.take();
    }
}

}  // namespace
}  // namespace thaum::input
