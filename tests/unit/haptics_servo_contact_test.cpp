// Tests of how the servo step treats surfaces and primitives: walls that appear, disappear and turn, and sets
// of primitives in balance.
#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

#include "core/random.h"
#include "tests/scenes/primitive_sets.h"
#include "unit/haptics_servo_rig.h"

namespace thaum::haptics::servo_tests {
namespace {

// ---- the servo at surfaces --------------------------------------------------------------------------------

SurfacePatch wall_below(double height) {
    SurfacePatch patch;
    patch.surfaces[0] = {.kind = SurfaceKind::plane, .a = {0, height, 0}, .b = {0, 1, 0}};
    patch.count = 1;
    patch.body_count = 1;
    patch.bodies[0].material.stiffness = 300;
    return patch;
}

constexpr double gap_newtons = 300 * surface_gap + 1e-9;

TEST(HapticsServo, APatchIsFeltAndItsEndIsASwitch) {
    Rig rig;
    rig.model.patch = wall_below(0);
    rig.sample.position = {0, 0.001, 0};
    rig.feel();
    for (int i = 0; i <= 20; ++i) {
        rig.sample.position.y = -1e-4 * i;
        EXPECT_NEAR(rig.feel().y, 300 * 1e-4 * i, gap_newtons) << i;
    }
    rig.model.patch = {};
    const double after = rig.feel().y;
    EXPECT_NEAR(after, 0.6 - rig.servo.limits.slew * tick_seconds, 1e-6) << "slowly";
    for (int tick = 0; tick < 100; ++tick) rig.feel();
    EXPECT_EQ(rig.feel(), vec3(0));
    // A new patch (the surfaces near the tip), whose bodies have nothing to do with those of the previous
    // patch.
    rig.model.patch = wall_below(0);
    ++rig.model.patch_number;
    rig.model.start = {0, 0.01, 0};
    EXPECT_EQ(rig.feel(), vec3(0)) << "the hand has pressed nothing into it yet";
    EXPECT_NEAR(rig.state.contact_offset.y, 0.002, 1e-6);
    rig.sample.position.y -= 1e-4;
    EXPECT_NEAR(rig.feel().y, 0.03, gap_newtons);
}

TEST(HapticsServo, AWallThatComesIsFeltButNotOneThatThePlayerWalksInto) {
    for (const bool walks : {false, true}) {
        Rig rig;
        rig.sample.position = {0, 0.001, 0};
        rig.model.patch = wall_below(0);
        rig.feel();
        rig.sample.position.y = -0.001;  // the hand presses 1 mm into the wall
        for (int tick = 0; tick < 20; ++tick) rig.feel();
        rig.model.patch.bodies[0].velocity = {0, 0.05, 0};
        if (walks) rig.model.frame_motion.velocity = {0, 0.05, 0};
        for (int tick = 1; tick <= 60; ++tick) {
            rig.model.patch.surfaces[0].a.y = 5e-5 * tick;
            const double expected = 300 * (0.001 + (walks ? 0 : 5e-5 * tick));
            EXPECT_NEAR(rig.feel().y, expected, gap_newtons) << tick;
        }
        // The player stands still again. The contact offset, which keeps the player's own walking from
        // pressing the hand into the wall, stays while the hand presses, and so does the force.
        rig.model.patch.bodies[0].velocity = {};
        rig.model.frame_motion = {};
        for (int tick = 0; tick < 600; ++tick)
            EXPECT_NEAR(rig.feel().y, walks ? 0.3 : 1.2, 60 * gap_newtons) << tick;
        // Once the hand is away from the wall, the contact offset decays, and the hand feels the wall at its
        // true position.
        if (!walks) continue;
        EXPECT_NEAR(rig.state.contact_offset.y, 0.003, 1e-6);
        rig.sample.position.y = 0.01;
        for (int tick = 0; tick < 5000; ++tick) EXPECT_EQ(rig.feel(), vec3(0));
        EXPECT_NEAR(rig.state.contact_offset.y, 0, 1e-9);
        rig.sample.position.y = 0.002;
        EXPECT_NEAR(rig.feel().y, 0.3, gap_newtons);
    }
}

/// A wall approaches a still hand. The force must be the same whether the servo gets a new model in every
/// tick or only in every fifth tick.
TEST(HapticsServo, ByAnOldModelAWallThatComesGoesOnComing) {
    Rig late, fresh;
    for (Rig* rig : {&late, &fresh}) {
        rig->model.patch = wall_below(-0.002);
        rig->model.patch.bodies[0].velocity = {0, 0.05, 0};
        rig->feel();
    }
    for (std::uint32_t tick = 1; tick <= 100; ++tick) {
        const double height = -0.002 + 5e-5 * tick;
        fresh.model.patch.surfaces[0].a.y = fresh.model.patch.bodies[0].position.y = height;
        late.sample.model_age = tick % 5;
        if (tick % 5 == 0) late.model.patch = fresh.model.patch;
        EXPECT_NEAR(late.feel().y, fresh.feel().y, 2 * gap_newtons) << tick;
    }
    EXPECT_NEAR(fresh.feel().y, 300 * 0.003, gap_newtons);
}

TEST(HapticsServo, ByAModelThatIsTooOldAWallStandsStill) {
    Rig rig;
    rig.model.patch = wall_below(-0.0005);
    rig.model.patch.bodies[0].velocity = {0, 0.05, 0};
    rig.feel();
    for (std::uint32_t age = 1; age <= 200; ++age) {
        rig.sample.model_age = age;
        EXPECT_LE(rig.feel().y, 300 * 0.0005 + gap_newtons) << age;
    }
}

TEST(HapticsServo, TurningTheViewPastAWallDoesNotKickTheHand) {
    Rig rig;
    rig.sample.position = {0.05, 0.001, 0};
    rig.model.patch = wall_below(0);
    rig.feel();
    double most = 0;
    // While the view turns by 60 degrees at 200 degrees per second, the wall approaches by 5 cm.
    for (int tick = 1; tick <= 300; ++tick) {
        const double turn = 0.0035;
        const vec3 normal = rotation({0, 0, 1}, turn * tick) * vec3(0, 1, 0);
        rig.model.patch.surfaces[0].b = normal;
        rig.model.patch.bodies[0].spin = {0, 0, turn / tick_seconds};
        rig.model.frame_motion.spin = {0, 0, turn / tick_seconds};
        most = std::max(most, glm::length(rig.feel()));
    }
    EXPECT_GT(glm::length(rig.state.contact_offset), 0.02);
    EXPECT_LT(most, 0.01);
}

TEST(HapticsServo, APatchThatIsNotThereCostsNoBit) {
    Rig with, without;
    with.model.tether = without.model.tether = {.stiffness = 100, .damping = 1};
    Random random{2};
    for (int tick = 0; tick < 200; ++tick) {
        const vec3 tip(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0);
        with.sample.position = without.sample.position = tip;
        with.model.patch = wall_below(-1);  // a wall 1 m away from the tip
        EXPECT_EQ(with.feel(), without.feel());
    }
    EXPECT_EQ(without.state.surface.begun, 0U);
}

// ---- the servo and haptic primitives ----------------------------------------------------------------------

PrimitiveSet primitives_of(std::initializer_list<Primitive> list) {
    PrimitiveSet set;
    for (const Primitive& p : list) EXPECT_EQ(set.add(p), PrimitiveFault::none);
    return set;
}
Primitive floor_plane(double strength) { return {PrimitiveKind::plane, {}, {0, 1, 0}, strength}; }

/// A rig whose tip has been at one place so long that the slew limit no longer acts.
Rig rig_at(vec3 position, const PrimitiveSet& set, double stiffness = 300, double damping = 0) {
    Rig rig;
    rig.model.primitives = set;
    rig.model.coupling = {stiffness, damping};
    rig.sample.position = position;
    for (int tick = 0; tick < 200; ++tick) rig.feel();
    return rig;
}

void expect_force(Rig& rig, vec3 force) {
    EXPECT_LT(glm::length(rig.feel() - force), 1e-12) << rig.state.safety.output.y;
    EXPECT_EQ(rig.cause(), SafetyCause::none);
}

TEST(HapticsServo, AStrongPlaneStopsTheHandWithStiffnessTimesDepth) {
    for (const double damping : {0.0, 2.0}) {
        Rig above = rig_at({0.01, 0.002, 0.03}, primitives_of({floor_plane(100)}), 300, damping);
        expect_force(above, {});
        EXPECT_LT(glm::length(above.state.proxy - vec3(0.01, 0.002, 0.03)), 1e-15);
        for (const double depth : {1e-6, 0.001, 0.005}) {
            // The hand rests, so the damper adds nothing.
            Rig pressed = rig_at({0.01, -depth, 0.03}, primitives_of({floor_plane(100)}), 300, damping);
            expect_force(pressed, {0, 300 * depth, 0});
            EXPECT_LT(glm::length(pressed.state.proxy - vec3(0.01, 0, 0.03)), 1e-12);
        }
    }
    // Pressed beyond its strength, the plane yields.
    Rig through = rig_at({0, -0.005, 0}, primitives_of({floor_plane(0.5)}));
    expect_force(through, {0, 0.5, 0});
}

TEST(HapticsServo, ADirectedForcePushesAndPointAndLinePull) {
    Rig directed = rig_at({0.01, 0, 0}, primitives_of({{PrimitiveKind::directed, {}, {0, 0, 1}, 0.4}}));
    expect_force(directed, {0, 0, 0.4});
    EXPECT_LT(glm::length(directed.state.proxy - vec3(0.01, 0, 0.4 / 300)), 1e-15);
    // The point attracts the tip within 2 mm.
    const auto point = primitives_of({{PrimitiveKind::point, {}, {}, 0.6}});
    Rig held = rig_at({0.001, 0, 0}, point), far = rig_at({0.03, 0, 0.04}, point);
    expect_force(held, {-0.3, 0, 0});
    expect_force(far, {-0.36, 0, -0.48});
    Rig line = rig_at({0.03, 5, 0.04}, primitives_of({{PrimitiveKind::line, {}, {0, 1, 0}, 0.6}}));
    expect_force(line, {-0.36, 0, -0.48});
}

TEST(HapticsServo, PrimitivesAndPulsesAdd) {
    Rig rig = rig_at({0, -0.001, 0}, primitives_of({floor_plane(100)}));
    const vec3 force = rig.feel_pulse({0.4, 0, 0}, 1);
    EXPECT_LT(glm::length(force - vec3(0.4 * 2 / pi, 0.3, 0)), 1e-12);
}

TEST(HapticsServo, ASetThatComesGoesOrJumpsIsASwitchAndOneThatGlidesIsNot) {
    Rig rig = rig_at({0, -0.005, 0}, {});
    const auto max_change = [&rig] {
        double most = 0;
        for (int tick = 0; tick < 100; ++tick) {
            const vec3 before = rig.state.safety.output;
            most = std::max(most, glm::length(rig.feel() - before));
        }
        return most;
    };
    const double slew = rig.servo.limits.slew * tick_seconds;
    const auto expect_walk_to = [&](double force) {
        EXPECT_NEAR(max_change(), slew, 1e-12);
        EXPECT_NEAR(rig.state.safety.output.y, force, 1e-12);
    };
    rig.model.primitives = primitives_of({floor_plane(100)});
    expect_walk_to(1.5);
    rig.model.primitives = primitives_of({floor_plane(100), {PrimitiveKind::directed, {}, {1, 0, 0}, 0.5}});
    expect_walk_to(1.5);
    EXPECT_NEAR(rig.state.safety.output.x, 0.5, 1e-12);
    rig.model.primitives = primitives_of({floor_plane(0.2), {PrimitiveKind::directed, {}, {0, 1, 0}, 0.1}});
    ++rig.model.set_number;
    expect_walk_to(0.3);
    rig.model.primitives.clear();
    expect_walk_to(0);
    EXPECT_EQ(rig.state.proxy, rig.sample.position);

    rig = rig_at({0, -0.001, 0}, primitives_of({floor_plane(100)}));
    rig.model.primitives = primitives_of({{PrimitiveKind::plane, {0, 0.001, 0}, {0, 1, 0}, 100}});
    expect_force(rig, {0, 0.6, 0});  // the force changed by 0.3 N in 1 ms, without delay
}

TEST(HapticsServo, APlaneCreatesNoMoreThanTheDelayOfATickDoes) {
    // If a spring's force is one tick late, its work on the hand is from 0 to stiffness / 2 times the sum of
    // |dx|^2, dx being the tip's motion in a tick. This follows from the convexity of the spring's energy.
    for (const double speed : {0.01, 0.05, 0.2}) {  // speed of the tip (m/s)
        for (const double strength : {100.0, 0.5}) {
            Rig rig = rig_at({0, 0.003, 0}, primitives_of({floor_plane(strength)}));
            double work = 0, bound = 0, most = 0;
            double direction = -1;
            while (direction < 0 || rig.sample.position.y < 0.003) {
                const vec3 force = rig.feel();
                if (rig.sample.position.y < -0.004) direction = 1;
                const vec3 moved(0.3 * speed * tick_seconds, direction * speed * tick_seconds, 0);
                rig.sample.position += moved;
                work += glm::dot(force, moved);
                most = std::max(most, force.y);
                bound += 300 / 2.0 * glm::dot(moved, moved);
            }
            EXPECT_NEAR(most, std::min(strength, 1.2), 0.065) << speed;
            EXPECT_GE(work, -1e-12) << speed;
            EXPECT_LE(work, bound) << speed;
            EXPECT_LE(work, 300 / 2.0 * 0.004 * 2.1 * speed * tick_seconds * 1.2) << speed;
        }
    }
}

TEST(HapticsServo, DampingTakesEnergyFromAHandThatPressesAPlane) {
    const auto work_of = [](double damping) {
        Rig rig = rig_at({0, 0.003, 0}, primitives_of({floor_plane(100)}), 300, damping);
        double work = 0;
        for (int tick = 0; tick < 1000; ++tick) {
            const vec3 force = rig.feel();
            const double y = -0.003 * std::cos(2 * pi * (tick + 1) / 250.0 - pi);
            work += force.y * (y - rig.sample.position.y);
            rig.sample.position.y = y;
        }
        return work;
    };
    EXPECT_LT(work_of(2), work_of(0) - 1e-4);
}

TEST(HapticsServo, ASetWithoutABalanceOrAPlaceGivesNoForceAndIsForgotten) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const ProxyCoupling coupling : {ProxyCoupling{0, 0}, ProxyCoupling{nan, 0}, ProxyCoupling{300, nan},
                                         ProxyCoupling{-1, 0}, ProxyCoupling{1e300, 1e300}}) {
        Rig rig =
            rig_at({0, -0.001, 0}, primitives_of({floor_plane(100)}), coupling.stiffness, coupling.damping);
        EXPECT_EQ(rig.feel(), vec3(0));
        rig.model.coupling = {300, 1};
        for (int tick = 0; tick < 50; ++tick) rig.feel();
        expect_force(rig, {0, 0.3, 0});
    }
    Rig rig = rig_at({0, -0.001, 0}, primitives_of({floor_plane(100)}), 300, 1);
    rig.sample.position.x = nan;
    EXPECT_EQ(rig.feel(), vec3(0));
    rig.sample.position.x = 0;
    for (int tick = 0; tick < 300; ++tick) EXPECT_TRUE(is_finite(rig.feel()));
    expect_force(rig, {0, 0.3, 0});
}

TEST(HapticsServo, HardSetsAreFeltWithinTheCapAndTheBudget) {
    Random random{12};
    Rig rig;
    for (int tick = 0; tick < 5000; ++tick) {
        if (tick % 10 == 0) rig.model.primitives = sets::random_case(random, 16, {1e6, 1e-9, 1}).set;
        rig.sample.position = sets::random_position(random, 1e-3);
        const vec3 force = rig.feel();
        ASSERT_TRUE(is_finite(force));
        ASSERT_LE(glm::length(force), 3.3);
        ASSERT_TRUE(is_finite(rig.state.proxy));
    }
}

}  // namespace
}  // namespace thaum::haptics::servo_tests
