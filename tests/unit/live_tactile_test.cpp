// Tests of the motors of the players' pads: which player has which motors, how strong they are, and that they
// follow when players get other devices. The motors are fakes. Tests wait for the threads' actions, not for a
// fixed time.
#include "game/live/tactile.h"

#include <gtest/gtest.h>

#include <map>
#include <thread>

#include "unit/felt_output_rig.h"
#include "unit/live_session_rig.h"

namespace thaum::game {
namespace {

using input::rig::FakeOutput;
using input::rig::Felt;
using input::rig::frame_of;

constexpr Tick long_life = 500;

input::PadState pad_of(std::string path) {
    auto pad = rig::pad_with();
    pad.path = std::move(path);
    return pad;
}

/// Fake motors of all pads, by the pad's device file.
class Motors {
public:
    std::unique_ptr<input::TactileOutput> make(const input::PadState& pad) {
        EXPECT_EQ(pad.name, "Make-believe pad");
        ++made;
        return std::make_unique<FakeOutput>(of(pad.path));
    }
    LiveTactile::MakeOutput maker() {
        return [this](const input::PadState& pad) { return make(pad); };
    }
    const std::shared_ptr<Felt>& of(const std::string& path) {
        auto& felt = felt_[path];
        if (felt == nullptr) felt = std::make_shared<Felt>();
        return felt;
    }
    int made = 0;

private:
    std::map<std::string, std::shared_ptr<Felt>> felt_;
};

/// Passes frames until the motors play one, and returns its amplitudes.
std::pair<float, float> played(LiveTactile& tactile, std::uint32_t player, Felt& felt,
                               const tactile::TactileFrame& frame) {
    const auto before = felt.with([&] { return felt.frames.size(); });
    while (felt.with([&] { return felt.frames.size(); }) == before) {
        tactile.feel(player, frame);
        std::this_thread::yield();
    }
    return felt.with([&] {
        return std::pair{felt.frames.back().amplitude[0], felt.frames.back().amplitude[1]};
    });
}

TEST(LiveTactile, WithoutPadsNothingRuns) {
    Motors motors;
    LiveTactile tactile(motors.maker());
    tactile.feel(0, frame_of(1, 1));
    tactile.use_pad(0, nullptr);
    const input::PadState unplugged{.present = false, .path = "/dev/input/event1"};
    tactile.use_pad(0, &unplugged);
    const auto nameless = rig::pad_with();
    tactile.use_pad(0, &nameless);
    tactile.feel(0, frame_of(1, 1));
    tactile.tell_status();
    EXPECT_FALSE(tactile.feels(0));
    EXPECT_EQ(motors.made, 0);
    EXPECT_EQ(tactile.report(0).frames_lost, 0) << "no thread was started";
}

TEST(LiveTactileThreads, EachPlayerFeelsWithTheirOwnPadAndStrength) {
    Motors motors;
    const auto first = motors.of("/dev/input/event1"), second = motors.of("/dev/input/event2");
    LiveTactile tactile(motors.maker());
    Settings settings;
    settings.players[0].rumble = 0.5;
    settings.players[1].rumble = 1;
    tactile.apply(settings);
    const auto pad_1 = pad_of("/dev/input/event1"), pad_2 = pad_of("/dev/input/event2");
    for (int i = 0; i < 5; ++i) {
        tactile.use_pad(0, &pad_1);
        tactile.use_pad(1, &pad_2);
    }
    EXPECT_EQ(motors.made, 2) << "nothing new is no change";
    EXPECT_EQ(played(tactile, 0, *first, frame_of(1, 0.5F, long_life)), std::pair(0.5F, 0.25F));
    EXPECT_EQ(played(tactile, 1, *second, frame_of(0.5F, 1, long_life)), std::pair(0.5F, 1.0F));
    EXPECT_TRUE(tactile.feels(0));
    EXPECT_EQ(first->with([&] { return first->frames.back().amplitude[1]; }), 0.25F)
        << "the other player's frames";
    // A changed setting takes effect at once, and 0 % switches the motors off.
    settings.players[0].rumble = 0.25;
    tactile.apply(settings);
    while (played(tactile, 0, *first, frame_of(1, 1, long_life)) != std::pair(0.25F, 0.25F)) {}
    settings.players[0].rumble = 0;
    tactile.apply(settings);
    while (first->with([&] { return first->on; })) tactile.feel(0, frame_of(1, 1, long_life));
}

TEST(LiveTactileThreads, APadThatIsPulledOutLeavesItsPlayerWithoutMotorsUntilItIsBack) {
    Motors motors;
    const auto felt = motors.of("/dev/input/event1"), other = motors.of("/dev/input/event2");
    LiveTactile tactile(motors.maker());
    auto pad = pad_of("/dev/input/event1");
    tactile.use_pad(0, &pad);
    played(tactile, 0, *felt, frame_of(1, 0, long_life));
    pad.present = false;
    tactile.use_pad(0, &pad);
    EXPECT_FALSE(tactile.feels(0));
    felt->wait([&] { return felt->closed == 1; });
    EXPECT_FALSE(felt->with([&] { return felt->on; }));
    pad.present = true;
    tactile.use_pad(0, &pad);
    played(tactile, 0, *felt, frame_of(1, 0, long_life));
    // The player continues with another pad.
    const auto free_pad = pad_of("/dev/input/event2");
    tactile.use_pad(0, &free_pad);
    played(tactile, 0, *other, frame_of(1, 0, long_life));
    EXPECT_EQ(felt->with([&] { return felt->closed; }), 2);
    EXPECT_FALSE(felt->with([&] { return felt->on; }));
}

TEST(LiveTactileThreads, APadWithoutMotorsCostsOneLineAndNoFrames) {
    Motors motors;
    const auto felt = motors.of("/dev/input/event1");
    felt->present = false;
    LiveTactile tactile(motors.maker());
    const auto pad = pad_of("/dev/input/event1");
    tactile.use_pad(1, &pad);
    felt->wait([&] { return felt->opened == 1; });
    testing::internal::CaptureStderr();
    std::string said;
    while (said.empty()) {
        tactile.tell_status();
        said = testing::internal::GetCapturedStderr();
        testing::internal::CaptureStderr();
    }
    tactile.tell_status();
    EXPECT_EQ(said, "player 2: fake: it is not there\n");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_FALSE(tactile.feels(1));
}

// Motors of pads in a session -------------------------------------------------------------------------------

using LiveTactileSession = LiveSessionTest;

TEST_F(LiveTactileSession, MotorsFollowThePadsOfTheSeats) {
    Motors motors;
    make_motors_ = motors.maker();
    const auto felt = motors.of("/dev/input/event1"), other = motors.of("/dev/input/event2");
    auto& tactile = shared_.tactile;
    begin({pad_of("/dev/input/event1"), pad_of("/dev/input/event2")});
    felt->wait([&] { return felt->opened == 1; });
    EXPECT_EQ(motors.made, 1) << "player 1 has the mouse, and the second pad is nobody's";
    played(tactile, 1, *felt, frame_of(1, 0, long_life));
    // The pad is unplugged, and half of the keyboard takes its place.
    pads_[0].present = false;
    step();
    felt->wait([&] { return felt->closed == 1; });
    press("kp_0");
    pads_[0] = pad_of("/dev/input/event1");
    step();
    EXPECT_EQ(motors.made, 1) << "the player has half of the keyboard now";
    // A press of a button gives the pad back to the player.
    pads_[0].buttons = 1;
    step();
    EXPECT_EQ(motors.made, 2);
    played(tactile, 1, *felt, frame_of(1, 0, long_life));
    // The pad is unplugged again, so the player continues with the free pad.
    pads_[0] = {};
    step();
    pads_[1].buttons = 1;
    step();
    played(tactile, 1, *other, frame_of(1, 0, long_life));
    // The start screen releases all pads.
    session_->open_start_screen(now_);
    session_->step_start_screen(pads_, now_);
    other->wait([&] { return other->closed == 1; });
}

TEST_F(LiveTactileSession, TheRumbleSettingActsInTheMatch) {
    Motors motors;
    make_motors_ = motors.maker();
    plan_.settings.players[1].rumble = 0.5;
    begin({pad_of("/dev/input/event1")});
    const auto& felt = motors.of("/dev/input/event1");
    EXPECT_EQ(played(shared_.tactile, 1, *felt, frame_of(1, 0, long_life)).first, 0.5F);
    pause(1);
    enter("Settings");
    enter("Forces and body");
    choose("Who feels it");
    press("right");
    choose("Rumble");
    press("right");
    step();
    while (played(shared_.tactile, 1, *felt, frame_of(1, 0, long_life)).first != 0.6F) {}
}

}  // namespace
}  // namespace thaum::game
