// Tests of seats (each player's input devices): which devices players get from the command line or the start
// screen, and which are in use.
#include "game/live/seats.h"

#include <gtest/gtest.h>

#include "game/range/range.h"
#include "unit/live_rig.h"

namespace thaum::game {
namespace {

using input::DeviceKind;

TEST(PlannedSeats, EachPadGoesToTheFirstSeatThatWantsOne) {
    const auto seats =
        planned_seats({live::Seat{.kind = SeatKind::pad, .pad = 3}, live::Seat{.kind = SeatKind::pad}}, {});
    EXPECT_EQ(seats[0].pad, 0);
    EXPECT_EQ(seats[1].pad, 1);
    const auto one = planned_seats({rig::mouse_seat, live::Seat{.kind = SeatKind::pad, .pad = 3}}, {});
    EXPECT_EQ(one[0].kind, SeatKind::keyboard_mouse);
    EXPECT_EQ(one[1].pad, 0);
}

TEST(PlannedSeats, HalfOfTheKeyboardStandsInForAMissingPad) {
    const Seats wish{rig::mouse_seat, live::Seat{.kind = SeatKind::pad_or_half}};
    EXPECT_EQ(planned_seats(wish, {})[1].kind, SeatKind::keyboard_half);
    EXPECT_EQ(planned_seats(wish, {rig::pad_with()})[1].kind, SeatKind::pad);
    const Seats both{live::Seat{.kind = SeatKind::pad}, live::Seat{.kind = SeatKind::pad_or_half}};
    EXPECT_EQ(planned_seats(both, {rig::pad_with()})[1].kind, SeatKind::keyboard_half) << "one pad for two";
    EXPECT_EQ(planned_seats(both, {rig::pad_with(), rig::pad_with()})[1].kind, SeatKind::pad);
}

TEST(JoinedSeats, ABotTakesAnEmptySeatAndADummyTheSecondOneOfPractice) {
    const MenuContext context{.bots = {{"level_1", "Beginner"}, {"level_2", "Adept"}}};
    MenuState menu;
    menu.seats[1] = Device{DeviceKind::pad, 2};
    menu.bot = 1;
    auto seats = joined_seats(menu, context, false);
    EXPECT_EQ(seats[0].kind, SeatKind::bot);
    EXPECT_EQ(seats[0].bot, "level_2");
    EXPECT_EQ(seats[1].kind, SeatKind::pad);
    EXPECT_EQ(seats[1].pad, 2);
    menu.seats[0] = Device{DeviceKind::keyboard_half, 0};
    seats = joined_seats(menu, context, true);
    EXPECT_EQ(seats[0].kind, SeatKind::keyboard_half);
    EXPECT_EQ(seats[game::dummys].kind, SeatKind::dummy);
}

/// Takes from `faders` all changes that a match must still get. Returns `values` with these changes, and the
/// number of changes.
std::pair<FaderInput::Values, int> moved(FaderInput& faders, FaderInput::Values values) {
    int moves = 0;
    for (auto change = faders.take(); change.fader != 0; change = faders.take(), ++moves) {
        EXPECT_TRUE(is_valid(change));
        values.at(change.fader - 1U) = change.percent;
    }
    return {values, moves};
}

TEST(TakenSeats, ChangedFadersBecomeMovesOfTheirPlayer) {
    Settings settings;
    const auto seats = rig::seats_for(rig::bot_seat, rig::mouse_seat, settings);
    EXPECT_FALSE(seats[0].faders) << "a bot moves none";
    ASSERT_TRUE(seats[1].faders);
    EXPECT_TRUE(seats[1].spec.moves_faders);
    auto& faders = *seats[1].faders;
    const auto at_start = seats[1].spec.faders();
    faders.begin_match(at_start);
    want_faders(settings, seats);
    EXPECT_EQ(moved(faders, at_start).second, 0) << "nothing was changed";

    settings.players[0].recoil = 0;  // the other player's, which must not matter
    settings.players[1].recoil = 0.25;
    settings.players[1].force = own_force;
    settings.players[1].own_force_percent = 60;
    settings.cauldron[1][2].on = false;
    want_faders(settings, seats);
    const auto [values, moves] = moved(faders, at_start);
    EXPECT_EQ(moves, 3);
    EXPECT_EQ(values, rig::seats_for(rig::bot_seat, rig::mouse_seat, settings)[1].spec.faders());
    EXPECT_EQ(values[0], 60);
    EXPECT_EQ(values[3], 25);
    EXPECT_EQ(values[7], 0);

    settings.players[1].force = gentle_force;
    want_faders(settings, seats);
    EXPECT_EQ(faders.take(), (input::FaderChange{1, input::force_as_rules}));
    faders.begin_match(at_start);
    EXPECT_EQ(moved(faders, at_start).second, 2) << "a new match has the values of its own header";
}

TEST(TakenSeats, HaveTheirPlayersSettings) {
    Settings settings;
    settings.players[1] = {.sensitivity = 3, .turn_deg_per_s = 90, .invert_y = true, .force = 4};
    const auto seats = rig::seats_for(rig::bot_seat, rig::mouse_seat, settings);
    EXPECT_FALSE(seats[0].hands) << "a bot has no hands";
    EXPECT_EQ(seats[0].spec.kind, DeviceKind::bot);
    ASSERT_TRUE(seats[1].hands);
    EXPECT_EQ(seats[1].spec.player, 1U);
    EXPECT_EQ(seats[1].spec.kind, DeviceKind::keyboard_mouse);
    EXPECT_EQ(seats[1].spec.name, "mouse and keyboard");
    EXPECT_DOUBLE_EQ(seats[1].spec.look_rad_per_count, 3 * input::DeviceSpec{}.look_rad_per_count);
    EXPECT_DOUBLE_EQ(seats[1].spec.turn_rad_per_s, pi / 2);
    EXPECT_TRUE(seats[1].spec.invert_y);
    EXPECT_EQ(seats[1].spec.force_percent, 100);
    const auto first = rig::seats_for(rig::mouse_seat, rig::bot_seat, settings);
    EXPECT_DOUBLE_EQ(first[0].spec.look_rad_per_count, input::DeviceSpec{}.look_rad_per_count)
        << "the other player's settings do not count";
    EXPECT_FALSE(first[0].spec.invert_y);
    EXPECT_EQ(first_person(seats), 1U);
    EXPECT_FALSE(has_pad(seats[0]) || has_pad(seats[1]));
    const auto pads = rig::seats_for(rig::second_pad_seat, rig::bot_seat);
    EXPECT_EQ(pads[0].spec.name, "pad 2");
    EXPECT_TRUE(has_pad(pads[0]));
    EXPECT_FALSE(first_person(rig::seats_for(rig::bot_seat, rig::bot_seat)));
}

}  // namespace
}  // namespace thaum::game
