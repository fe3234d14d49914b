// Stress tests of hands that use lift and swing: invalid poses, jumps of position, hands that shake at 10
// m/s, springs of 10^6 N/m, things that are wedged, held by both wizards or destroyed, devices that vanish,
// and a match that stalls. Forces must stay finite and within the force limit, energy bounded, things inside
// the walls, and wizards below a speed limit.
#include <memory>

#include "core/text.h"
#include "game/match/hand/arm_system.h"
#include "stability/game_hands_rig.h"

namespace thaum::game::test {
namespace {

std::int32_t anything(Random& random) {
    switch (random.below(5)) {
        case 0: return std::numeric_limits<std::int32_t>::min();
        case 1: return std::numeric_limits<std::int32_t>::max();
        default: return static_cast<std::int32_t>(random.below(300'000)) - 150'000;
    }
}

/// A wand to test, lift or swing: its name, and the function that makes the hand use the wand.
struct StressedWand {
    const char* name;
    void (*begin)(HandsRig&);
};
void begin_lift(HandsRig& rig) {
    rig.box({1, 1, 1}, 20, {11, 0.5, 16});
    rig.run(50);
    rig.take(0, {11, 0.5, 16});
}
void begin_swing(HandsRig& rig) { rig.hang(0); }
constexpr std::array stressed_wands{StressedWand{"lift", begin_lift}, StressedWand{"swing", begin_swing}};

class StressedHands : public testing::TestWithParam<StressedWand> {};
INSTANTIATE_TEST_SUITE_P(Each, StressedHands, testing::ValuesIn(stressed_wands),
                         [](const auto& tested) { return std::string(tested.param.name); });

// ---- impossible poses of an arm ---------------------------------------------------------------------------

TEST_P(StressedHands, StayTameForAnyPosesOfAnArm) {
    HandsRig rig({}, 1);
    Random random = random_stream(7, 1);
    bool wild = false;
    rig.before = [&](input::InputFrame& frame) {
        auto& sample = frame.devices[arm_device];
        sample = arm_sample({0, 0, 0});
        if (!wild || random.below(3) != 0) return;
        for (auto& count : sample.counts) count = anything(random);
        sample.model_age = static_cast<std::uint16_t>(random.below(100));
        if (random.below(50) == 0) sample.skips = static_cast<std::uint16_t>(random.below(0x10000));
    };
    GetParam().begin(rig);
    wild = true;
    for (int i = 0; i < 40; ++i) {
        rig.run(200);
        rig.release(0, Button::fire);
        rig.run(20);
        rig.hold(0, Button::fire);
    }
    rig.watch.expect_tame();
    wild = false;
    rig.release(0, Button::fire);
    rig.run(500);
    EXPECT_LT(glm::length(rig.hand_state(0).servo.safety.output), 0.1) << "a force remains";
}

TEST_P(StressedHands, StayTameWhenAnArmJumpsAcrossItsWorkspace) {
    HandsRig rig({}, 1);
    Random random = random_stream(8, 1);
    vec3 place{};
    rig.before = [&](input::InputFrame& frame) { frame.devices[arm_device] = arm_sample(place); };
    GetParam().begin(rig);
    for (int i = 0; i < 100; ++i) {
        place = {random.uniform(-0.08, 0.08), random.uniform(-0.06, 0.06), random.uniform(-0.035, 0.035)};
        rig.run(1 + random.below(200));
    }
    rig.watch.expect_tame(jump_speed);
    EXPECT_GT(rig.held_ticks, 100U);
}

TEST_P(StressedHands, StayTameWhileShakingAtTenMetresASecond) {
    for (const double speed : {0.5, 3.9, 10.0}) {
        HandsRig rig({}, 1);
        Tick t = 0;
        bool shake = false;
        rig.before = [&](input::InputFrame& frame) {
            const double x = shake ? shaken(++t, speed, 0.1) : 0;
            frame.devices[arm_device] = arm_sample({x, 0.5 * x, 0.7 * x});
        };
        GetParam().begin(rig);
        shake = true;
        rig.run(4000);
        rig.watch.expect_tame(speed);
        EXPECT_GT(rig.held_ticks, 40U);
    }
}

/// The mouse and its wheel move the simulated hand, by any numbers.
TEST_P(StressedHands, StayTameForAnyMouseInput) {
    HandsRig rig;
    Random random = random_stream(9, 1);
    GetParam().begin(rig);
    rig.hold(0, Button::clutch);
    rig.before = [&](input::InputFrame& frame) {
        if (random.below(4) != 0) return;
        for (const auto count : {input::hand::look_right, input::hand::look_up, input::hand::wheel})
            frame.devices[0].counts[count] = anything(random);
    };
    for (int i = 0; i < 20; ++i) {
        rig.run(300);
        rig.release(0, Button::fire);
        rig.run(20);
        rig.hold(0, Button::fire);
    }
    rig.watch.expect_tame();
}

// ---- stiffness of the lifting spring ----------------------------------------------------------------------

TEST(LiftStress, StaysBoundedForAnyStiffnessAndMass) {
    for (const double stiffness : {1.0, 4000.0, 1e5, 1e6}) {
        for (const double mass : {0.05, 5.0, 120.0}) {
            SCOPED_TRACE(text(stiffness, " N/m, ", mass, " kg"));
            HandsRig rig({text("lift.hold.stiffness_n_per_m=", stiffness)}, 1);
            Tick t = 0;
            bool shake = false;
            rig.before = [&](input::InputFrame& frame) {
                frame.devices[arm_device] = arm_sample({shake ? shaken(++t, 0.4, 0.04) : 0, 0, 0});
            };
            rig.box({1, 1, 1}, mass, {11, 0.5, 16});
            rig.run(50);
            rig.take(0, {11, 0.5, 16});
            shake = true;
            rig.run(2500);
            rig.watch.expect_tame(0.4);
            // Bound: the energy of a spring stretched by 2.5 m, at which lift loses a thing, or of a thing
            // that is as fast as its hand, plus the energy of a fall.
            constexpr double lost = 2.5, hand = 20 * 0.4;
            const double most =
                std::max(stiffness * lost * lost / 2, mass * hand * hand * 2) + mass * 9.81 * 3;
            EXPECT_LT(rig.watch.energy, most);
        }
    }
}

TEST(SwingStress, StaysBoundedForAnyStiffness) {
    for (const double stiffness : {1.0, 4000.0, 1e5, 1e6}) {
        for (const double tension : {4000.0, 1e6}) {
            SCOPED_TRACE(text(stiffness, " N/m, ", tension, " N"));
            HandsRig rig({text("swing.rope.stiffness_n_per_m=", stiffness),
                          text("swing.rope.tension_max_n=", tension)},
                         1);
            Tick t = 0;
            bool shake = false;
            rig.before = [&](input::InputFrame& frame) {
                frame.devices[arm_device] = arm_sample({0, 0, shake ? shaken(++t, 0.4, 0.04) : 0});
            };
            rig.hang(0);
            shake = true;
            rig.run(4000);
            rig.watch.expect_tame();
        }
    }
}

// ---- things that hands hold -------------------------------------------------------------------------------

/// A thing wedged between two fixed blocks and the wall is pulled in all directions.
TEST(LiftStress, AWedgedThingGoesThroughNothing) {
    for (const double stiffness : {4000.0, 1e6}) {
        SCOPED_TRACE(stiffness);
        HandsRig rig({text("lift.hold.stiffness_n_per_m=", stiffness), "lift.hold.lost_m=100"}, 1);
        Tick t = 0;
        bool pull = false;
        rig.before = [&](input::InputFrame& frame) {
            const double x = pull ? shaken(++t, 0.05, 0.15) : 0;
            const double into = std::min(0.06, 1e-4 * static_cast<double>(t));
            frame.devices[arm_device] = arm_sample({x, 0.3 * x, -into});
        };
        rig.place(0, {15, 0, 16}, {1, 0, 0});
        rig.box({2, 3, 1}, 0, {18.9, 1.5, 14.95});
        rig.box({2, 3, 1}, 0, {18.9, 1.5, 17.05});
        const auto thing = rig.box({1, 1, 1}, 20, {19.4, 0.5, 16});
        rig.run(100);
        rig.take(0, {19.4, 0.5, 16});
        pull = true;
        for (int i = 0; i < 6000 && !HasFatalFailure(); ++i) {
            rig.run(1);
            const vec3 at = rig.match.world().get<Motion>(thing).position;
            ASSERT_LT(at.x, 19.6) << i;
            ASSERT_GT(at.y, 0.3) << i;
            // The thing may move above or in front of the blocks, but not into them.
            const bool between = at.x > 18.4 && at.y < 3;
            ASSERT_TRUE(!between || std::abs(at.z - 16) < 0.25) << i;
        }
        rig.watch.expect_tame();
        EXPECT_GT(rig.held_ticks, 1000U);
    }
}

TEST(LiftStress, AThingSlammedAgainstWallsStaysInside) {
    HandsRig rig({"lift.hold.lost_m=100"}, 1);
    Random random = random_stream(4, 4);
    vec3 place{};
    rig.before = [&](input::InputFrame& frame) { frame.devices[arm_device] = arm_sample(place); };
    rig.place(0, {16, 0, 16}, {1, 0, 0});
    rig.box({0.3, 0.3, 0.3}, 5, {18, 0.15, 16});
    rig.run(50);
    rig.take(0, {18, 0.15, 16});
    for (int i = 0; i < 150; ++i) {
        place = {random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.3), random.uniform(-0.3, 0.1)};
        rig.run(60);
    }
    rig.watch.expect_tame();
    EXPECT_GT(rig.held_ticks, 5000U) << "the thing was lost";
}

TEST(LiftStress, AThingHeldByBothIsPulledByBoth) {
    HandsRig rig({}, 2);
    Tick t = 0;
    bool tear = false;
    rig.before = [&](input::InputFrame& frame) {
        const double x = tear ? shaken(++t, 0.3, 0.1) : 0;
        frame.devices[arm_device] = arm_sample({x, 0, x});
        frame.devices[arm_device + 1] = arm_sample({x, 0.4 * x, -x});
    };
    rig.place(1, {14, 0, 16}, {-1, 0, 0});
    rig.box({1, 1, 1}, 20, {11, 0.5, 16});
    rig.run(50);
    rig.take(0, {11, 0.5, 16});
    rig.take(1, {11, 0.5, 16});
    tear = true;
    rig.run(3000);
    EXPECT_TRUE(rig.busy(0) || rig.busy(1)) << "both hands must lose the thing";
    rig.release(0, Button::fire);
    rig.run(500);
    rig.watch.expect_tame();
    rig.release(1, Button::fire);
    rig.run(300);
    EXPECT_EQ(rig.hand_state(0).servo.safety.output, vec3(0));
    EXPECT_EQ(rig.hand_state(1).servo.safety.output, vec3(0));
}

TEST(LiftStress, ADestroyedThingIsNotHeld) {
    for (const int holders : {1, 2}) {
        HandsRig rig({}, 0);
        rig.place(1, {14, 0, 16}, {-1, 0, 0});
        const auto thing = rig.box({1, 1, 1}, 60, {11, 0.5, 16});
        rig.run(50);
        rig.take(0, {11, 0.5, 16});
        if (holders == 2) rig.take(1, {11, 0.5, 16});
        rig.run(300);
        EXPECT_GT(glm::length(rig.hand_state(0).servo.safety.output), 0.1);
        rig.match.world_to_change().destroy(thing);
        // A new entity, which may have the index of the destroyed one.
        const auto other = rig.box({1, 1, 1}, 60, {11, 0.5, 16});
        rig.run(300);
        for (std::uint32_t p = 0; p < static_cast<std::uint32_t>(holders); ++p) {
            EXPECT_FALSE(rig.busy(p));
            EXPECT_EQ(rig.hand_state(p).servo.safety.output, vec3(0));
        }
        EXPECT_LT(glm::length(rig.match.world().get<Motion>(other).velocity), 0.1);
        rig.watch.expect_tame();
    }
}

TEST_P(StressedHands, LetGoWhenTheirWizardDies) {
    HandsRig rig;
    GetParam().begin(rig);
    rig.run(200);
    rig.match.world_to_change().get<Health>(rig.wizard(0)).points = -5;
    rig.run(50);
    EXPECT_TRUE(rig.match.world().has<Dead>(rig.wizard(0)));
    EXPECT_FALSE(rig.busy(0));
    rig.run(4000);
    EXPECT_FALSE(rig.match.world().has<Dead>(rig.wizard(0)));
    EXPECT_LT(glm::length(rig.hand_state(0).servo.safety.output), 0.1);
    rig.watch.expect_tame();
}

TEST(SwingStress, AnAnchorThatIsGoneStillHoldsOrLetsGo) {
    HandsRig rig;
    rig.hang(0);
    rig.run(200);
    std::vector<ecs::Entity> anchors;
    auto& world = rig.match.world_to_change();
    world.view<const Anchor>().each([&](ecs::Entity e) { anchors.push_back(e); });
    EXPECT_FALSE(anchors.empty());
    for (const auto e : anchors) world.destroy(e);
    rig.run(1500);
    rig.release(0, Button::fire);
    rig.run(1500);
    EXPECT_FALSE(rig.busy(0));
    rig.watch.expect_tame();
}

// ---- devices that vanish, matches that stall --------------------------------------------------------------

TEST_P(StressedHands, StayTameWhenAnArmVanishesAndComesBackElsewhere) {
    for (const Tick gone : std::initializer_list<Tick>{1, 5, 19, 20, 60, 300, 3000}) {
        SCOPED_TRACE(gone);
        HandsRig rig({}, 1);
        bool there = true;
        vec3 place{};
        rig.before = [&](input::InputFrame& frame) {
            frame.devices[arm_device] = there ? arm_sample(place) : input::DeviceSample{};
        };
        GetParam().begin(rig);
        rig.run(300);
        there = false;
        rig.run(gone);
        // When an arm vanishes, forces are off for 250 ms, then the simulated hand takes over.
        EXPECT_TRUE(gone < 60 || gone > 250 || rig.hand_state(0).servo.safety.output == vec3(0));
        there = true;
        place = {0.06, 0.04, -0.03};
        rig.run(500);
        rig.watch.expect_tame(jump_speed);
    }
}

/// An arm that is shaken, with its servo. Its thread continues while the match stalls.
class ShakenArm {
public:
    explicit ShakenArm(HandsRig& rig) : rig_(rig), limits_(rig.match.haptic_setup().servos[0].limits) {}
    ShakenArm(const ShakenArm&) = delete;
    ShakenArm& operator=(const ShakenArm&) = delete;

    /// Starts the test of a wand, whose own ticks also move the arm.
    void begin(const StressedWand& wand) {
        rig_.before = [this](input::InputFrame& frame) {
            step_unless_ahead();
            publish();
            take(frame);
        };
        wand.begin(rig_);
        rig_.before = [this](input::InputFrame& frame) { take(frame); };
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            step_unless_ahead();
            rig_.run(1);
            publish();
        }
    }

    /// Plays ticks of the arm alone. The match can catch up with 250 of them and skips the others. Returns
    /// the largest force by a model older than 75 ms (N).
    double stall(int ticks) {
        double strongest_late = 0;
        for (int i = 1; i <= ticks; ++i) {
            const double force = step();
            if (i > 75) strongest_late = std::max(strongest_late, force);
        }
        ahead_ = std::min(ticks, 250);
        skips_ = static_cast<std::uint16_t>(ticks - ahead_);
        return strongest_late;
    }

    const haptics::SafetyAudit& audit() const { return audit_; }
    std::uint64_t differing_forces() const { return servo_->faults().differing; }

private:
    /// Plays one tick of the arm. Returns the magnitude of its force (N).
    double step() {
        const double x = shaken(++tick_, 0.2, 0.04);
        input::ArmReading reading{.time_ns = now_ns_ += 1'000'000};
        reading.position_um = {input::quantised(x * 1e6), 0, input::quantised(-x * 1e6)};
        const vec3 told = servo_->step(reading);
        audit_.record(limits_, {.wanted = told}, told);
        return glm::length(told);
    }
    void step_unless_ahead() {
        if (ahead_ > 0) {
            --ahead_;
        } else {
            step();
        }
    }
    void publish() {
        if (fill_order(rig_.match.world(), rig_.match.haptic_setup(), 0, servo_->order())) servo_->publish();
    }
    void take(input::InputFrame& frame) {
        frame.devices[arm_device] = servo_->take();
        frame.devices[0].skips = std::exchange(skips_, std::uint16_t{0});
    }

    HandsRig& rig_;
    haptics::SafetyLimits limits_;
    std::unique_ptr<input::ArmServo> servo_ = std::make_unique<input::ArmServo>();
    haptics::SafetyAudit audit_;
    Tick tick_ = 0;
    std::int64_t now_ns_ = 0;
    int ahead_ = 0;  ///< number of ticks that the arm has played and the match has not
    std::uint16_t skips_ = 0;
};

/// The arm's thread continues while the match stalls. If the backlog exceeds 250 ms, samples are skipped.
TEST_P(StressedHands, StayTameWhileTheMatchStalls) {
    for (const int stalled : {1, 5, 20, 50, 79, 120, 250, 700, 2000}) {
        SCOPED_TRACE(stalled);
        HandsRig rig({}, 1);
        ShakenArm arm(rig);
        arm.begin(GetParam());
        arm.run(300);
        EXPECT_EQ(arm.stall(stalled), 0) << "no force by a model that old";
        arm.run(1000);
        // While the match stalls, for at most 80 ticks, the hand moves under forces of an old model.
        rig.watch.expect_tame(0.2 * std::min(stalled, 80) / 30);
        EXPECT_EQ(arm.audit().violations(haptics::SafetyRule::cap), 0U);
        EXPECT_EQ(arm.audit().violations(haptics::SafetyRule::finite), 0U);
        EXPECT_EQ(arm.differing_forces(), 0U);
    }
}

}  // namespace
}  // namespace thaum::game::test
