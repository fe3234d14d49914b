// Tests of a real arm in a match: the forces that its thread sent to the device equal those of the match,
// of a replay and of a restored match, bit for bit.
#include <cmath>
#include <map>

#include "game/components/orb.h"
#include "game/context/arms.h"
#include "game/data/wand_slots.h"
#include "game/match/hand/arm_system.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using input::Button;

std::shared_ptr<const MatchData> short_rounds() {
    DataChoice choice{.match = "standard",
                      .overrides = {"standard.seconds=2", "standard.interval_s=1",
                                    "standard.boil_over.seconds=0", "haptics.share=1"}};
    return std::make_shared<const MatchData>(load_match_data(assets(), choice).value());
}

MatchSetup one_arm() {
    return {.seed = 1,
            .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                        {.player = 1, .kind = input::DeviceKind::script, .name = "two"},
                        {.player = 0, .kind = input::DeviceKind::arm, .name = "arm"}}};
}

/// A match, with short rounds by default, and the thread of an arm (a haptic device). A random generator
/// decides when the thread is ahead of the match or behind it.
struct ArmMatch {
    std::shared_ptr<const MatchData> data = short_rounds();
    Simulation match{data, one_arm()};
    input::ArmServo servo{};
    Random random = random_stream(5, 1);
    std::int32_t arm_ticks = 0;
    std::int64_t now_ns = 0;
    int ahead = 0;
    std::uint32_t arm_buttons = 0, hand_buttons = 0;
    std::uint8_t wand_key = 0;
    std::uint32_t epoch = 0, samples = 0;
    bool still = false;        ///< true: the arm sends no samples
    bool resting = false;      ///< true: the arm does not move
    std::int32_t back_um = 0;  ///< displacement of the arm towards its user (um)
    std::array<std::int32_t, 3> turned_urad{};
    /// Force that the arm has exerted at each sample (N); the index is the sample's height in um
    std::vector<vec3> told{{}};
    std::map<std::int32_t, vec3> computed{};
    std::vector<input::InputFrame> frames{};
    std::map<Tick, std::uint64_t> hashes{};
    std::map<Tick, std::uint64_t> force_hashes{};
    double strongest = 0;

    void move_arm() {
        now_ns += 1'000'000;
        input::ArmReading reading{.time_ns = now_ns, .buttons = arm_buttons};
        // The arm moves to and fro by 2 cm at 0.5 m/s. Its height (um) is the number of the sample.
        const auto phase = resting ? 0 : (arm_ticks + 1) % 80;
        ++arm_ticks;
        reading.position_um = {500 * (phase < 40 ? phase : 80 - phase), arm_ticks, back_um};
        reading.rotation_urad = turned_urad;
        told.push_back(servo.step(reading));
        strongest = std::max(strongest, glm::length(told.back()));
    }

    void run_match(std::uint16_t skips = 0) {
        input::InputFrame frame;
        frame.devices[0].buttons = hand_buttons;
        frame.devices[0].wand = wand_key;
        frame.devices[0].skips = skips;
        frame.devices[2] = servo.take();
        match.tick(frame);
        frames.push_back(frame);
        const auto& state = arm().state;
        if (state.samples != 0 && (state.samples != samples || state.epoch != epoch))
            computed[state.position_um[1]] = state.servo.safety.output;
        samples = state.samples, epoch = state.epoch;
        if (match.now() % 128 == 0) {
            hashes[match.now()] = match.state_hash();
            force_hashes[match.now()] = match.force_hash();
        }
        if (fill_order(match.world(), match.haptic_setup(), 0, servo.order())) servo.publish();
    }

    void run(int ticks) {
        for (int done = 0; done < ticks;) {
            const bool by_arm = !still && (ahead < -2 || (ahead < 8 && random.uniform() < 0.5));
            by_arm ? move_arm() : run_match();
            done += by_arm ? 0 : 1;
            ahead = still ? 0 : ahead + (by_arm ? 1 : -1);
        }
    }

    Arm arm() const { return arms_in(match.world()).front(); }
    const HandState& hand_state() const { return match.world().get<HandState>(wizard_of(match.world(), 0)); }

    void expect_same_forces() const {
        for (const auto& [tick, force] : computed)
            ASSERT_TRUE(force == told[static_cast<std::size_t>(tick)]) << tick << " " << force.z;
    }
};

/// Plays shots, a pause, the end of a round and the next round, a press of the emergency key and its end, an
/// arm that stops, and skipped samples.
void play(ArmMatch& m) {
    m.run(200);
    m.arm_buttons = 1;  // the button that fires
    m.run(700);
    m.hand_buttons = bit(Button::pause);
    m.run(50);
    m.hand_buttons = 0;
    m.run(200);
    m.hand_buttons = bit(Button::pause);
    m.run(50);
    m.hand_buttons = bit(Button::panic);
    m.run(20);
    m.hand_buttons = 0;
    m.run(150);
    m.hand_buttons = bit(Button::panic);
    m.run(20);
    m.hand_buttons = 0;
    m.run(400);
    m.still = true;
    m.run(150);
    m.still = false;
    m.run(1500);  // long enough to reach the next round
    m.hand_buttons = bit(Button::clutch);
    m.run(150);
    m.hand_buttons = 0;
    m.run(300);
    m.still = true;
    m.run(600);
    m.still = false;
    m.run(200);
    m.resting = true;
    m.run(500);
    m.resting = false;
    m.run(500);
    for (int i = 0; i < 400; ++i) m.move_arm();
    m.run_match(399);
    m.run(1500);
}

TEST(Arm, FeelsTheForcesThatTheMatchComputes) {
    ArmMatch m;
    play(m);
    m.expect_same_forces();
    EXPECT_EQ(m.servo.faults().differing, 0U);
    EXPECT_GT(m.computed.size(), 4000U);
    EXPECT_GT(m.strongest, 1.1) << "the recoil of a bolt";
    EXPECT_GE(m.match.match().round, 1U);
    EXPECT_EQ(m.arm().state.old_poses, 0U);
    EXPECT_GE(m.arm().state.gaps, 2U);
}

TEST(Arm, AReplayComputesTheSame) {
    ArmMatch m;
    play(m);
    Simulation again(m.data, one_arm());
    for (const auto& frame : m.frames) {
        again.tick(frame);
        if (again.now() % 128 != 0) continue;
        ASSERT_EQ(again.state_hash(), m.hashes[again.now()]) << again.now();
        ASSERT_EQ(again.force_hash(), m.force_hashes[again.now()]) << again.now();
    }
}

TEST(Arm, ARestoredMatchGoesOnTheSame) {
    ArmMatch m;
    play(m);
    Simulation first(m.data, one_arm()), second(m.data, one_arm());
    for (Tick t = 0; t < keyframe_interval; ++t) first.tick(m.frames[t]);
    Bytes saved;
    first.save(saved);
    ASSERT_TRUE(second.restore(saved, keyframe_interval));
    while (second.now() < m.frames.size()) second.tick(m.frames[second.now()]);
    EXPECT_EQ(second.state_hash(), m.match.state_hash());
}

/// The force at a sample depends on the haptic model that the arm used then. If the log names another model,
/// the replay differs.
TEST(Arm, AnotherModelGivesAnotherForce) {
    ArmMatch m;
    play(m);
    Simulation again(m.data, one_arm());
    for (const auto& original : m.frames) {
        auto frame = original;
        if (frame.devices[2].model_age == 1) frame.devices[2].model_age = 2;
        again.tick(frame);
    }
    EXPECT_NE(again.state_hash(), m.match.state_hash());
}

TEST(Arm, TheHandIsWhereTheArmIs) {
    ArmMatch m;
    m.run(300);
    const auto& device = m.hand_state().device;
    EXPECT_EQ(device.position, input::position_of(m.arm().state));
    EXPECT_NEAR(std::abs(device.velocity.x), 0.5, 0.5);
    EXPECT_NEAR(device.velocity.y, 0.001, 1e-9);
    EXPECT_NEAR(device.position.y, m.arm_ticks * 1e-6, 20e-6);
}

TEST(Arm, ButtonUsesTheWand) {
    ArmMatch m;
    m.run(100);
    m.arm_buttons = 1;
    m.run(500);
    EXPECT_GE(m.match.world().get<WandBelt>(wizard_of(m.match.world(), 0)).fired, 3U);
}

TEST(Arm, InAPauseNothingIsFelt) {
    ArmMatch m;
    m.arm_buttons = 1;
    m.run(700);
    m.arm_buttons = 0;
    m.hand_buttons = bit(Button::pause);
    m.run(100);
    ASSERT_EQ(m.match.match().paused, 1U);
    const auto then = m.arm_ticks;
    m.run(200);
    for (auto t = static_cast<std::size_t>(then); t < m.told.size(); ++t) ASSERT_EQ(m.told[t], vec3(0));
}

TEST(Arm, MatchGoesOnWhenTheArmStops) {
    ArmMatch m;
    m.run(300);
    m.still = true;
    m.run(240);
    EXPECT_EQ(m.hand_state().servo.safety.output, vec3(0));
    EXPECT_EQ(m.hand_state().servo.safety.cause, static_cast<std::uint32_t>(haptics::SafetyCause::stale));
    EXPECT_EQ(m.match.match().played, 540U);
    m.still = false;
    m.run(100);
    EXPECT_LE(m.arm().state.without, 3U);
}

TEST(Arm, MouseMovesTheHandWhileTheArmIsGone) {
    ArmMatch m;
    m.run(310);
    const auto left_at = m.hand_state().device.position;
    m.still = true;
    m.run(270);
    EXPECT_EQ(arm_condition(m.match.world(), 0), ArmCondition::gone);
    EXPECT_NEAR(glm::distance(m.hand_state().device.position, left_at), 0, 0.01)
        << "the hand goes on where it was";
    const auto fired = m.match.world().get<WandBelt>(wizard_of(m.match.world(), 0)).fired;
    m.hand_buttons = bit(Button::fire);
    m.run(300);
    EXPECT_GT(m.match.world().get<WandBelt>(wizard_of(m.match.world(), 0)).fired, fired);
    m.run(40);
    EXPECT_GT(glm::length(m.hand_state().device.velocity), 0) << "the recoil does not move the hand";
}

TEST(Arm, ScriesAndWhenItIsLostTheSimulatedHandDoes) {
    ArmMatch m{.data = duel_data({"haptics.share=1"})};
    const auto wizard = wizard_of(m.match.world(), 0);
    auto& motion = m.match.world_to_change().get<Motion>(wizard);
    motion.position = {-16.5, m.match.data().wizard.height / 2, 0};
    m.match.physics().set_state(wizard.index, motion);
    m.hand_buttons = bit(Button::stir);
    m.run(50);
    m.wand_key = 3;
    m.run(50);
    m.wand_key = 0;
    const auto scrying = [&] { return m.match.world().find<Scrying>(wizard); };
    const auto is_felt = [&] { return m.hand_state().servo.primitives != 0; };
    m.run(500);
    ASSERT_NE(scrying(), nullptr);
    EXPECT_TRUE(is_felt()) << "the arm feels the flow";
    m.expect_same_forces();
    EXPECT_EQ(m.servo.faults().differing, 0U);
    const vec3 before = scrying()->place;
    m.still = true;
    m.run(600);
    ASSERT_NE(scrying(), nullptr) << "the wizard goes on";
    EXPECT_TRUE(is_felt()) << "by the simulated hand";
    EXPECT_TRUE(is_finite(scrying()->place));
    EXPECT_LT(glm::distance(scrying()->place, before), 0.5) << "it begins where the arm was";
    m.still = false;
    m.run(300);
    m.resting = true;
    m.run(900);
    EXPECT_TRUE(is_felt()) << "the arm is back";
    m.expect_same_forces();
    m.hand_buttons = 0;
    m.run(50);
    EXPECT_EQ(scrying(), nullptr);
    EXPECT_FALSE(is_felt());
}

TEST(Arm, IsFeltAgainAfterItWasHeldStill) {
    ArmMatch m;
    m.arm_buttons = 1;
    m.run(500);
    m.still = true;
    m.run(600);
    m.still = false;
    m.run(30);
    const auto back = static_cast<std::size_t>(m.arm_ticks);
    m.run(1000);
    EXPECT_EQ(arm_condition(m.match.world(), 0), ArmCondition::back);
    const auto there = m.hand_state().device.position;
    m.resting = true;
    m.run(290);
    EXPECT_EQ(m.hand_state().device.position, there);
    for (auto t = back; t < m.told.size(); ++t)
        ASSERT_EQ(m.told[t], vec3(0)) << "moved, or not yet long enough still";
    m.strongest = 0;
    m.run(700);
    EXPECT_EQ(arm_condition(m.match.world(), 0), ArmCondition::felt);
    EXPECT_GT(m.strongest, 0.5);
    EXPECT_NEAR(glm::distance(m.hand_state().device.position, there), 0, 0.002) << "the hand did not jump";
    for (auto t = back; t + 1 < m.told.size() && m.told[t] == vec3(0); ++t)
        ASSERT_LE(glm::length(m.told[t + 1]), 0.13) << "the force jumps";
    m.expect_same_forces();
}

TEST(Arm, TheClutchMovesTheArmFreeOfTheHand) {
    ArmMatch m;
    m.run(310);
    const auto before = m.hand_state().device.position;
    m.hand_buttons = bit(Button::clutch);
    m.arm_buttons = 1;
    m.run(30);
    const auto clutched = static_cast<std::size_t>(m.arm_ticks);
    const auto there = m.hand_state().device.position;
    EXPECT_EQ(arm_condition(m.match.world(), 0), ArmCondition::clutched);
    EXPECT_NEAR(glm::distance(there, before), 0, 0.01);
    for (int t = 0; t < 10; ++t) {
        m.run(33);
        EXPECT_EQ(m.hand_state().device.position, there);
    }
    for (auto t = clutched; t < m.told.size(); ++t) ASSERT_EQ(m.told[t], vec3(0));
    const auto tip = input::position_of(m.arm().state);
    m.hand_buttons = 0;
    m.run(500);
    const auto moved = input::position_of(m.arm().state) - tip;
    EXPECT_NEAR(glm::distance(m.hand_state().device.position, there + moved), 0, 0.005);
    EXPECT_GT(glm::distance(there, tip), 0.001);
    m.expect_same_forces();
}

/// While the clutch (a button) is held, the arm moves without the hand. Many strokes in one direction, with
/// the clutch held on each way back, must not move the hand beyond its reach.
TEST(Arm, TheClutchDoesNotLengthenTheReach) {
    ArmMatch m;
    m.run(100);
    for (int stroke = 0; stroke < 30; ++stroke) {
        m.hand_buttons = bit(Button::clutch);
        while (m.arm_ticks % 80 != 38) m.run(1);
        for (int t = 0; t < 60 && m.arm_ticks % 80 != 2; ++t) m.run(1);
        m.hand_buttons = 0;
        while (m.arm_ticks % 80 != 38) m.run(1);
    }
    const auto x = m.hand_state().device.position.x;
    EXPECT_GT(x, 0.06);
    EXPECT_LT(x, m.match.haptic_setup().device.reach.x + 0.021)
        << "the hand is beyond its reach by more than a stroke";
    m.expect_same_forces();
}

/// Holds the arm still in the middle and selects the wand called `name`.
void take_wand(ArmMatch& m, std::string_view name) {
    m.resting = true;
    m.run(100);
    for (const auto& wand : m.data->wands) {
        if (wand.name == name) m.wand_key = static_cast<std::uint8_t>(wand.stats.slot + 1);
    }
    m.run(20);
    m.hand_buttons = 0;
    m.wand_key = 0;
    m.run(20);
}

const WandRules& wand_of(const ArmMatch& m) {
    return *wand_in_hand(*m.data, m.match.world().get<WandBelt>(wizard_of(m.match.world(), 0)))->rules;
}
std::uint32_t shots_of(const ArmMatch& m) {
    return m.match.world().get<WandBelt>(wizard_of(m.match.world(), 0)).fired;
}

TEST(Arm, ChargesABlastByItsButton) {
    ArmMatch m{duel_data()};
    take_wand(m, "blast");
    m.arm_buttons = 1;
    m.run(1500);
    EXPECT_GT(glm::length(m.told.back()), 0.5) << "the charge must press on the hand";
    m.arm_buttons = 0;
    m.run(50);
    EXPECT_EQ(shots_of(m), 1U);
    m.expect_same_forces();
}

TEST(Arm, DrawsALobByPullingBack) {
    ArmMatch m{duel_data()};
    take_wand(m, "lob");
    m.arm_buttons = 1;
    m.run(1500);
    m.arm_buttons = 0;
    m.run(50);
    EXPECT_EQ(shots_of(m), 0U) << "a button alone draws nothing";
    m.arm_buttons = 1;
    m.run(50);
    for (int t = 0; t < 600; ++t) {
        m.back_um += 100;  // the arm moves towards the user at 0.1 m/s
        m.run(1);
    }
    m.run(100);
    const double drawn = *wand_of(m).readiness(m.match.world(), wizard_of(m.match.world(), 0));
    EXPECT_NEAR(drawn, 0.06 * 0.51 / 0.055, 0.03);
    const vec3 felt = m.told.back();
    EXPECT_LT(felt.z, -0.3) << "the spring pulls back";
    m.arm_buttons = 0;
    m.run(50);
    EXPECT_EQ(shots_of(m), 1U);
    m.back_um = 0;
    m.run(100);
    m.arm_buttons = 1;
    m.run(20);
    EXPECT_GT(m.hand_state().tether.stiffness, 0) << "the sling cannot be drawn again at once";
    m.expect_same_forces();
}

/// Turns the player's view towards a place (m, world).
void look_at(ArmMatch& m, vec3 place) {
    const auto wizard = wizard_of(m.match.world(), 0);
    const auto& motion = std::as_const(m.match.world_to_change()).get<Motion>(wizard);
    const vec3 to = place - eye_of(m.data->wizard, motion.position);
    m.match.world_to_change().get<Gaze>(wizard) = {.yaw = det::atan2(-to.x, -to.z),
                                                   .pitch = det::atan2(to.y, std::hypot(to.x, to.z))};
}

TEST(Arm, SwingsAndShortensTheRope) {
    ArmMatch m{duel_data()};
    take_wand(m, "swing");
    const auto& motion = m.match.world().get<Motion>(wizard_of(m.match.world(), 0));
    look_at(m, motion.position + vec3(1, -0.6, 0.5));  // a place on the ground
    m.arm_buttons = 1;
    m.run(60);
    EXPECT_TRUE(wand_of(m).held_at(m.match.world(), wizard_of(m.match.world(), 0)));
    m.expect_same_forces();
}

TEST(Arm, LiftedThingFollowsTheHand) {
    ArmMatch m{duel_data()};
    take_wand(m, "lift");
    const auto wizard = wizard_of(m.match.world(), 0);
    std::vector<vec3> things;
    m.match.world().view<const Prop, const Motion>().each(
        [&](const Prop&, const Motion& motion) { things.push_back(motion.position); });
    std::optional<vec3> held;
    for (const vec3 thing : things) {
        look_at(m, thing);
        m.arm_buttons = 1;
        m.run(30);
        held = wand_of(m).held_at(m.match.world(), wizard);
        if (held) break;
        m.arm_buttons = 0;
        m.run(20);
    }
    ASSERT_TRUE(held) << "of " << things.size() << " things";
    m.run(500);
    const vec3 before = *wand_of(m).held_at(m.match.world(), wizard);
    m.resting = false;  // the arm moves to and fro by 2 cm again
    double farthest = 0;
    for (int t = 0; t < 200; ++t) {
        m.run(1);
        if (const auto at = wand_of(m).held_at(m.match.world(), wizard))
            farthest = std::max(farthest, glm::distance(*at, before));
    }
    EXPECT_GT(farthest, 0.02) << "the held thing must follow the hand";
    EXPECT_GT(m.strongest, 0.1);
    m.expect_same_forces();
}

TEST(Arm, TheStylusTurnsTheWand) {
    ArmMatch m;
    m.turned_urad = {200'000, -300'000, 50'000};
    m.run(100);
    EXPECT_NEAR(glm::distance(stylus_turn(m.match.world(), 0), vec3(0.2, -0.3, 0.05)), 0, 1e-12);
    EXPECT_EQ(stylus_turn(m.match.world(), 1), vec3(0));
    Simulation again(m.data, one_arm());
    for (const auto& frame : m.frames) again.tick(frame);
    EXPECT_EQ(stylus_turn(again.world(), 0), stylus_turn(m.match.world(), 0));
    m.still = true;
    m.run(300);
    EXPECT_EQ(stylus_turn(m.match.world(), 0), vec3(0)) << "an arm that is gone holds nothing";
}

TEST(Arm, AMatchWithoutAnArmHasNoArmComponents) {
    const Simulation match(duel_data(), {.seed = 1, .devices = {}});
    EXPECT_TRUE(arms_in(match.world()).empty());
    std::size_t models = 0;
    match.world().view<const PastModel>().each([&](const PastModel&) { ++models; });
    EXPECT_EQ(models, 0U);
}

}  // namespace
}  // namespace thaum::game::test
