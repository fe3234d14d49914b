// Hands on lift and swing under stress: poses that are none, teleports, hands that shake at 10 m/s, springs of 10^6 N/m, things that are
// wedged, held by both or gone, devices that vanish, a match that stalls. Whatever happens, forces stay finite and within the cap,
// energy bounded, things inside the walls, and nobody is flung about.
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

constexpr double wall = 20;            // m, from the court's middle to its walls
constexpr double fastest_wizard = 30;  // m/s; a fall of 12 m ends with 15
constexpr double most_created = 0.02;  // J, by passive sources
constexpr double most_given = 1.0;     // J, in about a second, by active ones
constexpr double jump_speed =
    0.1 / 0.03;  // m/s: 10 cm within a tick, against a force that is told only afterwards
constexpr std::uint32_t arm_device = 2;  // of player 0; 3: of player 1

/// What is watched in every tick, of every body and both hands.
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
            audits[p].record(match.touch().servos[p].limits, {.wanted = told}, told);
            strongest = std::max(strongest, glm::length(told));
            created = std::max(created, hand_state.servo.energy.most_created);
            given = std::max(given, hand_state.servo.energy.given);
            fastest = std::max(fastest, glm::length(world.get<Motion>(wizard).velocity));
            ASSERT_TRUE(is_finite(hand_state.device.position) && is_finite(hand_state.device.velocity));
        }
        world.view<const Prop, const Motion, const Body>().each(
            [&](const Prop&, const Motion& m, const Body& body) {
                energy = std::max(energy, body.mass * glm::dot(m.velocity, m.velocity) / 2);
            });
    }
    /// speed: m/s, of a hand that turns round within a tick. Its velocity is taken over 8 ms and so is wrong for that long, in which
    /// what should damp it drives it.
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

/// A court without props, two scripted wizards, of whom each may hold an arm.
struct Court {
    Simulation match;
    Watch watch{};
    input::InputFrame frame{};
    std::function<void(input::InputFrame&)> before{};  ///< what devices do in a tick
    std::uint64_t held_ticks = 0;

    explicit Court(std::vector<std::string> overrides = {}, int arms = 0)
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
    /// A thing, or with no mass a part of the court.
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
    void choose(std::uint32_t p, std::uint32_t wand) {
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
    /// Hangs over the pit.
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

/// An arm's sample of a tick that felt the newest model.
input::DeviceSample arm_sample(vec3 place) {
    input::DeviceSample sample;
    for (int axis = 0; axis < 3; ++axis)
        sample.counts[static_cast<std::size_t>(input::arm::position_x) + static_cast<std::size_t>(axis)] =
            input::quantised(place[axis] * 1e6);
    sample.model_age = 1;
    return sample;
}

/// To and fro at `speed` m/s over `width` m, about the middle.
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

/// Lift and swing alike.
struct StressedWand {
    const char* name;
    void (*begin)(Court&);
};
void begin_lift(Court& court) {
    court.box({1, 1, 1}, 20, {11, 0.5, 16});
    court.run(50);
    court.take(0, {11, 0.5, 16});
}
void begin_swing(Court& court) { court.hang(0); }
constexpr std::array stressed_wands{StressedWand{"lift", begin_lift}, StressedWand{"swing", begin_swing}};

class StressedHands : public testing::TestWithParam<StressedWand> {};
INSTANTIATE_TEST_SUITE_P(Each, StressedHands, testing::ValuesIn(stressed_wands),
                         [](const auto& tested) { return std::string(tested.param.name); });

// ---- poses ------------------------------------------------------------------------------------------------------------

TEST_P(StressedHands, OfAnArmWhosePosesAreAnything) {
    Court court({}, 1);
    Random random = random_stream(7, 1);
    bool wild = false;
    court.before = [&](input::InputFrame& frame) {
        auto& sample = frame.devices[arm_device];
        sample = arm_sample({0, 0, 0});
        if (!wild || random.below(3) != 0) return;
        for (auto& count : sample.counts) count = anything(random);
        sample.model_age = static_cast<std::uint16_t>(random.below(100));
        if (random.below(50) == 0) sample.skips = static_cast<std::uint16_t>(random.below(0x10000));
    };
    GetParam().begin(court);
    wild = true;
    for (int i = 0; i < 40; ++i) {
        court.run(200);
        court.release(0, Button::fire);
        court.run(20);
        court.hold(0, Button::fire);
    }
    court.watch.expect_tame();
    wild = false;
    court.release(0, Button::fire);
    court.run(500);
    EXPECT_LT(glm::length(court.hand_state(0).servo.safety.output), 0.1) << "and all is quiet again";
}

TEST_P(StressedHands, OfAnArmThatJumpsAcrossItsWorkspace) {
    Court court({}, 1);
    Random random = random_stream(8, 1);
    vec3 place{};
    court.before = [&](input::InputFrame& frame) { frame.devices[arm_device] = arm_sample(place); };
    GetParam().begin(court);
    for (int i = 0; i < 100; ++i) {
        place = {random.uniform(-0.08, 0.08), random.uniform(-0.06, 0.06), random.uniform(-0.035, 0.035)};
        court.run(1 + random.below(200));
    }
    court.watch.expect_tame(jump_speed);
    EXPECT_GT(court.held_ticks, 100U);
}

TEST_P(StressedHands, ThatShakeAtTenMetresASecond) {
    for (const double speed : {0.5, 3.9, 10.0}) {
        Court court({}, 1);
        Tick t = 0;
        bool shake = false;
        court.before = [&](input::InputFrame& frame) {
            const double x = shake ? shaken(++t, speed, 0.1) : 0;
            frame.devices[arm_device] = arm_sample({x, 0.5 * x, 0.7 * x});
        };
        GetParam().begin(court);
        shake = true;
        court.run(4000);
        court.watch.expect_tame(speed);
        EXPECT_GT(court.held_ticks, 40U);
    }
}

/// The simulated hand, by mouse and wheel.
TEST_P(StressedHands, OfAMouseThatDoesAnything) {
    Court court;
    Random random = random_stream(9, 1);
    GetParam().begin(court);
    court.hold(0, Button::clutch);
    court.before = [&](input::InputFrame& frame) {
        if (random.below(4) != 0) return;
        for (const auto count : {input::hand::look_right, input::hand::look_up, input::hand::wheel})
            frame.devices[0].counts[count] = anything(random);
    };
    for (int i = 0; i < 20; ++i) {
        court.run(300);
        court.release(0, Button::fire);
        court.run(20);
        court.hold(0, Button::fire);
    }
    court.watch.expect_tame();
}

// ---- stiffness --------------------------------------------------------------------------------------------------------

TEST(LiftStress, OfAnyStiffnessAndMassStaysBounded) {
    for (const double stiffness : {1.0, 4000.0, 1e5, 1e6}) {
        for (const double mass : {0.05, 5.0, 120.0}) {
            SCOPED_TRACE(text(stiffness, " N/m, ", mass, " kg"));
            Court court({text("lift.hold.stiffness_n_per_m=", stiffness)}, 1);
            Tick t = 0;
            bool shake = false;
            court.before = [&](input::InputFrame& frame) {
                frame.devices[arm_device] = arm_sample({shake ? shaken(++t, 0.4, 0.04) : 0, 0, 0});
            };
            court.box({1, 1, 1}, mass, {11, 0.5, 16});
            court.run(50);
            court.take(0, {11, 0.5, 16});
            shake = true;
            court.run(2500);
            court.watch.expect_tame(0.4);
            // No more than what a stretch of lost_m holds, or a thing that keeps up with its hand; and it falls.
            constexpr double lost = 2.5, hand = 20 * 0.4;
            const double most =
                std::max(stiffness * lost * lost / 2, mass * hand * hand * 2) + mass * 9.81 * 3;
            EXPECT_LT(court.watch.energy, most);
        }
    }
}

TEST(SwingStress, OfAnyStiffnessStaysBounded) {
    for (const double stiffness : {1.0, 4000.0, 1e5, 1e6}) {
        for (const double tension : {4000.0, 1e6}) {
            SCOPED_TRACE(text(stiffness, " N/m, ", tension, " N"));
            Court court({text("swing.rope.stiffness_n_per_m=", stiffness),
                         text("swing.rope.tension_max_n=", tension)},
                        1);
            Tick t = 0;
            bool shake = false;
            court.before = [&](input::InputFrame& frame) {
                frame.devices[arm_device] = arm_sample({0, 0, shake ? shaken(++t, 0.4, 0.04) : 0});
            };
            court.hang(0);
            shake = true;
            court.run(4000);
            court.watch.expect_tame();
        }
    }
}

// ---- what is held -----------------------------------------------------------------------------------------------------

/// Between two blocks that nobody moves and the wall, pulled every way.
TEST(LiftStress, AWedgedThingGoesThroughNothing) {
    for (const double stiffness : {4000.0, 1e6}) {
        SCOPED_TRACE(stiffness);
        Court court({text("lift.hold.stiffness_n_per_m=", stiffness), "lift.hold.lost_m=100"}, 1);
        Tick t = 0;
        bool pull = false;
        court.before = [&](input::InputFrame& frame) {
            const double x = pull ? shaken(++t, 0.05, 0.15) : 0;
            const double into = std::min(0.06, 1e-4 * static_cast<double>(t));
            frame.devices[arm_device] = arm_sample({x, 0.3 * x, -into});
        };
        court.place(0, {15, 0, 16}, {1, 0, 0});
        court.box({2, 3, 1}, 0, {18.9, 1.5, 14.95});
        court.box({2, 3, 1}, 0, {18.9, 1.5, 17.05});
        const auto thing = court.box({1, 1, 1}, 20, {19.4, 0.5, 16});
        court.run(100);
        court.take(0, {19.4, 0.5, 16});
        pull = true;
        for (int i = 0; i < 6000 && !HasFatalFailure(); ++i) {
            court.run(1);
            const vec3 at = court.match.world().get<Motion>(thing).position;
            ASSERT_LT(at.x, 19.6) << i;
            ASSERT_GT(at.y, 0.3) << i;
            // Not into the blocks; above them and before them it may go.
            const bool between = at.x > 18.4 && at.y < 3;
            ASSERT_TRUE(!between || std::abs(at.z - 16) < 0.25) << i;
        }
        court.watch.expect_tame();
        EXPECT_GT(court.held_ticks, 1000U);
    }
}

TEST(LiftStress, ToSlamAThingAgainstWallsDoesNotBringItThrough) {
    Court court({"lift.hold.lost_m=100"}, 1);
    Random random = random_stream(4, 4);
    vec3 place{};
    court.before = [&](input::InputFrame& frame) { frame.devices[arm_device] = arm_sample(place); };
    court.place(0, {16, 0, 16}, {1, 0, 0});
    court.box({0.3, 0.3, 0.3}, 5, {18, 0.15, 16});
    court.run(50);
    court.take(0, {18, 0.15, 16});
    for (int i = 0; i < 150; ++i) {
        place = {random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.3), random.uniform(-0.3, 0.1)};
        court.run(60);
    }
    court.watch.expect_tame();
    EXPECT_GT(court.held_ticks, 5000U) << "it was lost";
}

TEST(LiftStress, AThingHeldByBothIsTornAtByBoth) {
    Court court({}, 2);
    Tick t = 0;
    bool tear = false;
    court.before = [&](input::InputFrame& frame) {
        const double x = tear ? shaken(++t, 0.3, 0.1) : 0;
        frame.devices[arm_device] = arm_sample({x, 0, x});
        frame.devices[arm_device + 1] = arm_sample({x, 0.4 * x, -x});
    };
    court.place(1, {14, 0, 16}, {-1, 0, 0});
    court.box({1, 1, 1}, 20, {11, 0.5, 16});
    court.run(50);
    court.take(0, {11, 0.5, 16});
    court.take(1, {11, 0.5, 16});
    tear = true;
    court.run(3000);
    EXPECT_TRUE(court.busy(0) || court.busy(1)) << "both have lost it";
    court.release(0, Button::fire);
    court.run(500);
    court.watch.expect_tame();
    court.release(1, Button::fire);
    court.run(300);
    EXPECT_EQ(court.hand_state(0).servo.safety.output, vec3(0));
    EXPECT_EQ(court.hand_state(1).servo.safety.output, vec3(0));
}

TEST(LiftStress, WhatIsGoneIsHeldNoMore) {
    for (const int holders : {1, 2}) {
        Court court({}, 0);
        court.place(1, {14, 0, 16}, {-1, 0, 0});
        const auto thing = court.box({1, 1, 1}, 60, {11, 0.5, 16});
        court.run(50);
        court.take(0, {11, 0.5, 16});
        if (holders == 2) court.take(1, {11, 0.5, 16});
        court.run(300);
        EXPECT_GT(glm::length(court.hand_state(0).servo.safety.output), 0.1);
        court.match.world_to_change().destroy(thing);
        const auto other = court.box({1, 1, 1}, 60, {11, 0.5, 16});  // may get the same place in the store
        court.run(300);
        for (std::uint32_t p = 0; p < static_cast<std::uint32_t>(holders); ++p) {
            EXPECT_FALSE(court.busy(p));
            EXPECT_EQ(court.hand_state(p).servo.safety.output, vec3(0));
        }
        EXPECT_LT(glm::length(court.match.world().get<Motion>(other).velocity), 0.1);
        court.watch.expect_tame();
    }
}

TEST_P(StressedHands, OfWhoDiesLetGo) {
    Court court;
    GetParam().begin(court);
    court.run(200);
    court.match.world_to_change().get<Health>(court.wizard(0)).points = -5;
    court.run(50);
    EXPECT_TRUE(court.match.world().has<Dead>(court.wizard(0)));
    EXPECT_FALSE(court.busy(0));
    court.run(4000);
    EXPECT_FALSE(court.match.world().has<Dead>(court.wizard(0)));
    EXPECT_LT(glm::length(court.hand_state(0).servo.safety.output), 0.1);
    court.watch.expect_tame();
}

TEST(SwingStress, AnAnchorThatIsGoneStillHoldsOrLetsGo) {
    Court court;
    court.hang(0);
    court.run(200);
    std::vector<ecs::Entity> anchors;
    auto& world = court.match.world_to_change();
    world.view<const Anchor>().each([&](ecs::Entity e) { anchors.push_back(e); });
    EXPECT_FALSE(anchors.empty());
    for (const auto e : anchors) world.destroy(e);
    court.run(1500);
    court.release(0, Button::fire);
    court.run(1500);
    EXPECT_FALSE(court.busy(0));
    court.watch.expect_tame();
}

// ---- devices that vanish, matches that stall -------------------------------------------------------------------------

TEST_P(StressedHands, OfAnArmThatVanishesAndComesBackElsewhere) {
    for (const Tick gone : std::initializer_list<Tick>{1, 5, 19, 20, 60, 300, 3000}) {
        SCOPED_TRACE(gone);
        Court court({}, 1);
        bool there = true;
        vec3 place{};
        court.before = [&](input::InputFrame& frame) {
            frame.devices[arm_device] = there ? arm_sample(place) : input::DeviceSample{};
        };
        GetParam().begin(court);
        court.run(300);
        there = false;
        court.run(gone);
        // Later than that the simulated hand plays on.
        EXPECT_TRUE(gone < 60 || gone > 250 || court.hand_state(0).servo.safety.output == vec3(0));
        there = true;
        place = {0.06, 0.04, -0.03};
        court.run(500);
        court.watch.expect_tame(jump_speed);
    }
}

/// The arm's own thread goes on while the match stands still; beyond 250 ms of backlog samples are left out.
TEST_P(StressedHands, OfAnArmWhileTheMatchStalls) {
    for (const int stalled : {1, 5, 20, 50, 79, 120, 250, 700, 2000}) {
        SCOPED_TRACE(stalled);
        Court court({}, 1);
        auto servo = std::make_unique<input::ArmServo>();
        std::int64_t now_ns = 0;
        Tick t = 0;
        haptics::SafetyAudit audit;
        double strongest_late = 0;
        const auto limits = court.match.touch().servos[0].limits;
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
        court.before = [&](input::InputFrame& frame) {
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
                court.run(1);
                if (fill_order(court.match.world(), court.match.touch(), 0, servo->order())) servo->publish();
            }
        };
        // What Court::take and hang do, with the arm's thread beside.
        const auto inner = court.before;
        court.before = [&](input::InputFrame& frame) {
            if (behind > 0) {
                --behind;
            } else {
                step();
            }
            if (fill_order(court.match.world(), court.match.touch(), 0, servo->order())) servo->publish();
            inner(frame);
        };
        GetParam().begin(court);
        court.before = inner;
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
        court.watch.expect_tame(0.2 * std::min(stalled, 80) / 30);  // what the hand does by an old model
        EXPECT_EQ(audit.violations(haptics::SafetyRule::cap), 0U);
        EXPECT_EQ(audit.violations(haptics::SafetyRule::finite), 0U);
        EXPECT_EQ(servo->troubles().differing, 0U);
    }
}

}  // namespace
}  // namespace thaum::game::test
