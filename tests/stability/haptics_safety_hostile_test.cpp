// Stability of the servo step and of its last part, the safety stage, which limits forces: no input may make
// them break a safety rule, on any shipped device.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptics/audit/safety_audit.h"
#include "haptics/servo.h"
#include "tests/scenes/safety_attack.h"
#include "unit/shipped_devices.h"

namespace thaum::haptics {
namespace {

constexpr int attack_ticks = 500'000;

void expect_none(const SafetyAudit& audit, const std::string& device) {
    for (std::uint32_t i = 0; i < safety_rules; ++i) {
        const auto rule = static_cast<SafetyRule>(i);
        EXPECT_EQ(audit.violations(rule), 0) << device << ": " << name(rule);
    }
}

void attack_stage(const DeviceSpec& spec, std::uint64_t seed) {
    bench::SafetyAttack attack(spec, seed);
    SafetyState state;
    SafetyAudit audit;
    std::array<int, 9> met{};
    int felt = 0;
    for (int tick = 0; tick < attack_ticks; ++tick) {
        const auto input = attack.next();
        const vec3 output = make_safe(attack.limits(), state, input);
        audit.record(attack.limits(), input, output);
        ++met.at(state.cause);
        felt += output != vec3(0) ? 1 : 0;
    }
    const std::string rig = spec.name + ", seed " + std::to_string(seed);
    expect_none(audit, rig);
    // Hostile input of which the safety stage lets no force pass would prove nothing.
    EXPECT_GT(felt, attack_ticks / 10) << rig;
    for (std::size_t cause = 0; cause < met.size(); ++cause) {
        const bool cannot =
            cause == static_cast<std::size_t>(SafetyCause::warm) && spec.continuous_force == spec.peak_force;
        EXPECT_TRUE(cannot || met.at(cause) > 50) << rig << ": cause " << cause;
    }
}

TEST(HapticsSafetyHostile, NothingGetsThroughTheSafetyStage) {
    const auto devices = shipped_devices();
    EXPECT_EQ(devices.size(), 5U);
    for (const auto& spec : devices) {
        // With seed 1, a brake acts while the force of a Touch device returns after its motors were too warm.
        attack_stage(spec, 1);
        attack_stage(spec, 5);
    }
}

/// Replaces the patch of surfaces near the tip by a random one, valid or not.
void change_patch(HapticModel& model, vec3 at, Random& random) {
    const auto nasty = [&random] {
        constexpr std::array values{0.0, 1e300, -1e-300, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()};
        return random.below(8) == 0 ? values[random.below(values.size())] : random.uniform(-0.02, 0.02);
    };
    const auto place = [&] { return vec3(nasty(), nasty(), nasty()); };
    SurfacePatch& patch = model.patch;
    patch.count = static_cast<std::uint32_t>(random.below(6));
    patch.body_count = static_cast<std::uint32_t>(random.below(3));
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        patch.surfaces[i] = {.kind = static_cast<SurfaceKind>(random.below(7)),
                             .body = static_cast<std::uint32_t>(random.below(3)),
                             .a = at + place(),
                             .b = random.below(2) == 0 ? vec3(0, 1, 0) : place(),
                             .c = at + place()};
    }
    for (SurfaceBody& body : patch.bodies) {
        body.velocity = 10.0 * place();
        body.spin = 100.0 * place();
        body.material.stiffness = random.below(2) == 0 ? 300 : 1e9 * nasty();
        body.material.damping = 100 * nasty();
        body.material.static_friction = body.material.dynamic_friction = 50 * nasty();
    }
    model.frame_motion = {10.0 * place(), 100.0 * place()};
    model.patch_number += random.below(2);
}

TEST(HapticsSafetyHostile, NothingGetsThroughTheServoStep) {
    for (const auto& spec : shipped_devices()) {
        bench::SafetyAttack attack(spec, 17);
        Random random{18};
        const Servo servo{safety_limits(spec, 1)};
        ServoState state;
        HapticModel model;
        const double fall = servo.limits.max_speed * tick_seconds;
        vec3 position{};
        int off_for = 0;
        for (int tick = 0; tick < attack_ticks; ++tick) {
            const auto input = attack.next();
            if (random.below(20) == 0)
                model.pulse = {input.wanted, static_cast<std::uint32_t>(random.below(100)),
                               static_cast<std::uint32_t>(model.pulse.number + random.below(3))};
            if (random.below(10) == 0) change_patch(model, position, random);
            model.on = input.on;
            model.panic = input.panic;
            model.rearm = input.rearm;
            position += random.uniform(-1, 1) * fall;
            const bool lost = random.below(5000) == 0;
            const vec3 force =
                servo_step(servo, state, model, {lost ? input.wanted : position, input.model_age});
            ASSERT_TRUE(is_finite(force));
            ASSERT_LE(glm::length(force), servo.limits.cap);
            off_for = model.on ? 0 : off_for + 1;
            ASSERT_TRUE(!model.panic || force == vec3(0));
            ASSERT_TRUE(off_for < 50 || force == vec3(0));
        }
    }
}

}  // namespace
}  // namespace thaum::haptics
