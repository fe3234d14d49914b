// Tests of the virtual coupling: frames, signs and bookkeeping of displacements.
#include "haptics/coupling.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace thaum::haptics {
namespace {

/// A device that lies on its side and is mirrored. It has no symmetry that could hide a wrong transpose.
CouplingFrame crooked() {
    CouplingFrame f;
    f.player_to_world = glm::mat3_cast(rotation(glm::normalize(vec3(1, 2, 3)), 1.1));
    f.device_to_player = glm::mat3_cast(rotation(glm::normalize(vec3(-2, 1, 0.5)), 0.8)) *
                         mat3(vec3(0, 1, 0), vec3(0, 0, 1), vec3(-1, 0, 0));
    f.metres_per_metre = 20;
    f.newtons_per_newton = 0.00375;
    f.player = {4, 1, -7};
    f.taken_object = {0.2, -0.3, -2.5};
    f.taken_device = {0.01, 0.02, -0.03};
    return f;
}

/// Force on the object after the hand has moved by `moved` (m, device frame) since the object was grasped.
vec3 pull(const CouplingFrame& f, const Coupling& c, vec3 moved) {
    const vec3 object = interface_point(f, f.taken_device);
    // The step is so short that its mean force equals the force at its start.
    const auto step = coupling_step(c, 1 / 5.0, 0, 1e-9);
    return couple(step, {.hand = interface_point(f, f.taken_device + moved), .object = object}).mean_force;
}

/// Force on the hand (N) that belongs to a force on the object: reversed, rotated from the world to the
/// device and scaled, F_device = -s_f R_d^T R_g^T F_world.
vec3 felt_by_hand(const CouplingFrame& f, vec3 force) { return -f.newtons_per_newton * to_device(f, force); }

constexpr Coupling lift{.stiffness = 4000, .damping = 40, .drag = 0};

TEST(HapticsCoupling, NothingPullsWhenTaken) {
    const auto f = crooked();
    EXPECT_EQ(pull(f, lift, vec3(0)), vec3(0));
    const vec3 there = f.player + f.player_to_world * f.taken_object;
    EXPECT_LE(glm::length(interface_point(f, f.taken_device) - there), 1e-12);
}

TEST(HapticsCoupling, AHandThatMovesRightPullsRightAndIsPulledBackLeft) {
    auto f = crooked();
    const vec3 right_of_player = f.player_to_world * vec3(1, 0, 0);
    // The player's right in the device frame (unit).
    const vec3 right_of_device = glm::transpose(f.device_to_player) * vec3(1, 0, 0);
    const vec3 force = pull(f, lift, 0.01 * right_of_device);
    EXPECT_NEAR(glm::dot(glm::normalize(force), right_of_player), 1, 1e-9);
    const vec3 felt = felt_by_hand(f, force);
    EXPECT_NEAR(glm::dot(glm::normalize(felt), right_of_device), -1, 1e-9);
}

TEST(HapticsCoupling, AnyMoveIsResistedWithTheFeltStiffness) {
    const auto f = crooked();
    Random random{7};
    for (int i = 0; i < 100; ++i) {
        const vec3 moved{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05),
                         random.uniform(-0.05, 0.05)};
        const vec3 felt = felt_by_hand(f, pull(f, lift, moved));
        EXPECT_LE(glm::length(felt + felt_stiffness(f, lift.stiffness) * moved), 1e-6 * glm::length(felt));
    }
    EXPECT_NEAR(felt_stiffness(f, lift.stiffness), 300,
                1e-9);  // 4,000 N/m in the world are felt as 300 N/m
}

TEST(HapticsCoupling, PowerScalesByTheTwoScales) {
    const auto f = crooked();
    const vec3 hand_velocity{0.1, -0.2, 0.05}, force{300, 20, -70};
    const vec3 in_a_tick = interface_point(f, 1e-3 * hand_velocity) - interface_point(f, {});
    const double in_world = glm::dot(force, in_a_tick / 1e-3);
    const double at_hand = -glm::dot(felt_by_hand(f, force), hand_velocity);
    EXPECT_NEAR(at_hand, in_world * f.newtons_per_newton / f.metres_per_metre, 1e-9);
}

TEST(HapticsCoupling, AWalkingPlayerCarriesTheInterfacePointAlong) {
    const auto f = crooked();
    const vec3 walk{3, 0, 1};
    auto moved = f;
    moved.player += walk;
    const vec3 change = interface_point(moved, f.taken_device) - interface_point(f, f.taken_device);
    EXPECT_LE(glm::length(change - walk), 1e-12);
}

TEST(HapticsCoupling, ImpulseIsMassTimesVelocityChangeAndOppositeForTheHand) {
    const auto step = coupling_step(lift, 1 / 5.0, 1 / 0.3, 8e-3);
    const CouplingState s{
        .hand = {0.1, 0.2, -0.1}, .hand_velocity = {1, 0, 2}, .object_velocity = {0, -1, 0}};
    const auto r = couple(step, s);
    EXPECT_LE(glm::length(r.impulse - 5.0 * r.velocity_change), 1e-12);
    EXPECT_LE(glm::length(r.mean_force * 8e-3 - r.impulse), 1e-12);
    EXPECT_EQ(r.drag_impulse, vec3(0));
}

TEST(HapticsCoupling, WhatNothingMovesStillPulls) {
    const auto step = coupling_step({1000, 10, 0}, 0, 0, 1e-3);
    const auto r = couple(step, {.hand = {0.01, 0, 0}, .hand_velocity = {1, 0, 0}});
    EXPECT_EQ(r.velocity_change, vec3(0));
    EXPECT_EQ(r.displacement, vec3(0));
    // The mean force of a spring whose stretch grows evenly.
    EXPECT_NEAR(r.mean_force.x, 1000 * (0.01 + 0.5e-3) + 10, 1e-9);
}

}  // namespace
}  // namespace thaum::haptics
