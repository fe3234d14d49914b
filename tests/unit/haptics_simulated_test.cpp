// Tests of the simulated device: input, output, and dry friction at rest.
#include "haptics/simulated.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/random.h"
#include "unit/haptics_rig.h"

namespace thaum::haptics {
namespace {

TEST(HapticsSimulated, MeasuresWholeQuanta) {
    auto spec = reference_spec();
    spec.position_quantum = 5.5e-5;
    const auto device = simulated_device(spec, no_hand);
    EXPECT_EQ(measured_position(device, resting_at({2.7e-5, -2.7e-5, 1.0 * 5.5e-5})), vec3(0, 0, 5.5e-5));
    EXPECT_EQ(measured_position(device, resting_at({2.8e-5, -2.8e-5, 0})), vec3(5.5e-5, -5.5e-5, 0));
    Random random{1};
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(-0.1, 0.1);
        const double measured = measured_position(device, resting_at(vec3(x))).x;
        EXPECT_LE(std::abs(measured - x), 5.5e-5 / 2 * (1 + 1e-9));
        EXPECT_NEAR(measured / 5.5e-5, std::round(measured / 5.5e-5), 1e-9);
    }
    spec.position_quantum = 0;
    EXPECT_EQ(measured_position(simulated_device(spec, no_hand), resting_at(vec3(pi))).x, pi);
}

TEST(HapticsSimulated, ForcesActAfterTheLatency) {
    for (int latency = 0; latency <= max_latency; ++latency) {
        auto spec = reference_spec();
        spec.latency = latency;
        const auto device = simulated_device(spec, no_hand);
        auto state = resting_at({});
        for (int tick = 0; tick < 20; ++tick) {
            state = step(device, state, {}, vec3(0, tick + 1, 0));
            EXPECT_EQ(state.force.y, std::max(0, tick + 1 - latency)) << latency << " at " << tick;
            EXPECT_EQ(state.velocity.y > 0, tick >= latency);
        }
    }
}

TEST(HapticsSimulated, ForcesSaturateInLengthAndKeepTheirDirection) {
    auto spec = reference_spec();
    spec.peak_force = 3.3;
    const auto device = simulated_device(spec, no_hand);
    const auto acting = [&device](vec3 force) { return step(device, resting_at({}), {}, force).force; };
    EXPECT_EQ(acting({1, -2, 0.5}), vec3(1, -2, 0.5));
    for (const double size : {4.0, 1e3, 1e200, 1e308}) {
        const vec3 force = acting(size * vec3(0.6, 0, -0.8));
        EXPECT_NEAR(glm::length(force), 3.3, 1e-12);
        EXPECT_NEAR(force.x / force.z, -0.75, 1e-12);
    }
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {inf, -inf, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(acting({1, bad, 0}), vec3(0));
}

TEST(HapticsSimulated, TheHandFollowsItsTargetNotFasterThanItCan) {
    auto spec = reference_spec();
    spec.workspace = {0.4, 0.3, 0.2};
    const auto device = simulated_device(spec, {.max_target_speed = 2});
    auto state = step(device, resting_at({}), {0.1, 0, 0}, {});
    EXPECT_NEAR(state.target.x, 0.002, 1e-15);
    for (int i = 0; i < 60; ++i) state = step(device, state, {0.1, 0, 0}, {});
    EXPECT_NEAR(state.target.x, 0.1, 1e-15);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(step(device, state, {nan, 0, 0}, {}).target, state.target);
    for (int i = 0; i < 10'000; ++i) state = step(device, state, vec3(1e300), {});
    EXPECT_LE(glm::length(state.target - device.reach), 1e-12);  // the target stays in the workspace
}

TEST(HapticsSimulated, TheEndStopsHoldAndDoNotBounce) {
    auto spec = reference_spec();
    spec.workspace = {0.1, 0.1, 0.1};
    const auto device = simulated_device(spec, no_hand);
    auto state = resting_at({});
    for (int i = 0; i < 500; ++i) state = step(device, state, {}, {2, 0, 0});
    EXPECT_EQ(state.position.x, 0.05);
    EXPECT_EQ(state.velocity.x, 0);
    state = step(device, state, {}, {-2, 0, 0});
    EXPECT_LT(state.position.x, 0.05);  // the device moves on and does not stick
}

TEST(HapticsSimulated, FrictionHoldsUpToItsLimitAndNotBeyond) {
    auto spec = reference_spec();
    spec.coulomb_friction = 0.26;
    const auto device = simulated_device(spec, no_hand);
    for (const double force : {0.0, 0.1, -0.2599999, 0.26}) {
        auto state = resting_at({});
        for (int i = 0; i < 1000; ++i) state = step(device, state, {}, {force, 0, 0});
        EXPECT_EQ(state.position.x, 0) << force;
        EXPECT_EQ(state.velocity.x, 0);
    }
    for (const double force : {0.2600001, -0.27}) {
        auto state = resting_at({});
        for (int i = 0; i < 1000; ++i) state = step(device, state, {}, {force, 0, 0});
        EXPECT_GT(state.position.x * force, 0) << force;
    }
}

TEST(HapticsSimulated, AHeldDeviceRestsAnywhereInTheBandOfItsFriction) {
    auto spec = reference_spec();
    spec.coulomb_friction = 0.26;
    const Hand hand;
    const auto device = simulated_device(spec, hand);
    const double band = spec.coulomb_friction / hand.stiffness;
    Random random{3};
    for (int i = 0; i < 200; ++i) {
        auto state = resting_at({});
        state.position.x = random.uniform(-0.05, 0.05);
        state.velocity.x = random.uniform(-1, 1);
        for (int t = 0; t < 2000; ++t) state = step(device, state, {}, {});
        EXPECT_EQ(state.velocity.x, 0);
        EXPECT_LE(std::abs(state.position.x), band * (1 + 1e-12));
        const double there = state.position.x;
        for (int t = 0; t < 1000; ++t) state = step(device, state, {}, {});
        EXPECT_EQ(state.position.x, there);  // the device stays exactly where it was
    }
}

TEST(HapticsSimulated, TheSameTicksGiveTheSameBits) {
    auto spec = reference_spec();
    spec.coulomb_friction = 0.1;
    spec.latency = 2;
    const auto device = simulated_device(spec, {});
    const auto run = [&device] {
        Random random{5};
        auto state = resting_at({});
        std::uint64_t hash = 0;
        for (int i = 0; i < 5000; ++i) {
            const vec3 target{random.uniform(-0.1, 0.1), 0, random.uniform(-0.1, 0.1)};
            state = step(device, state, target, {0, random.uniform(-3, 3), 0});
            hash = hash_value(state, hash);
        }
        return hash;
    };
    EXPECT_EQ(run(), run());
    // The hash must be the same in every build and on every processor. It changes only if the model is
    // changed on purpose.
    EXPECT_EQ(run(), 4712942992120687017ULL);
}

}  // namespace
}  // namespace thaum::haptics
