// A resting hand must feel a constant force: at a fixed reading in a constant field, the force changes by at
// most 1 mN per tick after 300 ticks, in every haptic mode, in every field, and with every curve of strength
// over the field's value. A hand that creeps or trembles must feel no chatter. A moving hand and a moving
// field must still be felt at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "field/analytic.h"
#include "haptics/modes.h"
#include "haptics/servo.h"
#include "haptics/volume/volume_feel.h"

namespace thaum::haptics {
namespace {

using field::field_of;
using field::Scalar;
using field::Vector;

constexpr double max_change = 1e-3;  // largest change of a resting hand's force (N per tick)

/// Speed of a flow, with its gradient, which has a ridge around each vortex.
struct Speed {
    field::VortexFlow flow{};

    Scalar operator()(vec3 place) const {
        const Vector here = flow(place);
        const double speed = glm::length(here.value);
        vec3 slope(0);
        for (int i = 0; i < 3; ++i)
            slope += here.value[i] / speed * here.gradient[static_cast<std::size_t>(i)];
        return {speed, slope};
    }
};

/// A servo with a tip that feels haptic modes.
struct FeltModes {
    std::vector<ModeUse> uses{};
    Servo servo{};
    ServoState state{};
    HapticModel model{};
    vec3 force{};   ///< force of the spring, before the safety stage (N)
    vec3 output{};  ///< force that the hand feels, if the servo has limits (N)

    FeltModes(std::vector<ModeUse> modes, double stiffness, double damping = 0) : uses(std::move(modes)) {
        model.set_number = 1;
        model.coupling = {stiffness, damping};
    }

    /// Runs one tick. Returns the change of the force (N).
    double feel(vec3 tip) {
        model.primitives.clear();
        add_modes(uses, {state.primitives == 0 ? tip : state.proxy, tip, {}, model.coupling.stiffness},
                  model.primitives);
        output = servo_step(servo, state, model, {tip, 0});
        const vec3 before = force;
        force = model.coupling.stiffness * (state.proxy - tip);
        return glm::distance(force, before);
    }

    /// Moves the tip to a position in 40 ticks and lets it rest there. Returns the largest change of force
    /// after 300 ticks of rest (N).
    double rest_at(vec3 place, vec3 from) {
        for (int tick = 0; tick < 40; ++tick) feel(glm::mix(from, place, tick / 40.0));
        for (int tick = 0; tick < 300; ++tick) feel(place);
        double largest = 0;
        for (int tick = 0; tick < 60; ++tick) largest = std::max(largest, feel(place));
        return largest;
    }
};

vec3 random_place(Random& random, double half) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    return {x, y, random.uniform(-half, half)};
}

/// A random curve of a mode's strength (N) over the value of its field, with jumps and either sign.
field::TransferFunction random_curve(Random& random, double from, double to) {
    std::array<vec2, 8> points{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t place = i / 2;  // two points at each x make a jump of the curve
        points[i] = {from + (to - from) * static_cast<double>(place) / 3, random.uniform(-3, 3)};
    }
    return field::transfer_function(points).value_or(field::constant(1));
}

ModeUse random_use(Random& random, const Mode& mode, const Speed& speed) {
    ModeUse use{&mode, any_field(field_of<Scalar>(speed)), {}};
    if (mode.reads == FieldKind::vector) use.field = any_field(field_of<Vector>(speed.flow));
    const double most = mode.slope ? 80 : mode.reads == FieldKind::vector && mode.derivatives ? 60 : 1.5;
    use.settings.strength =
        random.below(3) == 0 ? field::constant(random.uniform(-3, 3)) : random_curve(random, 0, most);
    use.settings.friction = field::constant(random.uniform());
    use.settings.level = random.uniform(0.2, 0.8);
    use.settings.magnet = random.uniform();
    use.settings.reach = random.uniform(0.001, 0.01);
    return use;
}

TEST(StillHand, FeelsAStillForceInEveryMode) {
    Random random{11};
    for (const Mode& mode : modes()) {
        for (int i = 0; i < 40; ++i) {
            const Speed speed{field::make_vortex_flow(0.2, random.next())};
            FeltModes hand({random_use(random, mode, speed)}, 50 * std::pow(60, random.uniform()),
                           random.below(2) == 0 ? 0 : 1.5);
            const vec3 place = random_place(random, 0.07);
            EXPECT_LE(hand.rest_at(place, place + random_place(random, 0.01)), max_change) << mode.name;
        }
    }
}

TEST(StillHand, FeelsAStillForceInModesTogether) {
    Random random{12};
    for (int i = 0; i < 100; ++i) {
        const Speed speed{field::make_vortex_flow(0.2, random.next())};
        std::vector<ModeUse> uses;
        for (int k = 0; k < 3; ++k) {
            const auto number = random.below(static_cast<std::uint32_t>(modes().size()));
            uses.push_back(random_use(random, modes()[number], speed));
        }
        FeltModes hand(std::move(uses), 50 * std::pow(60, random.uniform()));
        const vec3 place = random_place(random, 0.07);
        EXPECT_LE(hand.rest_at(place, place + random_place(random, 0.01)), max_change) << i;
    }
}

/// Values that increase towards the plane y = 0 from both sides.
Scalar ridge(vec3 place) { return {-std::abs(place.y), {0, place.y > 0 ? -1.0 : 1.0, 0}}; }

TEST(StillHand, IsHeldOnARidgeWithTheForceThatTheSpringHasThere) {
    const auto slope = &ridge;
    FeltModes hand({{find_mode("gradient"), any_field(field_of<Scalar>(slope)), {}}}, 300);
    hand.uses[0].settings.strength = field::constant(1.4);
    EXPECT_LE(hand.rest_at({0, 0.002, 0}, {0, 0.02, 0}), max_change);
    EXPECT_NEAR(hand.force.y, -300 * 0.002, 0.002) << "it rests on the ridge";
    // Along the ridge at 20 mm/s, the force must not change by more than twice the spring's change in a tick.
    double largest = 0;
    for (int tick = 0; tick < 500; ++tick) largest = std::max(largest, hand.feel({2e-5 * tick, 0.002, 0}));
    EXPECT_LE(largest, 2 * 300 * 2e-5 + 2e-3);
    // Beside the ridge, the mode's full strength must act at once.
    for (int tick = 0; tick < 100; ++tick) hand.feel({0.01, 0.002 + 1e-4 * tick, 0});
    EXPECT_NEAR(hand.force.y, -1.4, 1e-9);
}

/// Displacement along x of a hand that creeps or trembles (m), as a function of time (s).
using Motion = double (*)(double seconds);

double tremor(double most, double frequency, double seconds) {
    return most * det::sin(2 * pi * frequency * seconds);
}

TEST(StillHand, AHandThatCreepsOrTremblesInTheCoreOfAVortexFeelsNoChatter) {
    const field::RankineVortex vortex{.radius = 0.01};
    const std::array<Motion, 5> motions{
        [](double t) { return 0.0005 * t; }, [](double t) { return 0.005 * t; },
        [](double t) { return tremor(1e-4, 8, t); }, [](double t) { return tremor(3e-4, 12, t); },
        [](double t) { return 0.002 * t + tremor(1e-4, 10, t); }};
    Random random{13};
    for (int i = 0; i < 10; ++i) {
        const vec3 place = random_place(random, 0.004);
        for (const Motion& motion : motions) {
            FeltModes hand({{find_mode("force"), any_field(field_of<Vector>(vortex)), {}}}, 300);
            hand.uses[0].settings.strength = field::constant(2);
            double largest = 0, before = 0;
            for (int tick = 0; tick < 1200; ++tick) {
                const double along = motion(std::max(0, tick - 300) * tick_seconds);
                const double change = hand.feel(place + vec3(along, 0, 0));
                if (tick > 600) largest = std::max(largest, change - 300 * std::abs(along - before));
                before = along;
            }
            EXPECT_LE(largest, 0.1) << "place " << i << ", motion " << &motion - motions.data();
        }
    }
}

/// A hand that feels modes through spring and damper, with a device that renders every force.
struct FeltChange {
    FeltModes hand;
    std::array<vec3, velocity_window + 1> tips{};  ///< positions of the tip, the newest first
    vec3 velocity{};

    FeltChange(std::vector<ModeUse> modes, double stiffness, double damping)
        : hand(std::move(modes), stiffness, damping) {
        hand.servo = servo_of({.peak_force = 100, .continuous_force = 100}, 1);
    }

    /// Runs one tick. Returns the change of the force, without the part due to the hand's motion (N).
    double feel(vec3 tip) {
        if (hand.state.samples == 0) tips.fill(tip);
        const vec3 before = hand.output, velocity_before = velocity;
        hand.feel(tip);
        std::shift_right(tips.begin(), tips.end(), 1);
        tips[0] = tip;
        velocity = (tips.front() - tips.back()) / (velocity_window * tick_seconds);
        const ProxyCoupling& coupling = hand.model.coupling;
        return glm::distance(hand.output, before) - coupling.stiffness * glm::distance(tips[1], tip) -
               coupling.damping * glm::distance(velocity, velocity_before);
    }
};

TEST(StillHand, AHandThatCreepsOrTremblesInSeveralModesFeelsNoChatter) {
    const std::array<Motion, 3> motions{[](double t) { return 0.005 * t; },
                                        [](double t) { return tremor(3e-4, 12, t); },
                                        [](double t) { return tremor(1e-3, 9, t); }};
    Random random{15};
    for (int i = 0; i < 40; ++i) {
        const Speed speed{field::make_vortex_flow(0.2, random.next())};
        std::vector<ModeUse> uses;
        for (std::uint32_t k = 0; k < 2 + random.below(3); ++k) {
            const auto number = random.below(static_cast<std::uint32_t>(modes().size()));
            uses.push_back(random_use(random, modes()[number], speed));
        }
        const double stiffness = 50 * std::pow(100, random.uniform());
        FeltChange hand(std::move(uses), stiffness, random.below(2) == 0 ? 0 : stiffness / 330);
        const vec3 place = random_place(random, 0.05);
        const Motion motion = motions[static_cast<std::size_t>(i) % motions.size()];
        double largest = 0;
        for (int tick = 0; tick < 1200; ++tick) {
            const double change =
                hand.feel(place + vec3(motion(std::max(0, tick - 300) * tick_seconds), 0, 0));
            if (tick > 320) largest = std::max(largest, change);
        }
        EXPECT_LE(largest, 0.1) << "set " << i;
    }
}

TEST(StillHand, ADamperMakesNoJumpOfAWallThatIsMet) {
    const field::Plane ground{.through = {}, .normal = {0, 1, 0}};
    // An omega.3 (a haptic device) has a stiffness of 5,000 N/m and a damping of 15 N s/m in the lab.
    for (const double speed : {0.03, 0.1, 0.3}) {
        FeltChange felt({{find_mode("isosurface"), any_field(field_of<Scalar>(ground)), {}}}, 5000, 15);
        felt.hand.uses[0].settings.strength = field::constant(9);
        double largest = 0;
        for (int tick = 0; tick < 150; ++tick) {  // the hand moves in by 1 mm
            const double y = std::max(speed * tick_seconds * (70.4 - tick), -0.001);
            const double change = felt.feel({0, y, 0});
            if (tick > 20) largest = std::max(largest, change);
            if (y < 0) EXPECT_NEAR(felt.hand.state.proxy.y, 0, 2e-5) << "the wall holds the proxy";
        }
        EXPECT_LE(largest, 0.1) << speed;
        EXPECT_NEAR(felt.hand.output.y, 5, 1e-9) << speed;
    }
}

TEST(StillHand, AFieldThatMovesByNextToNothingFreesNoChatter) {
    const field::RankineVortex vortex{.radius = 0.01};
    FeltModes hand({{find_mode("force"), any_field(field_of<Vector>(vortex)), {}}}, 300);
    hand.uses[0].settings.strength = field::constant(2);
    hand.model.field_motion = 1e-9;
    EXPECT_LE(hand.rest_at({0.002, 0, 0.001}, {0.01, 0, 0}), max_change);
}

TEST(StillHand, AHandAtUsualSpeedFeelsTheForceThatAModeHasThere) {
    Random random{14};
    double error = 0, felt = 0;
    for (int i = 0; i < 12; ++i) {
        const Speed speed{field::make_vortex_flow(0.2, random.next())};
        const auto feel_force = [&] {
            FeltModes hand({{find_mode("force"), any_field(field_of<Vector>(speed.flow)), {}}}, 300);
            hand.uses[0].settings.strength = field::transfer_function(std::array<vec2, 2>{{{0, 0}, {1, 0.8}}})
                                                 .value_or(field::constant(0));
            return hand;
        };
        FeltModes settles = feel_force(), jumps = feel_force();
        const vec3 place = random_place(random, 0.05);
        for (int tick = 0; tick < 1000; ++tick) {  // the hand moves on a circle of 20 mm at 100 mm/s
            const double angle = 5 * tick * tick_seconds;
            const vec3 tip = place + 0.02 * vec3(det::cos(angle), det::sin(angle), 0);
            settles.feel(tip);
            jumps.state.settling = {};
            jumps.feel(tip);
            error += glm::distance(settles.force, jumps.force);
            felt += glm::length(jumps.force);
        }
    }
    EXPECT_LE(error, 0.005 * felt);
    EXPECT_GE(felt, 1000);
}

/// A wall 1 mm thick around the plane y = 0.
Scalar thin_wall(vec3 place) { return {5e-4 - std::abs(place.y), {0, place.y > 0 ? -1.0 : 1.0, 0}}; }

TEST(StillHand, AWallThinnerThanItsReachLetsGoWithoutAJump) {
    const auto wall = &thin_wall;
    FeltModes hand({{find_mode("isosurface"), any_field(field_of<Scalar>(wall)), {}}}, 5000);
    hand.uses[0].settings.strength = field::constant(9);
    hand.uses[0].settings.reach = 0.004;
    double before = 0, pressed = 0;
    for (int tick = 0; tick < 4000; ++tick) {  // the tip moves through the wall and back, at 5 mm/s
        const double y = 0.005 - 5e-6 * std::min(tick, 4000 - tick);
        const double change = hand.feel({0, y, 0});
        if (tick > 20) EXPECT_LE(change, 0.5 + 3 * 5000 * std::abs(y - before) + 1e-9) << tick;
        pressed = std::max(pressed, std::abs(hand.force.y));
        before = y;
    }
    EXPECT_NEAR(pressed, 9, 0.1) << "it holds up to its strength";
    EXPECT_LE(glm::length(hand.force), 1e-9);
}

TEST(StillHand, AMovingHandMeetsAWallAtOnceAndGetsThroughAtOnce) {
    const field::Plane ground{.through = {}, .normal = {0, 1, 0}};
    FeltModes hand({{find_mode("isosurface"), any_field(field_of<Scalar>(ground)), {}}}, 300);
    hand.uses[0].settings.strength = field::constant(0.6);
    for (int tick = 0; tick < 400; ++tick) hand.feel({0, 0.001, 0});
    double y = 0.001;
    for (int tick = 0; tick < 2; ++tick) hand.feel({0, y -= 5e-4, 0});
    for (; y > -0.0019; y -= 1e-4) hand.feel({0, y, 0});
    EXPECT_NEAR(hand.force.y, -300 * (y + 1e-4), 1e-3);
    // The wall gives way at 0.6 N: the proxy sinks in, and is free once it is deeper than the mode's reach.
    int ticks = 0;
    for (; ticks < 100 && (ticks < 5 || hand.force.y > 1e-6); ++ticks) hand.feel({0, y -= 1e-4, 0});
    EXPECT_LE(ticks, 40);
}

TEST(StillHand, FeelsAFieldThatMovesIntoIt) {
    field::Plane ground{.through = {0, -0.001, 0}, .normal = {0, 1, 0}};
    FeltModes hand({{find_mode("isosurface"), any_field(field_of<Scalar>(ground)), {}}}, 300);
    hand.uses[0].settings.strength = field::constant(5);
    for (int tick = 0; tick < 500; ++tick) hand.feel(vec3(0));
    EXPECT_LE(glm::length(hand.force), 1e-12);
    hand.model.field_motion = 2e-5;
    for (int tick = 0; tick < 300; ++tick) {
        ground.through.y += 2e-5;
        hand.feel(vec3(0));
    }
    EXPECT_NEAR(hand.force.y, 300 * 0.005, 300 * 4e-5);
}

TEST(StillHand, AProxyInAGlidingSetOfItsOwnDoesNotSettle) {
    ServoState state;
    HapticModel model;
    model.coupling = {300, 0};
    for (int tick = 0; tick < 600; ++tick) {
        model.primitives.clear();
        model.primitives.add({PrimitiveKind::plane, {0, 1e-5 * tick, 0}, {0, 1, 0}, 100});
        servo_step({}, state, model, {vec3(0), 0});
        EXPECT_NEAR(state.proxy.y, 1e-5 * tick, 1e-15);
    }
}

TEST(Settling, TakesTheWholeWayUnlessItTurnsBackAndCalmsDownAtRest) {
    Settling state;
    const auto go = [&](vec3 from, vec3 balance, double motion = 0) {
        return settle(state, {from, balance, {}, {{}, 300}, 300, motion});
    };
    EXPECT_EQ(go({}, {0.01, 0, 0}), vec3(0.01, 0, 0));
    EXPECT_EQ(go({0.01, 0, 0}, {0.012, 0, 0}), vec3(0.012, 0, 0));
    EXPECT_LE(go({0.012, 0, 0}, {}).x, 0.012 - 0.001);
    EXPECT_GT(go({0.011, 0, 0}, {}).x, 0);
    // The position that balances all forces jumps at random. While the hand rests, the proxy, which follows
    // that position, must move less and less.
    Random random{3};
    vec3 proxy(0);
    for (int tick = 0; tick < 600; ++tick) {
        const vec3 before = proxy;
        proxy = go(before, random_place(random, 1e3));
        if (tick > 300) EXPECT_LE(300 * glm::distance(proxy, before), min_pace * (1 + 1e-9));
    }
    // Positions that are huge or tiny, and impossible motions, must do no harm.
    for (const double far : {1e6, 1e-300, 0.0}) EXPECT_TRUE(is_finite(go({}, vec3(far))));
    for (const double motion : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_TRUE(is_finite(go({}, {0.01, 0, 0}, motion)));
        EXPECT_TRUE(std::isfinite(go({}, {}).x + state.pace + state.bound));
    }
}

}  // namespace
}  // namespace thaum::haptics
