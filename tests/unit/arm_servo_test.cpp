// Unit tests of the servo of a real arm and the simulation that repeats its steps: their forces are equal to
// the bit, whatever the timing of the two threads.
#include "input/arm_servo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

#include "core/random.h"
#include "unit/allocations.h"
#include "unit/input_log_samples.h"

namespace thaum::input {
namespace {

constexpr std::int64_t ms = 1'000'000;

const haptics::Servo touch_servo{haptics::safety_limits(
    {.name = "Touch", .sensed = 6, .actuated = 3, .peak_force = 3.3, .continuous_force = 0.88}, 1.0)};

/// An arm that moves by 1 um per tick, so that its position identifies the tick.
struct Arm {
    ArmServo& servo;
    std::int32_t ticks = 0;
    std::int64_t now_ns = 5 * ms;
    std::vector<vec3> forces{vec3(0)};  // forces that the arm computed (N); the index is the position in um

    void step() {
        now_ns += ms;
        ++ticks;
        ArmReading reading{.time_ns = now_ns};
        reading.position_um = {ticks, 0, -ticks};
        reading.buttons = ticks % 64 < 32 ? 1U : 0U;
        forces.push_back(servo.step(reading));
    }
};

/// The side of the match: repeats the arm's servo steps, and makes a new haptic model in each tick.
struct Mirror {
    ArmServo& servo;
    ArmState arm{};
    std::vector<RememberedModel> kept = std::vector<RememberedModel>(remembered_models);
    Random random = random_stream(7, 1);
    std::map<std::int32_t, vec3> forces{};  // forces that the match computed (N), by the arm's position in um
    std::uint32_t pulses = 0;
    bool panic = false, rearm = false;
    double push = 1;
    DeviceSample newest{};
    // The epoch (run of samples without a gap) for which the models in `kept` were made
    std::uint32_t epoch = 1;

    const RememberedModel* find(std::uint32_t number) const {
        const auto& model = kept[number % remembered_models];
        return number != 0 && model.number == number ? &model : nullptr;
    }

    haptics::HapticModel next_model() {
        haptics::HapticModel model;
        model.steady_force.force = push * vec3(random.uniform(), random.uniform(), -random.uniform());
        model.tether = {
            .anchor = {0.001 * random.uniform(), 0, 0}, .stiffness = 100, .damping = 1, .number = 1};
        if (random.uniform() < 0.01) ++pulses;
        model.pulse = {.peak = {0, 0, 1}, .length = 15, .number = pulses};
        model.panic = panic;
        model.rearm = rearm;
        return model;
    }

    void tick(bool skipped = false) {
        newest = servo.take();
        const auto before = arm.samples;
        take_sample(arm, touch_servo, newest, find(model_of(arm, newest)), skipped);
        if (arm.samples > before) forces[arm.position_um[0]] = arm.servo.safety.output;
        if (arm.epoch != epoch) kept.assign(remembered_models, {});
        epoch = arm.epoch;
        const auto number = ++arm.number;
        kept[number % remembered_models] = {next_model(), {}, number, arm.samples};
        servo.order() = {
            touch_servo, kept[number % remembered_models].model, {}, arm.servo, arm.epoch, number,
            arm.samples};
        servo.publish();
    }
};

/// Compares the forces that the arm and the match computed at each position. Returns the number of compared
/// forces.
std::size_t expect_same_forces(const Arm& arm, const Mirror& mirror) {
    for (const auto& [place, force] : mirror.forces) {
        const auto& told = arm.forces[static_cast<std::size_t>(place)];
        EXPECT_TRUE(force == told) << "tick " << place << ": " << force.x << " and " << told.x;
        if (!(force == told)) break;
    }
    EXPECT_EQ(arm.servo.faults().differing, 0U);
    return mirror.forces.size();
}

double strongest(const std::vector<vec3>& forces, std::size_t from) {
    double most = 0;
    for (std::size_t i = from; i < forces.size(); ++i) most = std::max(most, glm::length(forces[i]));
    return most;
}

class ArmServoTest : public testing::Test {
protected:
    ArmServo servo;
    Arm arm{servo};
    Mirror mirror{servo};
};

TEST_F(ArmServoTest, InStepTheForcesAgree) {
    for (int i = 0; i < 5000; ++i) arm.step(), mirror.tick();
    EXPECT_GT(expect_same_forces(arm, mirror), 4990U);
    EXPECT_EQ(mirror.arm.gaps, 0U);
    EXPECT_EQ(mirror.newest.model_age, 1);
    EXPECT_GT(strongest(arm.forces, 100), 0.3);
    EXPECT_EQ(servo.faults().lost, 0U);
}

/// Now and then, the arm or the match falls up to 30 ticks behind the other. Their forces must agree all the
/// same.
TEST_F(ArmServoTest, OutOfStepTheForcesAgree) {
    Random random = random_stream(11, 1);
    int ahead = 0;
    std::uint16_t oldest = 0;
    while (arm.ticks < 20'000) {
        const bool by_arm = ahead < -3 || (ahead < 30 && random.uniform() < 0.5);
        by_arm ? arm.step() : mirror.tick();
        ahead += by_arm ? 1 : -1;
        oldest = std::max(oldest, mirror.newest.model_age);
    }
    EXPECT_GT(expect_same_forces(arm, mirror), 15'000U);
    EXPECT_GT(oldest, 10);
}

/// The simulation stalls for long, then leaves out the ticks that it missed or catches up. The arm stalls
/// too. Samples are lost, and the forces must agree again.
TEST_F(ArmServoTest, AfterGapsTheForcesAgreeAgain) {
    Random random = random_stream(13, 1);
    std::uint32_t gaps = 0;
    for (int round = 0; round < 60; ++round) {
        for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
        EXPECT_EQ(mirror.newest.model_age, 1) << "in step again";
        const auto stall = static_cast<int>(random.uniform() * 1500);
        switch (round % 4) {
            case 0:  // the simulation stops, and leaves out the ticks that it missed
                for (int i = 0; i < stall; ++i) arm.step();
                mirror.tick(true);
                break;
            case 1:  // the simulation stops, and catches up with all ticks
                for (int i = 0; i < stall; ++i) arm.step();
                for (int i = 0; i < stall; ++i) mirror.tick();
                break;
            case 2:  // the arm stops
                for (int i = 0; i < stall; ++i) mirror.tick();
                break;
            default:  // the simulation begins anew
                gaps += mirror.arm.gaps;
                mirror.arm = {};
                mirror.kept.assign(remembered_models, {});
                servo.begin_match();
        }
    }
    EXPECT_GT(expect_same_forces(arm, mirror), 10'000U);
    EXPECT_GT(gaps, 30U);
    EXPECT_GT(servo.faults().lost, 0U);
}

TEST_F(ArmServoTest, WithoutNewModelsTheForceEnds) {
    for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    const auto then = arm.forces.size();
    for (int i = 0; i < 100; ++i) arm.step();
    EXPECT_GT(glm::length(arm.forces[then + 10]), 0.05);
    EXPECT_EQ(strongest(arm.forces, then + 71), 0);
    for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    EXPECT_GT(glm::length(arm.forces.back()), 0.05) << "and comes again";
}

TEST_F(ArmServoTest, NoticesASimulationThatComputesOtherwise) {
    for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    EXPECT_EQ(servo.faults().differing, 0U);
    mirror.arm.servo.safety.heat[0] += 1;
    mirror.arm.servo.positions[0].x += 1e-5;
    for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    EXPECT_GT(servo.faults().differing, 0U);
}

TEST_F(ArmServoTest, AllocatesNothing) {
    arm.forces.reserve(1000);
    const auto once = [&] { arm.step(), servo.order() = {}, servo.publish(), servo.take(); };
    once();
    const auto before = test::allocations();
    for (int i = 0; i < 500; ++i) once();
    EXPECT_EQ(test::allocations() - before, 0U);
}

TEST_F(ArmServoTest, BeforeTheFirstModelThereIsNoForce) {
    for (int i = 0; i < 50; ++i) arm.step();
    EXPECT_EQ(strongest(arm.forces, 0), 0);
    EXPECT_EQ(servo.waiting(), 0U);
}

// ---- impossible poses of an arm ---------------------------------------------------------------------------

struct BadPoses : ArmServoTest {
    std::vector<vec3> forces{};

    BadPoses() {
        for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    }
    /// Runs 200 ticks of arm and match. f(tick), for ticks 1 to 200, returns the arm's reading.
    template <class F>
    void feed(F f) {
        for (int i = 1; i <= 200; ++i) {
            const ArmReading reading = f(i);
            forces.push_back(servo.step(reading));
            mirror.tick();
            ASSERT_TRUE(mirror.arm.servo.safety.output == forces.back()) << i;
        }
    }
    ArmReading reading(std::int64_t time_ns) const {
        ArmReading r{.time_ns = time_ns};
        r.position_um = {arm.ticks, 0, -arm.ticks};
        return r;
    }
    void expect_force_ended() const {
        EXPECT_GT(glm::length(forces[5]), 0.05);
        EXPECT_EQ(strongest(forces, 71), 0);
        EXPECT_EQ(mirror.arm.old_poses, 200U);
    }
};

TEST_F(BadPoses, ThatRepeat) {
    feed([&](int) { return reading(arm.now_ns); });
    expect_force_ended();
    EXPECT_EQ(servo.faults().poses.repeated, 200U);
    for (int i = 0; i < 300; ++i) arm.step(), mirror.tick();
    EXPECT_GT(glm::length(mirror.arm.servo.safety.output), 0.05) << "and begins again with good ones";
}

TEST_F(BadPoses, ThatAreNoNumbers) {
    feed([&](int i) {
        auto r = reading(arm.now_ns + i * ms);
        r.usable = false;
        return r;
    });
    expect_force_ended();
    EXPECT_EQ(servo.faults().poses.unusable, 200U);
}

TEST_F(BadPoses, ThatJumpBackInTime) {
    feed([&](int i) { return reading(arm.now_ns - 100'000 * ms + i * ms); });
    EXPECT_EQ(servo.faults().poses.backwards, 21U) << "a clock that was set back is believed after 20 ticks";
    EXPECT_EQ(mirror.arm.old_poses, 20U);
    EXPECT_GT(glm::length(forces.back()), 0.05);
}

TEST_F(BadPoses, ThatJumpFar) {
    feed([&](int i) {
        auto r = reading(arm.now_ns + i * ms);
        r.position_um[1] = i % 3 == 0 ? 80'000 : -2'000'000'000;
        return r;
    });
    EXPECT_LE(strongest(forces, 0), 3.3);
    EXPECT_EQ(strongest(forces, 10), 0) << "nothing moves that fast";
}

// ---- the arm's state in the match -------------------------------------------------------------------------

TEST(ArmState, AnySampleOfADamagedLogIsSurvived) {
    Random random = random_stream(17, 1);
    ArmServo unused;
    Mirror mirror{unused};
    for (int i = 0; i < 20'000; ++i) {
        DeviceSample sample;
        for (auto& count : sample.counts) count = static_cast<std::int32_t>(random.next());
        sample.model_age = static_cast<std::uint16_t>(random.next() % 100);
        sample.skips = random.uniform() < 0.01 ? 1 : 0;
        take_sample(mirror.arm, touch_servo, sample, mirror.find(model_of(mirror.arm, sample)), false);
        ASSERT_LE(glm::length(mirror.arm.servo.safety.output), 3.3);
        mirror.tick();
    }
}

TEST_F(ArmServoTest, ButtonsAreKeptForAWhileWithoutSamples) {
    for (int i = 0; i < 70; ++i) arm.step(), mirror.tick();
    EXPECT_TRUE(mirror.newest.down(Button::fire));
    for (int i = 0; i < 20; ++i) mirror.tick();
    EXPECT_TRUE(mirror.newest.down(Button::fire));
    EXPECT_EQ(mirror.newest.model_age, 0);
    mirror.tick();
    EXPECT_FALSE(mirror.newest.down(Button::fire));
}

TEST_F(ArmServoTest, PanicAndItsEndReachTheArm) {
    const auto both = [&](int times) {
        for (int i = 0; i < times; ++i) arm.step(), mirror.tick();
    };
    both(300);
    mirror.panic = true;
    both(3);
    mirror.panic = false;
    both(1);
    EXPECT_EQ(arm.forces.back(), vec3(0));
    // After an emergency stop, the force stays zero until the player switches forces on again. That holds
    // after a skipped tick, too, at which arm and simulation start anew.
    mirror.tick(true);
    const auto then = arm.forces.size();
    both(200);
    EXPECT_EQ(strongest(arm.forces, then), 0);
    mirror.rearm = true;
    both(100);
    EXPECT_GT(glm::length(arm.forces.back()), 0.05);
    expect_same_forces(arm, mirror);
}

/// Two threads, both as fast as they can. A race would show as a different force (and to a thread sanitizer).
TEST_F(ArmServoTest, TwoThreadsAgree) {
    std::atomic<bool> stop{false};
    std::jthread moving([&] {
        while (!stop && arm.ticks < 200'000) {
            arm.step();
            if (servo.waiting() > 20 || arm.ticks % 50 == 0) std::this_thread::yield();
        }
        // Ends the other thread's waits. Otherwise that thread could wait for ever, if it got no processor
        // until all ticks were over.
        stop = true;
    });
    for (int i = 0; i < 20'000; ++i) {
        while (servo.waiting() == 0 && i % 100 != 0 && !stop) std::this_thread::yield();
        mirror.tick();
    }
    stop = true;
    moving.join();
    expect_same_forces(arm, mirror);
    EXPECT_GT(mirror.arm.samples + mirror.arm.gaps, 0U);
}

}  // namespace
}  // namespace thaum::input
