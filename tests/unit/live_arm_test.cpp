// Tests of the option --hands, of the real arms (haptic devices) that a live session opens for it, of the
// arms' players, and of the notices about arms that are lost.
#include "game/live/arm.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "unit/live_rig.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

void plug_in_arms(const char* scripts) { ::setenv("FAKE_ARMS", scripts, 1); }

std::vector<live::Seat> hands(std::string_view words) { return hands_named(words).value(); }

std::vector<SeatKind> kinds_of(std::string_view words) {
    std::vector<SeatKind> kinds;
    for (const auto& seat : hands(words)) kinds.push_back(seat.kind);
    return kinds;
}

using Kinds = std::vector<SeatKind>;
constexpr auto mouse = SeatKind::keyboard_mouse, numpad = SeatKind::keyboard_half, pad = SeatKind::pad,
               pad_or_numpad = SeatKind::pad_or_half;

TEST(Hands, OnePlayerHasTheMouse) {
    EXPECT_EQ(kinds_of("mouse,pad"), (Kinds{mouse, pad}));
    EXPECT_EQ(kinds_of("pad,pad"), (Kinds{pad, pad}));
    EXPECT_EQ(kinds_of("arm"), (Kinds{mouse}));
    EXPECT_EQ(kinds_of("pad,arm"), (Kinds{pad, mouse}));
    EXPECT_EQ(kinds_of("half,arm"), (Kinds{numpad, mouse}));
    EXPECT_EQ(kinds_of("arm,arm"), (Kinds{mouse, pad_or_numpad}));
    EXPECT_EQ(kinds_of("arm:0,arm:1"), (Kinds{mouse, pad_or_numpad}));
    EXPECT_EQ(kinds_of("mouse,arm"), (Kinds{mouse, pad_or_numpad}));
    EXPECT_EQ(kinds_of("arm,mouse"), (Kinds{pad_or_numpad, mouse}));
}

TEST(Hands, AnArmMayHaveANumber) {
    const auto seats = hands("arm:12,arm");
    ASSERT_EQ(seats.size(), 2U);
    EXPECT_EQ(seats[0].arm->number, 12U);
    ASSERT_TRUE(seats[1].arm);
    EXPECT_FALSE(seats[1].arm->number);
    EXPECT_FALSE(hands("mouse,pad")[0].arm);
}

TEST(Hands, WordsThatAreWrongAreRefused) {
    for (const char* words :
         {"", "foot", "mouse,", ",mouse", "mouse,mouse", "half,half", "arm:0,arm:0", "arm:", "arm:-1",
          "arm:1x", "arm:99999999999999999999", "Arm", "mouse,pad,pad", "arm,arm,arm"})
        EXPECT_FALSE(hands_named(words)) << words;
}

// ---- opening arms -----------------------------------------------------------------------------------------

const haptics::DeviceSpec wanted{.name = "Touch", .peak_force = 3.3};

Expected<std::vector<std::string>> opened(std::string_view words) {
    const auto seats = hands(words);
    const auto arms = open_arms(seats, wanted);
    if (!arms) return arms.error();
    std::vector<std::string> names;
    for (const auto& arm : *arms)
        names.push_back(input::name_of(arm->keeper->facts()) + " for " + std::to_string(arm->seat + 1));
    return names;
}

std::string refusal_of_hands(std::string_view words) { return message_of(opened(words), "opened"); }

using Names = std::vector<std::string>;

TEST(LiveArms, EachSeatGetsItsArm) {
    plug_in_arms("name=Left;name=Right");
    EXPECT_EQ(*opened("arm"), (Names{"Left A0 for 1"}));
    EXPECT_EQ(*opened("arm:1"), (Names{"Right A1 for 1"}));
    EXPECT_EQ(*opened("pad,arm:1"), (Names{"Right A1 for 2"}));
    EXPECT_EQ(*opened("arm,arm"), (Names{"Left A0 for 1", "Right A1 for 2"}));
    EXPECT_EQ(*opened("arm:1,arm:0"), (Names{"Right A1 for 1", "Left A0 for 2"}));
    EXPECT_EQ(*opened("mouse,pad"), Names{});
}

/// An arm that --hands names by its number (arm:0) is reserved for that player. The word `arm` alone takes a
/// free one, even if it comes first.
TEST(LiveArms, TheWordWithoutANumberTakesAFreeArm) {
    plug_in_arms("name=Left;name=Right");
    EXPECT_EQ(*opened("arm,arm:0"), (Names{"Right A1 for 1", "Left A0 for 2"}));
    EXPECT_EQ(*opened("arm:0,arm"), (Names{"Left A0 for 1", "Right A1 for 2"}));
}

TEST(LiveArms, ArmsThatCannotPlayArePassedOver) {
    plug_in_arms("absent;peak=1,name=Weak;name=Strong");
    EXPECT_EQ(*opened("arm"), (Names{"Strong A2 for 1"}));
    EXPECT_NE(refusal_of_hands("arm:0").find("plug it in"), std::string::npos);
    EXPECT_NE(refusal_of_hands("arm:1").find("1.0 N"), std::string::npos) << refusal_of_hands("arm:1");
}

TEST(LiveArms, AnArmThatIsNotThereIsRefused) {
    plug_in_arms("name=Left");
    ::setenv("THAUM_LIBHD", "/nowhere/libHD.so", 1);
    EXPECT_NE(refusal_of_hands("arm,arm").find("/nowhere/libHD.so"), std::string::npos)
        << refusal_of_hands("arm,arm");
    EXPECT_NE(refusal_of_hands("arm:9").find("numbered from 0"), std::string::npos);
    EXPECT_EQ(*opened("arm"), (Names{"Left A0 for 1"})) << "a refusal leaves the arms free";
}

/// Both arms run independently until the session ends, and an arm that vanishes is opened again.
TEST(LiveArms, AreWatchedEachForItself) {
    plug_in_arms("vanish=100,back=1;name=Right");
    const auto seats = hands("arm,arm");
    const auto arms = open_arms(seats, wanted).value();
    const auto& left = *arms.at(0)->keeper;
    const auto& right = *arms.at(1)->keeper;
    const auto eventually = [](auto holds) {
        for (int i = 0; i < 20'000 && !holds(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return holds();
    };
    EXPECT_FALSE(left.is_lost());
    EXPECT_TRUE(eventually([&] { return left.status().state == input::ArmPresence::lost; }));
    EXPECT_TRUE(eventually([&] { return left.is_lost(); }));
    EXPECT_TRUE(eventually([&] { return left.status().state == input::ArmPresence::present; }));
    EXPECT_TRUE(eventually([&] { return !left.is_lost(); }));
    EXPECT_FALSE(right.is_lost());
    EXPECT_EQ(left.losses(), 1);
    EXPECT_EQ(right.losses(), 0);
    EXPECT_EQ(right.status().state, input::ArmPresence::present);
}

// ---- which player gets which arm --------------------------------------------------------------------------

/// Returns to which player each of `count` arms goes. With `start_screen`, that screen gives out all devices.
/// Otherwise the command line has given arm i to player i.
std::vector<std::uint32_t> players_of(const TakenSeats& seats, std::uint32_t count, bool start_screen) {
    LiveArms arms;
    for (std::uint32_t i = 0; i < count; ++i) {
        arms.push_back(std::make_unique<LiveArm>());
        arms.back()->seat = i;
    }
    bind_arms(arms, seats, start_screen);
    std::vector<std::uint32_t> players;
    for (const auto& arm : arms) players.push_back(arm->player);
    return players;
}

TEST(LiveArms, GoToTheirSeatsOrToThePlayerWithTheMouse) {
    using Players = std::vector<std::uint32_t>;
    const auto mouse_second = rig::seats_for(rig::first_pad_seat, rig::mouse_seat);
    EXPECT_EQ(players_of(mouse_second, 2, false), (Players{0, 1}));
    EXPECT_EQ(players_of(mouse_second, 2, true), (Players{1, 0}));
    const auto no_mouse = rig::seats_for(rig::first_pad_seat, rig::second_pad_seat);
    EXPECT_EQ(players_of(no_mouse, 2, true), (Players{game::no_player, game::no_player}));
    const auto alone = rig::seats_for(rig::mouse_seat, rig::bot_seat);
    EXPECT_EQ(players_of(alone, 2, true), (Players{0, game::no_player}));
}

TEST(LiveArms, StandAfterTheHandsOfBothPlayersInTheMatch) {
    plug_in_arms("name=Left;name=Right");
    auto arms = open_arms(hands("arm,arm"), wanted).value();
    const auto seats = rig::seats_for(rig::bot_seat, rig::mouse_seat);
    bind_arms(arms, seats, true);
    const auto devices = devices_of(seats, arms);
    ASSERT_EQ(devices.size(), 3U) << "nobody holds the second arm";
    EXPECT_EQ(devices[0].kind, input::DeviceKind::bot);
    EXPECT_EQ(devices[1].kind, input::DeviceKind::keyboard_mouse);
    EXPECT_EQ(devices[2].kind, input::DeviceKind::arm);
    EXPECT_EQ(devices[2].player, 1U);
    EXPECT_EQ(devices[2].name, "Left A0");
}

// ---- notices about lost arms ------------------------------------------------------------------------------

TEST(ArmNotices, ALossAndAReturnAreSaidOnce) {
    ArmNotice notice;
    const input::ArmStatus present{},
        lost{.state = input::ArmPresence::lost, .text = "It is gone. Plug it in."};
    EXPECT_FALSE(update(notice, "Touch", present)) << "an arm that is there from the start";
    EXPECT_EQ(notice.label, "Touch");
    EXPECT_EQ(notice.fault, "");
    EXPECT_EQ(update(notice, "Touch", lost), "It is gone. Plug it in.");
    EXPECT_EQ(notice.label, "Touch (gone)");
    EXPECT_EQ(notice.fault, input::caption_of(lost));
    EXPECT_NE(notice.fault, "");
    EXPECT_FALSE(update(notice, "Touch", lost));
    EXPECT_EQ(update(notice, "Touch", present), "the arm is back");
    EXPECT_EQ(notice.label, "Touch");
    EXPECT_EQ(notice.fault, "");
    EXPECT_FALSE(update(notice, "Touch", present));
}

TEST(ArmNotices, AnArmThatIsLostFromTheStartIsSaid) {
    ArmNotice notice;
    const input::ArmStatus lost{.state = input::ArmPresence::fault, .text = "The arm is too warm"};
    EXPECT_EQ(update(notice, "Touch", lost), "The arm is too warm");
}

/// The description of the fault may change while the arm is away.
TEST(ArmNotices, ShowTheNewestFault) {
    ArmNotice notice;
    input::ArmStatus lost{.state = input::ArmPresence::lost, .text = "It is gone"};
    update(notice, "Touch", lost);
    lost.text = "It cannot be opened";
    EXPECT_FALSE(update(notice, "Touch", lost));
    EXPECT_EQ(notice.fault, input::caption_of(lost));
}

}  // namespace
}  // namespace thaum::game
