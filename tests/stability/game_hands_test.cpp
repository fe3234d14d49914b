// Stress on hands that use lift and swing: invalid poses, jumps of position, hands that shake at 10 m/s,
// springs of 10^6 N/m, things that are wedged, held by both or destroyed, devices that vanish, and a match
// that stalls. Forces must stay finite and within the cap, energy bounded, things inside the walls, and no
// wizard may be launched.
#include <functional>
#include <memory>

#include "core/text.h"
#include "game/arena/spawn.h"
#include "game/components/body.h"
#include "game/hand/arm_system.h"
#include "game/player/walk.h"
#include "game/wands/belt.h"
#include "haptics/safety_audit.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using input::Button;

constexpr double wall = 20;            // distance from the middle of the arena to its walls (m)
constexpr double fastest_wizard = 30;  // largest allowed speed (m/s); a fall of 12 m ends with 15 m/s
constexpr double most_created = 0.02;  // largest energy that passive sources may create (J)
constexpr double most_given = 1.0;     // largest energy that active sources may give in about a second (J)
constexpr double jump_speed =
    0.1 / 0.03;  // 10 cm of hand motion within a tick, against a force that follows later (m/s)
// Index of the arm of player 0 among the devices; the arm of player 1 is 3.
constexpr std::uint32_t arm_device = 2;

/// Limits checked in every tick for all bodies and both hands.
struct Watch {
    std::array<haptics::SafetyAudit, players> audits{};
    double fastest = 0, created = 0, given = 0, strongest = 0, energy = 0;

    void look(const Simulation& match) {
        const auto& world = match.world();
        world.view<const Motion, const Body>().each([&](ecs::Entity e, const Motion& m, const Body& body) {
            if (body.mass <= 0) return;
            ASSERT_TRUE(is_finite(m.position) && is_finite(m.velocity) && is_finite(m.spin)) << e.index;
            const double off = std::max(std::abs(m.position.x), std::abs(m.position.z));
            ASSERT_LT(off, wall) << "through the wall";
            ASSERT_GT(m.position.y, -6) << "through the ground";
        });
        for (std::uint32_t p = 0; p < players; ++p) {
            const auto wizard = wizard_of(world, p);
            const auto& hand_state = world.get<HandState>(wizard);
            const vec3 told = hand_state.servo.safety.output;
            audits[p].record(match.haptic_setup().servos[p].limits, {.wanted = told}, told);
            strongest = std::max(strongest, glm::length(told));
            created = std::max(created, hand_state.servo.energy.most_created);
            given = std::max(given, hand_state.servo.energy.active_work);
            fastest = std::max(fastest, glm::length(world.get<Motion>(wizard).velocity));
            ASSERT_TRUE(is_finite(hand_state.device.position) && is_finite(hand_state.device.velocity));
        }
        world.view<const Prop, const Motion, const Body>().each(
            [&](const Prop&, const Motion& m, const Body& body) {
                energy = std::max(energy, body.mass * glm::dot(m.velocity, m.velocity) / 2);
            });
    }
    /// Expects all limits to hold. `speed` is the speed of a hand that reverses within a tick (m/s). The
    /// measured velocity averages 8 ms, so for that long it has the wrong sign and damping drives the hand.
    void expect_tame(double speed = 0) const {
        for (const auto& audit : audits) {
            EXPECT_EQ(audit.violations(haptics::SafetyRule::finite), 0U);
            EXPECT_EQ(audit.violations(haptics::SafetyRule::cap), 0U);
            EXPECT_EQ(audit.violations(haptics::SafetyRule::budget), 0U);
        }
        EXPECT_LT(fastest, fastest_wizard) << "the player was launched";
        EXPECT_LE(created, most_created + strongest * speed * 0.03);
        EXPECT_LE(given, most_given);
    }
};

/// An arena without props and with two scripted wizards, of whom each may hold an arm.
struct HandsRig {
    Simulation match;
    Watch watch{};
    input::InputFrame frame{};
    std::function<void(input::InputFrame&)> before{};  ///< fills the device samples of a tick
    std::uint64_t held_ticks = 0;

    explicit HandsRig(std::vector<std::string> overrides = {}, int arms = 0)
        : match(duel_data(with_energy(std::move(overrides))), setup(arms)) {
        auto& world = match.world_to_change();
        std::vector<ecs::Entity> props;
        world.view<const Prop>().each([&](ecs::Entity e, const Prop&) { props.push_back(e); });
        for (const auto e : props) world.destroy(e);
        place(0, {8, 0, 16}, {1, 0, 0});
        place(1, {-15, 0, -15}, {1, 0, 0});
    }

    static std::vector<std::string> with_energy(std::vector<std::string> more) {
        for (const auto* free :
             {"lift.energy.per_s=0", "lift.energy.per_n_s=0", "lift.energy.cost=0", "swing.energy.per_s=0",
              "swing.energy.cost=0", "haptics.share=1", "quick.kills=1000", "quick.seconds=3600"})
            more.emplace_back(free);
        return more;
    }
    static MatchSetup setup(int arms) {
        MatchSetup made{.seed = 1,
                        .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                                    {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}};
        for (int i = 0; i < arms; ++i)
            made.devices.push_back(
                {.player = static_cast<std::uint32_t>(i), .kind = input::DeviceKind::arm, .name = "arm"});
        return made;
    }

    ecs::Entity wizard(std::uint32_t p) const { return wizard_of(match.world(), p); }
    const HandState& hand_state(std::uint32_t p) const { return match.world().get<HandState>(wizard(p)); }
    vec3 feet(std::uint32_t p) const { return match.world().get<Motion>(wizard(p)).position; }

    void place(std::uint32_t p, vec3 feet, vec3 way) {
        auto& world = match.world_to_change();
        world.get<Motion>(wizard(p)) = standing_at(match.data().wizard, feet);
        world.get<Stance>(wizard(p)) = {};
        match.physics().set_state(wizard(p).index, std::as_const(world).get<Motion>(wizard(p)));
        world.get<Gaze>(wizard(p)) = {det::atan2(-way.x, -way.z),
                                      det::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z))};
    }
    void look_at(std::uint32_t p, vec3 target) {
        const vec3 eye = eye_of(match.data().wizard, feet(p));
        const vec3 way = target - eye;
        match.world_to_change().get<Gaze>(wizard(p)) = {
            det::atan2(-way.x, -way.z), det::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z))};
    }
    /// Adds a prop, or a fixed part of the arena if the mass is 0.
    ecs::Entity box(vec3 size, double mass, vec3 at) {
        Thing thing;
        thing.prop = mass > 0;
        thing.surface = Surface::crate;
        thing.body.shape = physics::Shape::box;
        thing.body.size = size * 0.5;
        thing.body.mass = mass;
        thing.body.friction = 0.8;
        thing.body.layer = mass > 0 ? layer::prop : layer::ground;
        thing.position = at;
        return spawn_thing(match.world_to_change(), thing);
    }

    void hold(std::uint32_t p, Button button) { frame.devices[p].buttons |= bit(button); }
    void release(std::uint32_t p, Button button) { frame.devices[p].buttons &= ~bit(button); }
    void press(std::uint32_t p, Button button) {
        hold(p, button);
        run(20);
        release(p, button);
        run(8);
    }
    void choose(std::uint32_t p, std::uint8_t wand) {
        frame.devices[p].wand = wand;
        run(20);
        frame.devices[p].wand = 0;
        run(8);
    }
    bool busy(std::uint32_t p) const {
        const auto* wand = wand_in_hand(match.data(), match.world().get<WandBelt>(wizard(p)));
        return wand != nullptr && wand->rules->held_at(match.world(), wizard(p)).has_value();
    }
    void run(Tick ticks) {
        for (Tick t = 0; t < ticks && !testing::Test::HasFatalFailure(); ++t) {
            auto now = frame;
            if (before) before(now);
            match.tick(now);
            watch.look(match);
            held_ticks += busy(0) ? 1 : 0;
        }
    }
    void take(std::uint32_t p, vec3 target) {
        choose(p, 4);
        look_at(p, target);
        hold(p, Button::fire);
        run(40);
        EXPECT_TRUE(busy(p)) << "nothing is held";
    }
    /// Makes the wizard hang on a rope over the pit.
    void hang(std::uint32_t p) {
        place(p, {4, 0, 5}, {0, 0, 1});
        run(50);
        choose(p, 5);
        look_at(p, {4, 7, 9});
        hold(p, Button::fire);
        run(40);
        EXPECT_TRUE(busy(p)) << "does not hang";
    }
};

/// Arm sample for a tick whose force used the newest model.
input::DeviceSample arm_sample(vec3 place) {
    input::DeviceSample sample;
    for (int axis = 0; axis < 3; ++axis)
        sample.counts[static_cast<std::size_t>(input::arm::position_x) + static_cast<std::size_t>(axis)] =
            input::quantised(place[axis] * 1e6);
    sample.model_age = 1;
    return sample;
}

/// Triangle wave about 0 with a slope of `speed` (m/s) and a range of `width` (m).
double shaken(Tick t, double speed, double width) {
    const double way = speed * tick_seconds * static_cast<double>(t) + width / 2;
    const double phase = std::fmod(way, 2 * width);
    return (phase < width ? phase : 2 * width - phase) - width / 2;
}

std::int32_t anything(Random& random) {
    switch (random.below(5)) {
        case 0: return std::numeric_limits<std::int32_t>::min();
        case 1: return std::numeric_limits<std::int32_t>::max();
        default: return static_cast<std::int32_t>(random.below(300'000)) - 150'000;
    }
}

/// Start of a test with one wand, so that lift and swing share the tests.
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

// ---- poses ------------------------------------------------------------------------------------------------

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

/// Moves the simulated hand with mouse and wheel.
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

// ---- stiffness --------------------------------------------------------------------------------------------

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
            // Energy of a spring stretched by lost_m, or of a thing as fast as its hand, plus that of a
            // fall.
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

// ---- held things ------------------------------------------------------------------------------------------

/// The thing is wedged between two fixed blocks and the wall, and is pulled in all directions.
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
            // The thing may pass above or in front of the blocks, but not into them.
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
        const auto other = rig.box({1, 1, 1}, 60, {11, 0.5, 16});  // may reuse the freed entity's place
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

// ---- devices that vanish, matches that stall ---------------------------------------------------------------

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
        // After 250 ms the simulated hand takes over.
        EXPECT_TRUE(gone < 60 || gone > 250 || rig.hand_state(0).servo.safety.output == vec3(0));
        there = true;
        place = {0.06, 0.04, -0.03};
        rig.run(500);
        rig.watch.expect_tame(jump_speed);
    }
}

/// The arm's thread goes on while the match stalls. If the backlog exceeds 250 ms, samples are skipped.
TEST_P(StressedHands, StayTameWhileTheMatchStalls) {
    for (const int stalled : {1, 5, 20, 50, 79, 120, 250, 700, 2000}) {
        SCOPED_TRACE(stalled);
        HandsRig rig({}, 1);
        auto servo = std::make_unique<input::ArmServo>();
        std::int64_t now_ns = 0;
        Tick t = 0;
        haptics::SafetyAudit audit;
        double strongest_late = 0;
        const auto limits = rig.match.haptic_setup().servos[0].limits;
        const auto step = [&] {
            const double x = shaken(++t, 0.2, 0.04);
            input::ArmReading reading{.time_ns = now_ns += 1'000'000};
            reading.position_um = {input::quantised(x * 1e6), 0, input::quantised(-x * 1e6)};
            const vec3 told = servo->step(reading);
            audit.record(limits, {.wanted = told}, told);
            return glm::length(told);
        };
        int behind = 0;
        std::uint16_t skips = 0;
        rig.before = [&](input::InputFrame& frame) {
            frame.devices[arm_device] = servo->take();
            frame.devices[0].skips = std::exchange(skips, std::uint16_t{0});
        };
        const auto run = [&](int ticks) {
            for (int i = 0; i < ticks; ++i) {
                if (behind > 0) {
                    --behind;
                } else {
                    step();
                }
                rig.run(1);
                if (fill_order(rig.match.world(), rig.match.haptic_setup(), 0, servo->order()))
                    servo->publish();
            }
        };
        // HandsRig::take and hang run ticks too, so the arm's thread must also run there.
        const auto inner = rig.before;
        rig.before = [&](input::InputFrame& frame) {
            if (behind > 0) {
                --behind;
            } else {
                step();
            }
            if (fill_order(rig.match.world(), rig.match.haptic_setup(), 0, servo->order())) servo->publish();
            inner(frame);
        };
        GetParam().begin(rig);
        rig.before = inner;
        run(300);
        for (int i = 1; i <= stalled; ++i) {
            const double force = step();
            if (i > 75) strongest_late = std::max(strongest_late, force);
        }
        EXPECT_EQ(strongest_late, 0) << "no force by a model that old";
        if (stalled > 250) {
            skips = static_cast<std::uint16_t>(stalled - 250);
            behind = 250;
        } else {
            behind = stalled;
        }
        run(1000);
        // The hand moves on for that long by an old model.
        rig.watch.expect_tame(0.2 * std::min(stalled, 80) / 30);
        EXPECT_EQ(audit.violations(haptics::SafetyRule::cap), 0U);
        EXPECT_EQ(audit.violations(haptics::SafetyRule::finite), 0U);
        EXPECT_EQ(servo->faults().differing, 0U);
    }
}

}  // namespace
}  // namespace thaum::game::test
