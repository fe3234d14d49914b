// Stability of switches: switching from one passive source (wall, spring) to another must create hardly any
// energy at the hand, for every device and hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "haptics/audit/safety_audit.h"
#include "tests/scenes/changed_world.h"
#include "tests/scenes/switches.h"
#include "unit/shipped_devices.h"

namespace thaum::haptics {
namespace {

constexpr double max_per_switch = 0.02;  // largest energy that a switch may create (J); see HAPTICS.md
/// Largest change of the output in a tick, beyond that of a spring with the device's stiffness (N).
constexpr double max_change = 0.5;

TEST(HapticsSwitches, AStretchedSpringThatComesIsNotChased) {
    for (const auto& spec : shipped_devices()) {
        const double full = spec.peak_force / spec.max_stiffness;
        for (const auto& hand : bench::switch_hands) {
            for (const double stretch : {0.2 * full, full, 3 * full}) {
                const auto run = bench::one_spring(spec, hand, stretch);
                EXPECT_LE(run.most_created, max_per_switch)
                    << spec.name << ", " << hand.name << ", " << stretch;
            }
        }
    }
}

TEST(HapticsSwitches, TenThousandRandomSwitchesOfEachDeviceCreateNextToNothing) {
    // Number of switches for each of five devices, with five hands and eight seeds.
    constexpr int switches = 250;
    for (const auto& spec : shipped_devices()) {
        for (const auto& hand : bench::switch_hands) {
            const auto run = bench::random_switches(spec, hand, switches);
            EXPECT_LE(run.most_created, max_per_switch) << spec.name << ", " << hand.name;
            EXPECT_LE(run.max_change, max_change) << spec.name << ", " << hand.name;
            EXPECT_LE(run.max_fast_change, 1.25) << spec.name << ", " << hand.name;
            EXPECT_EQ(run.switches, switches * static_cast<int>(bench::switch_seeds.size()));
            EXPECT_GT(run.fastest, 0.01) << "nothing moved: " << spec.name << ", " << hand.name;
        }
    }
}

TEST(HapticsSwitches, AWorldThatChangesAgainAndAgainPushesNoHandAway) {
    for (const auto& spec : shipped_devices()) {
        for (const auto& hand : bench::pressing_hands) {
            for (const auto change : bench::world_changes) {
                for (const bool surface : {false, true}) {
                    bench::ChangedWorld world(spec, hand, surface);
                    for (int i = 0; i < 5; ++i) world.change(change);
                    const auto which = static_cast<int>(change);
                    EXPECT_LE(world.most_created(), max_per_switch)
                        << spec.name << ", " << hand.stiffness << ", " << which << ", " << surface;
                    // The change is not checked when a surface comes back: a hand that fell meanwhile meets
                    // it like any wall, with a jump of force.
                    if (surface && change == bench::WorldChange::spring) continue;
                    EXPECT_LE(world.max_jump(), 0.75)
                        << spec.name << ", " << hand.stiffness << ", " << which << ", " << surface;
                }
            }
        }
    }
}

/// A safety stage (the part that limits forces), whose output an independent audit checks in every tick.
struct AuditedStage {
    SafetyLimits limits{};
    SafetyState state{};
    SafetyAudit audit{};

    vec3 feel(const SafetyInput& input, int ticks = 1) {
        vec3 output{};
        for (int i = 0; i < ticks; ++i) {
            output = make_safe(limits, state, input);
            audit.record(limits, input, output);
        }
        return output;
    }
    vec3 feel(vec3 wanted) { return feel(SafetyInput{.wanted = wanted}); }
};

TEST(HapticsSwitches, ALargestForceThatIsMovedAtOnceMakesNoJump) {
    AuditedStage stage{safety_limits(shipped_devices().back(), 1)};
    const SafetyLimits full = stage.limits;
    stage.feel({.wanted = {3, 0, 0}}, 100);
    double before = 3;
    for (int move = 0; move < 6; ++move) {
        stage.limits.cap = move % 2 == 0 ? 0.05 * full.cap : full.cap;
        for (int tick = 0; tick < 20 + 15 * move; ++tick) {
            const double force = stage.feel({3, 0, 0}).x;
            EXPECT_LE(std::abs(force - before), 0.4 + 1e-12) << move << ", " << tick;
            EXPECT_GE(force, 0);
            if (move % 2 == 0 && tick > 7) EXPECT_LE(force, stage.limits.cap);
            before = force;
        }
    }
    EXPECT_EQ(stage.audit.violations(), 0);
}

TEST(HapticsSwitches, SourcesThatSettleAfterASwitchMakeNoJump) {
    AuditedStage stage{safety_limits(shipped_devices().back(), 1)};
    stage.feel({.wanted = {3, 0, 0}}, 100);
    SafetyInput input{.wanted = {3, 0, 0}, .switched = true, .settles = true};
    double before = 3;
    for (const double wanted : {3.0, 1.0, 1.2, -2.0, 2.5, 2.5}) {
        input.wanted.x = wanted;
        const double force = stage.feel(input).x;
        EXPECT_LE(std::abs(force - before), 0.04 + 1e-12) << wanted;
        before = force;
        input.switched = false;
    }
    input.settles = false;
    EXPECT_NEAR(stage.feel(input, 30).x, 2.5, 1e-12);
    EXPECT_EQ(stage.audit.violations(), 0);
}

TEST(HapticsSwitches, AThingThatVanishesFadesOut) {
    for (const auto& spec : shipped_devices()) {
        const Servo servo = servo_of(spec, 1);
        ServoState state;
        HapticModel model;
        model.patch.count = model.patch.body_count = 2;
        model.patch.surfaces[0] = {.kind = SurfaceKind::plane, .body = 0, .a = {0, -0.02, 0}, .b = {0, 1, 0}};
        model.patch.surfaces[1] = {
            .kind = SurfaceKind::sphere, .body = 1, .a = {0, -0.01, 0}, .b = {0.01, 0, 0}};
        for (std::uint32_t i = 0; i < 2; ++i) {
            model.patch.bodies[i].key = 10 + i;
            model.patch.bodies[i].material.stiffness = spec.max_stiffness;
        }
        const double depth = 0.5 * spec.peak_force / spec.max_stiffness;
        vec3 before{};
        for (int i = 0; i <= 100; ++i)
            before = servo_step(servo, state, model, {vec3(0, 1e-4 - (depth + 1e-4) * i / 100, 0), 0});
        ASSERT_NEAR(before.y, 0.5 * spec.peak_force, 0.02 * spec.peak_force) << spec.name;
        model.patch.count = model.patch.body_count = 1;  // the ball is removed, the floor stays
        for (int i = 0; i < 400; ++i) {
            const vec3 force = servo_step(servo, state, model, {vec3(0, -depth, 0), 0});
            EXPECT_LE(glm::length(force - before), 0.04 + 1e-9) << spec.name << ", " << i;
            before = force;
        }
        EXPECT_EQ(before, vec3(0)) << spec.name;
    }
}

TEST(HapticsSwitches, AnOffsetEndsWithTheForceThatItHides) {
    for (const int breaks_after : {1, 20, 60}) {
        for (const int within : {1, 10, 40}) {
            AuditedStage stage{safety_limits(shipped_devices().back(), 1)};
            stage.feel({.wanted = vec3(0)}, 10);
            stage.feel({.wanted = {3, 0, 0}, .switched = true});
            stage.feel({.wanted = {3, 0, 0}}, breaks_after);
            for (int tick = 1; tick <= within; ++tick)
                EXPECT_GE(stage.feel({3 - 3.0 * tick / within, 0, 0}).x, -1e-12)
                    << "pulled into a broken wall";
            EXPECT_NEAR(stage.feel(vec3(0)).x, 0, 1e-12);
            EXPECT_NEAR(stage.feel({2, 0, 0}).x, 2, 1e-12) << "and nothing is left of the offset";
            EXPECT_EQ(stage.audit.violations(), 0);
        }
    }
}

TEST(HapticsSwitches, TheBrakeBeginsSlowlyAndPullsNoHandIntoAWall) {
    for (const auto& spec : shipped_devices()) {
        const Servo servo = servo_of(spec, 1);
        ServoState state;
        HapticModel model;
        model.patch.count = model.patch.body_count = 1;
        model.patch.surfaces[0] = {.kind = SurfaceKind::plane, .b = {0, 1, 0}};
        model.patch.bodies[0].material.stiffness = 0.5 * spec.max_stiffness;
        const double depth = 0.8 * spec.peak_force / spec.max_stiffness, step = depth / 20;
        double height = 1e-4, before = 0;
        for (int tick = 0; tick < 80; ++tick) {
            // The hand moves in, waits, and moves out, while a source that has ended meanwhile has created
            // energy, which the servo's brake must take back.
            const double way = tick < 30 ? -step : tick < 40 ? 0 : step;
            height = std::max(height + way, -depth);
            if (tick == 42) state.energy.created = 0.02;
            const double force = servo_step(servo, state, model, {vec3(0, height, 0), 0}).y;
            EXPECT_GE(force, -1e-12) << spec.name << ", " << tick;
            EXPECT_LE(std::abs(force - before), spec.max_stiffness * step + brake_step + 1e-9)
                << spec.name << ", " << tick;
            before = force;
        }
    }
}

/// Energy that a wall, moved by 4 mm every `period` ticks, creates at a firm hand that moves in and out (J).
double created_by_edits(const DeviceSpec& spec, int period) {
    auto device_spec = spec;
    // This limit is high, because warm motors weaken forces, which would hide created energy.
    device_spec.continuous_force = 10 * spec.peak_force;
    const auto device = simulated_device(device_spec, {.mass = 0.4, .stiffness = 1500, .damping = 40});
    const Servo servo = servo_of(device_spec, 1);
    ServoState state;
    HapticModel model;
    model.coupling = {.stiffness = spec.max_stiffness};
    auto tip = resting_at({0, 0.02, 0});
    double created = 0, most = 0, wall = 0;
    for (int t = 0; t < 2000; ++t) {
        if (t % period == 0) {
            wall = wall == 0 ? -0.004 : 0;
            ++model.set_number;
        }
        model.primitives.clear();
        model.primitives.add({PrimitiveKind::plane, {0, wall, 0}, {0, 1, 0}, spec.peak_force});
        const vec3 force = servo_step(servo, state, model, {measured_position(device, tip), 1});
        const vec3 from = tip.position;
        tip = step(device, tip, {0, -0.005 + 0.02 * std::cos(2 * pi * 3.1 * t * tick_seconds), 0}, force);
        const double depth = std::max(0.0, wall - from.y), bent = spec.peak_force / spec.max_stiffness;
        const double held =
            depth < bent ? spec.max_stiffness * depth * depth / 2 : spec.peak_force * (depth - bent / 2);
        created = std::max(created + glm::dot(tip.force, tip.position - from), -held);
        most = std::max(most, created);
    }
    return most;
}

TEST(HapticsSwitches, ManyEditsTogetherCreateHardlyMoreThanOne) {
    for (const auto& spec : shipped_devices())
        for (const int period : {1, 2, 8, 16, 40})
            EXPECT_LE(created_by_edits(spec, period), 1.25 * max_per_switch) << spec.name << ", " << period;
}

TEST(HapticsSwitches, AThingThatAppearsOrHardensUnderTheTipFadesIn) {
    for (const auto& spec : shipped_devices()) {
        const Servo servo = servo_of(spec, 1);
        ServoState state;
        HapticModel model;
        model.patch.surfaces[0] = {.kind = SurfaceKind::plane, .b = {0, 1, 0}};
        const double depth = 0.5 * spec.peak_force / spec.max_stiffness;
        vec3 before{};
        for (int i = 0; i < 1000; ++i) {
            const bool there = i >= 10, hard = i >= 400 && i < 700;
            model.patch.count = model.patch.body_count = there ? 1 : 0;
            model.patch.bodies[0].material.stiffness = (hard ? 1 : 0.1) * spec.max_stiffness;
            const vec3 force = servo_step(servo, state, model, {vec3(0, -depth, 0), 0});
            EXPECT_LE(glm::length(force - before), 0.04 + 1e-9) << spec.name << ", " << i;
            EXPECT_GE(force.y, 0) << spec.name << ", " << i;
            before = force;
        }
        EXPECT_GT(before.y, 0.02 * spec.peak_force) << spec.name;
    }
}

TEST(HapticsSwitches, WarmMotorsMakeNoJumpWhenForcesGoOffAndOn) {
    for (const auto& spec : shipped_devices()) {
        for (const int period : {3, 40}) {
            AuditedStage stage{safety_limits(spec, 1)};
            SafetyInput input{.wanted = {0.95 * spec.peak_force, 0, 0}};
            stage.feel(input, 12'000);
            vec3 before = stage.state.output;
            for (int i = 0; i < 2000; ++i) {
                input.on = i / period % 2 == 0;
                const vec3 force = stage.feel(input);
                EXPECT_LE(glm::length(force - before), 0.3) << spec.name << ", " << period << ", " << i;
                before = force;
            }
            EXPECT_EQ(stage.audit.violations(), 0) << spec.name << ", " << period;
        }
    }
}

/// Effects of forces that push a hand in quick succession.
struct Pushed {
    double max_change{};  ///< largest change of the output in a tick, beyond that of a spring (N)
    double max_work{};    ///< largest work on the hand within a second (J)
};

/// Moves a swinging, loosely held device by a directed force that changes every few ticks, mostly to the
/// direction of the hand's motion. Motor heat is left out, because it would hide work.
Pushed push_again_and_again(DeviceSpec spec, std::uint64_t seed) {
    spec.continuous_force = 10 * spec.peak_force;
    const Servo servo = servo_of(spec, 1);
    const auto device = simulated_device(spec, {.mass = 0.55, .stiffness = 135, .damping = 6.5});
    Random random{seed};
    ServoState state;
    HapticModel model;
    model.coupling.stiffness = spec.max_stiffness;
    auto tip = resting_at({});
    vec3 before{}, measured_before{};
    std::vector<double> work(1, 0.0);
    Pushed pushed;
    for (int t = 0, next = 0; t < 3000; ++t) {
        if (t == next) {
            const vec3 aside{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
            const double speed = glm::length(tip.velocity);
            const vec3 way = (speed > 0.01 ? 3.0 * tip.velocity / speed : vec3(2, 0, 0)) + aside;
            model.primitives.clear();
            model.primitives.add(
                {PrimitiveKind::directed, {}, glm::normalize(way), spec.peak_force * random.uniform(0.1, 1)});
            ++model.set_number;
            next = t + 1 + static_cast<int>(random.below(20));
        }
        const vec3 measured = measured_position(device, tip);
        const vec3 force = servo_step(servo, state, model, {measured, 0});
        const double of_spring = spec.max_stiffness * glm::length(measured - measured_before);
        pushed.max_change = std::max(pushed.max_change, glm::length(force - before) - of_spring);
        before = force;
        measured_before = measured;
        const vec3 from = tip.position;
        tip = step(device, tip, {0.02 * std::sin(2 * pi * t / 700), 0.02 * std::sin(2 * pi * t / 500), 0},
                   force);
        work.push_back(work.back() + glm::dot(tip.force, tip.position - from));
        const auto second = static_cast<std::ptrdiff_t>(std::min<std::size_t>(work.size(), 1001));
        pushed.max_work =
            std::max(pushed.max_work, work.back() - *std::min_element(work.end() - second, work.end()));
    }
    return pushed;
}

TEST(HapticsSwitches, PushesInQuickSuccessionKeepToTheirBudgetAndMakeNoJump) {
    for (const auto& spec : shipped_devices()) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Pushed pushed = push_again_and_again(spec, seed);
            EXPECT_LE(pushed.max_change, max_change) << spec.name << ", " << seed;
            EXPECT_LE(pushed.max_work, active_budget + 1e-3) << spec.name << ", " << seed;
            EXPECT_GT(pushed.max_work, 0.05) << spec.name << ", " << seed;
        }
    }
}

TEST(HapticsSwitches, AnOffsetThatYieldsWaitsForASpringThatYields) {
    constexpr double stiffness = 5000, step = 2e-4;
    AuditedStage stage{safety_limits(shipped_devices().back(), 1)};
    stage.limits.cap = stage.limits.continuous = 12;
    SafetyInput input{.wanted = {8, 0, 0}, .stiffness = stiffness};
    stage.feel(input, 400);  // long enough for the output to reach 8 N
    // The source is switched. The offset, which keeps the output from jumping, starts with 3 N and hardly any
    // energy that it may give. The hand moves out, so that the spring's force falls by 1 N a tick.
    input.wanted.x = 5;
    input.switched = true;
    input.fade_energy = 1e-9;
    double before = stage.feel(input).x;
    input.switched = false;
    int yielding = 0;
    for (int tick = 0; tick < 5; ++tick) {
        input.tip.x += step;
        input.wanted.x -= stiffness * step;
        const double force = stage.feel(input).x;
        EXPECT_LE(before - force, stiffness * step + steady_change + 1e-12) << tick;
        if (before - force > stiffness * step + 0.1) ++yielding;
        before = force;
    }
    EXPECT_EQ(yielding, 5) << "and yet the offset yields in every tick";
    EXPECT_EQ(stage.audit.violations(), 0);
}

TEST(HapticsSwitches, AFadeIsFasterOnlyWhereItWouldCreateTooMuchEnergy) {
    // Force (N) and stiffness (N/m) of a Premium, a haptic device.
    constexpr double force = 8.5, stiffness = 800;
    PassivityObserver observer;
    for (const double speed : {0.0, 0.1, 0.3, 0.4, 0.6, 1.0, 2.0}) {
        const vec3 step{0, speed * tick_seconds, 0};
        const double change = change_of_fade(observer, {0, force, 0}, step, 0, stiffness);
        const double rate = steady_change / tick_seconds + stiffness * speed;
        const double slowly = force * force * speed / (2 * rate);
        if (slowly <= max_slow_creation) {
            EXPECT_EQ(change, steady_change) << speed;
            continue;
        }
        const double created = force * force * speed / (2 * (change / tick_seconds + stiffness * speed));
        EXPECT_NEAR(created, max_slow_creation, 1e-12) << speed;
        EXPECT_EQ(change_of_fade(observer, {0, force, 0}, -step, 0, stiffness), steady_change) << speed;
    }
    EXPECT_GT(change_of_fade(observer, {0, force, 0}, {0, 6e-4, 0}, 0, stiffness), steady_change);
}

TEST(HapticsSwitches, AFigureThatIsNoNumberStaysTheWorst) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(bench::worse(1, 2), 2);
    EXPECT_EQ(bench::worse(2, 1), 2);
    EXPECT_TRUE(std::isnan(bench::worse(1, nan)));
    EXPECT_TRUE(std::isnan(bench::worse(nan, 1)));
    const auto run = bench::one_spring(shipped_devices().front(), bench::switch_hands[0], nan);
    EXPECT_TRUE(std::isnan(run.most_created)) << run.most_created;
}

}  // namespace
}  // namespace thaum::haptics
