// Tests of the forces on hands in a match: each kick equals its closed form, also with other devices and
// force limits, and in the log's tables and hashes.
#include <algorithm>

#include "core/text.h"
#include "game/context/hand_forces.h"
#include "game/match/tables.h"
#include "haptics/audit/safety_audit.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

constexpr double recoil_length = 0.015;  // length of the recoil in assets/wands/bolt.toml (s)
constexpr Tick after_the_last = ticks(recoil_length) + gameplay_period;

const HandState& hand_state_of(const Simulation& match, std::uint32_t player) {
    return match.world().get<HandState>(wizard_of(match.world(), player));
}

/// A match in which a script presses the buttons of one hand.
struct Hands {
    explicit Hands(std::vector<std::string> overrides = {})
        : match(duel_data(std::move(overrides)),
                {.seed = 1,
                 .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                             {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}}) {}
    void hold(Tick ticks, std::uint32_t buttons, std::int32_t right = 0) {
        for (Tick t = 0; t < ticks; ++t) {
            input::InputFrame frame;
            frame.devices[0].buttons = buttons;
            frame.devices[0].counts[input::hand::look_right] = right;
            match.tick(frame);
            impulse += hand_state_of(match, 0).servo.safety.output.z * tick_seconds;
            greatest = std::max(greatest, hand_state_of(match, 0).servo.safety.output.z);
        }
    }
    void shoot(Tick ticks) {
        hold(ticks, input::bit(input::Button::fire));
        hold(after_the_last, 0);
    }
    double shots() const { return match.world().get<WandBelt>(wizard_of(match.world(), 0)).fired; }

    Simulation match;
    double impulse = 0, greatest = 0;
};

struct Held {
    std::string_view device;
    double peak;  // peak force of the device (N)
};
constexpr std::array arms{Held{"touch", 3.3}, Held{"omni", 3.3}, Held{"premium", 8.5}, Held{"falcon", 8},
                          Held{"omega3", 12}};

TEST(HapticSetup, EveryShotKicksWithTheImpulseOfItsHalfSine) {
    for (const auto& arm : arms) {
        for (const double share : {0.2, 0.45, 1.0}) {
            Hands hands({text("haptics.device=\"", arm.device, "\""), text("haptics.share=", share)});
            hands.shoot(500);
            ASSERT_GE(hands.shots(), 4) << arm.device;
            const double peak = 1.2 / 3.3 * arm.peak * share;
            const double impulse = hands.shots() * 2 / pi * peak * recoil_length;
            EXPECT_NEAR(hands.impulse, impulse, 1e-12 * impulse) << arm.device << " " << share;
            EXPECT_LE(hands.greatest, peak) << "the mean over a tick";
            EXPECT_GT(hands.greatest, 0.99 * peak);
        }
    }
}

TEST(HapticSetup, NoShareIsNoForce) {
    Hands hands({"haptics.share=0"});
    hands.shoot(1000);
    EXPECT_GE(hands.shots(), 8);
    EXPECT_EQ(hands.impulse, 0);
    EXPECT_EQ(hands.greatest, 0);
    EXPECT_EQ(hand_state_of(hands.match, 0).device.position, vec3(0));
}

TEST(HapticSetup, AnUnknownDeviceIsAnErrorInOneLine) {
    for (const auto* device : {"\"spoon\"", "\"../wands/bolt\"", "\"\"", "3"}) {
        const auto data = load_match_data(assets(), {.overrides = {text("haptics.device=", device)}});
        ASSERT_FALSE(data) << device;
        EXPECT_EQ(data.error().message.find('\n'), std::string::npos) << data.error().message;
    }
}

TEST(HapticSetup, TheClutchMovesTheHandWithinItsWorkspaceAndNotTheView) {
    Hands hands;
    const auto gaze = [&] { return hands.match.world().get<Gaze>(wizard_of(hands.match.world(), 0)).yaw; };
    const double yaw = gaze();
    const auto clutch = input::bit(input::Button::clutch);
    hands.hold(100, clutch, 2);
    hands.hold(400, clutch);
    EXPECT_EQ(gaze(), yaw);
    EXPECT_NEAR(hand_state_of(hands.match, 0).device.position.x, 200 * 1e-4, 0.26 / 400)
        << "friction / stiffness";
    hands.hold(300, clutch, 1'000'000'000);
    EXPECT_LE(hand_state_of(hands.match, 0).device.position.x, 0.08);
    hands.hold(10, 0, 2);
    EXPECT_NE(gaze(), yaw);
}

/// Distance (m) by which the wand's tip is to the right if the hand is at the right edge of a device whose
/// workspace has this width (m).
double reach_of_tip(const Simulation& match, std::uint32_t player, double width) {
    const double wand_per_hand = match.haptic_setup().wand_per_hand[player];
    HandState hand_state = empty_hand_state();
    const double rests = wand_tip_of(wand_per_hand, hand_state).x;
    hand_state.device.position.x = width / 2;
    return wand_tip_of(wand_per_hand, hand_state).x - rests;
}

/// The tip moves equally far over the workspace of any device.
TEST(HapticSetup, ANarrowerDeviceReachesAsFar) {
    double reached = 0;
    for (const auto* device : {"touch", "falcon", "omega3", "premium"}) {
        const Simulation match(duel_data({text("haptics.device=\"", device, "\"")}), {});
        const double reach = reach_of_tip(match, 0, match.data().device.workspace.x);
        if (reached == 0) reached = reach;
        EXPECT_NEAR(reach, reached, 1e-12) << device;
    }
    EXPECT_NEAR(reached, 0.8, 1e-12);
}

/// For a real arm the box (workspace) that it reports counts, not that of the simulated device model.
TEST(HapticSetup, AnArmReachesAsFarOverTheBoxThatItReports) {
    constexpr auto arm_kind = input::DeviceKind::arm;
    const auto data = duel_data();
    const auto reach = [&](std::array<std::uint32_t, 3> box_um, input::DeviceKind kind, double width) {
        const input::DeviceSpec arm{.player = 1, .kind = kind, .name = "arm", .box_um = box_um};
        const Simulation match(
            data, {.seed = 1, .devices = {bot_device(0, "level_1"), bot_device(1, "level_1"), arm}});
        EXPECT_NEAR(reach_of_tip(match, 0, match.data().device.workspace.x), 0.8, 1e-12);
        EXPECT_EQ(match.haptic_setup().reach[0], data->device.workspace / 2.0);
        return reach_of_tip(match, 1, width);
    };
    EXPECT_NEAR(reach({100'000, 100'000, 100'000}, arm_kind, 0.1), 0.8, 1e-12);
    EXPECT_NEAR(reach({381'000, 267'000, 191'000}, arm_kind, 0.381), 0.8, 1e-12);
    // Impossible boxes (workspaces) count as unknown, and so does the box of a device that is not an arm.
    EXPECT_NEAR(reach({}, arm_kind, 0.16), 0.8, 1e-12);
    EXPECT_NEAR(reach({100'000, 0, 100'000}, arm_kind, 0.16), 0.8, 1e-12);
    EXPECT_NEAR(reach({1, 1, 1}, arm_kind, 0.16), 0.8, 1e-12);
    EXPECT_NEAR(reach({10'000'000, 10'000'000, 10'000'000}, arm_kind, 1), 0.8, 1e-12);
    EXPECT_NEAR(reach({100'000, 100'000, 100'000}, input::DeviceKind::script, 0.16), 0.8, 1e-12);
}

TEST(HapticSetup, TheHashOfForcesSeesAForceThatTheStateNoLongerShows) {
    Hands one, two;
    one.hold(64, 0);
    two.hold(64, 0);
    const auto two_wizard = wizard_of(two.match.world(), 0);
    two.match.world_to_change().get<HandState>(two_wizard).kick = {vec3(0, 0, 0.1), 1, 7};
    one.hold(1, 0);
    two.hold(1, 0);
    two.match.world_to_change().get<HandState>(two_wizard) =
        std::as_const(one.match).world().get<HandState>(wizard_of(one.match.world(), 0));
    EXPECT_EQ(one.match.state_hash(), two.match.state_hash());
    EXPECT_NE(one.match.force_hash(), two.match.force_hash());
    one.hold(64, 0);
    two.hold(64, 0);
    EXPECT_EQ(one.match.force_hash(), two.match.force_hash()) << "a new stretch of 128 ticks has begun";
}

TEST(HapticSetup, ARowOfForcesHoldsTheForceOnTheHand) {
    Hands hands;
    hands.hold(3, input::bit(input::Button::fire));
    std::string row;
    append_forces(hands.match, row);
    std::string expected = text(hands.match.now(), ",0.003");
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& hand_state = hand_state_of(hands.match, player);
        const vec3 x = hand_state.device.position, f = hand_state.servo.safety.output;
        const auto& energy = hand_state.servo.energy;
        append_text(expected, text(",", x.x, ",", x.y, ",", x.z, ",", f.x, ",", f.y, ",", f.z, ",none,",
                                   energy.created, ",", energy.active_work, ",0,0,0,0,0,0,0,0,0,0,0,0"));
    }
    EXPECT_EQ(row, expected + "\n");
    const auto header = forces_header();
    EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
}

/// Checks limit, energy budget and finiteness of the forces on the bots' hands during a minute. The log does
/// not contain the forces that were requested, so these cannot be compared.
TEST(HapticSetup, TheAuditFindsNothingInAMinuteOfBots) {
    auto duel = make_duel(5);
    const auto& data = duel.match->data();
    const auto limits = haptics::safety_limits(data.device, data.haptic_rules.share);
    std::array<haptics::SafetyAudit, players> audits;
    double felt = 0;
    for (int tick = 0; tick < 60'000; ++tick) {
        duel.run(1);
        for (std::uint32_t p = 0; p < players; ++p) {
            const vec3 told = hand_state_of(*duel.match, p).servo.safety.output;
            audits[p].record(limits, {.wanted = told}, told);
            felt = std::max(felt, glm::length(told));
        }
    }
    EXPECT_GT(felt, 0.5);
    for (const auto& audit : audits) EXPECT_EQ(audit.violations(), 0U);
}

}  // namespace
}  // namespace thaum::game::test
