// Unit tests of the audit of the safety stage (an independent check of the stage that limits forces): it
// reports each violation.
#include "haptics/audit/safety_audit.h"

#include <gtest/gtest.h>

#include <functional>

#include "haptics/safety.h"
#include "unit/omni_like.h"

namespace thaum::haptics {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();

using Arrange = std::function<void(int tick, SafetyInput&)>;
using Spoil = std::function<vec3(int tick, vec3 output)>;

/// Lets the safety stage run for a second, in which 1.5 N are wanted from the start. `arrange` may change its
/// input, `spoil` changes its output. Returns how often the audit reports a violation of the rule.
std::uint64_t seen(SafetyRule rule, const Arrange& arrange, const Spoil& spoil) {
    const auto limits = safety_limits(omni_like(), 1);
    SafetyState state;
    SafetyAudit audit;
    for (int tick = 0; tick < 1000; ++tick) {
        SafetyInput input{.wanted = {1.5, 0, 0}};
        arrange(tick, input);
        audit.record(limits, input, spoil(tick, make_safe(limits, state, input)));
    }
    return audit.violations(rule);
}

/// Checks that the audit reports a violation for the spoilt output, and none for the safety stage's own
/// output.
void expect_caught(SafetyRule rule, const Arrange& arrange, const Spoil& spoil) {
    EXPECT_EQ(seen(rule, arrange, [](int, vec3 output) { return output; }), 0) << name(rule);
    EXPECT_GT(seen(rule, arrange, spoil), 0) << name(rule);
}

void as_usual(int, SafetyInput&) {}

/// At tick 500 the wanted force ends, announced as a switch (its source has gone), so that the output must
/// fade.
void force_ends(int tick, SafetyInput& input) {
    input.switched = tick == 500;
    if (tick >= 500) input.wanted = {};
}

Arrange from_500(const std::function<void(SafetyInput&)>& change) {
    return [change](int tick, SafetyInput& input) {
        if (tick >= 500) change(input);
    };
}

/// Makes the output at tick 500 a force of this size along y (N).
Spoil at_500(double bad) {
    return [bad](int tick, vec3 output) { return tick == 500 ? vec3(0, bad, 0) : output; };
}

/// Multiplies the safety stage's output of one tick by a factor.
Spoil scaled_at(int when, double factor) {
    return [when, factor](int tick, vec3 output) { return tick == when ? output * factor : output; };
}

/// Adds a force to the safety stage's output of one tick (N).
Spoil shifted_at(int when, vec3 shift) {
    return [when, shift](int tick, vec3 output) { return tick == when ? output + shift : output; };
}

/// Adds a tiny force to every output from tick 500 on.
vec3 leak(int tick, vec3 output) { return tick < 500 ? output : output + vec3(1e-9, 0, 0); }

TEST(HapticsSafetyAudit, ReportsForcesBeyondTheDevice) {
    expect_caught(SafetyRule::finite, as_usual, at_500(no_number));
    expect_caught(SafetyRule::finite, as_usual, at_500(-endless));
    expect_caught(SafetyRule::cap, as_usual, at_500(std::nextafter(3.3, 4)));
    expect_caught(SafetyRule::budget, as_usual, [](int, vec3) { return vec3(2.8, 0, 0); });
}

TEST(HapticsSafetyAudit, ReportsForcesThatNobodyWanted) {
    expect_caught(SafetyRule::unasked, as_usual, at_500(0.001));
    expect_caught(SafetyRule::unasked, as_usual, scaled_at(500, 1.001));
    // Motors that are cool must give all of the wanted force.
    expect_caught(SafetyRule::unasked, as_usual, scaled_at(500, 0.999));
    // Motors that are warm give less of the wanted force but the whole brake, which may have another
    // direction.
    const auto presses_and_brakes = [](int, SafetyInput& input) {
        input.wanted = {3.3, 0, 0};
        input.brake = {0, 0.2, 0};
    };
    for (const vec3 shift : {vec3(0, 0, 1e-9), vec3(0, 0.3, 0), vec3(0, -0.3, 0), vec3(-2, 0, 0)})
        expect_caught(SafetyRule::unasked, presses_and_brakes, shifted_at(900, shift));
}

TEST(HapticsSafetyAudit, ReportsJumpsAtSwitches) {
    expect_caught(SafetyRule::slew, force_ends, shifted_at(500, {-0.001, 0, 0}));
    // The safety stage starts with its gate shut: no force passes before the first one in range. When the
    // gate opens, that counts as a switch of the source, so the force must grow slowly.
    expect_caught(SafetyRule::slew, as_usual,
                  [](int tick, vec3 output) { return tick == 0 ? vec3(1.5, 0, 0) : output; });
}

TEST(HapticsSafetyAudit, ReportsAForceThatFollowsASwingingSpringForEver) {
    // A former fault of the safety stage: the output followed the swinging force at 40 N/s and never reached
    // it.
    const auto swings = [](int tick, SafetyInput& input) {
        input.switched = tick == 500;
        if (tick >= 500) input.wanted = {std::sin(0.2 * tick), 0, 0};
    };
    vec3 chasing{};
    expect_caught(SafetyRule::slew, swings, [&chasing](int tick, vec3 output) {
        if (tick < 500) return chasing = output;
        const vec3 gap = vec3(std::sin(0.2 * tick), 0, 0) - chasing;
        return chasing += gap * std::min(1.0, 0.04 / glm::length(gap));
    });
}

TEST(HapticsSafetyAudit, ReportsAFadingForceThatPushesAYieldingHandOn) {
    const auto ends_and_hand_yields = [](int tick, SafetyInput& input) {
        force_ends(tick, input);
        input.tip.x = tick < 500 ? 0 : 1e-3 * (tick - 500);
    };
    expect_caught(SafetyRule::slew, ends_and_hand_yields, [](int tick, vec3 output) {
        return tick < 500 ? output : vec3(std::max(0.0, 1.5 - 0.04 * (tick - 499)), 0, 0);
    });
}

TEST(HapticsSafetyAudit, ReportsForcesByAStaleModel) {
    const auto model_dies = [](int tick, SafetyInput& input) {
        input.model_age = static_cast<std::uint32_t>(std::max(0, tick - 480));
    };
    expect_caught(SafetyRule::stale, model_dies, leak);
    expect_caught(SafetyRule::stale, model_dies, scaled_at(510, 1.05));
}

TEST(HapticsSafetyAudit, ReportsForcesWhileTheStageMustGiveNone) {
    const auto starts_wild = [](int, SafetyInput& input) { input.wanted = {5, 0, 0}; };
    expect_caught(SafetyRule::waiting, starts_wild, leak);
    expect_caught(SafetyRule::over_speed, from_500([](SafetyInput& i) { i.velocity.z = 9; }), leak);
    expect_caught(
        SafetyRule::over_speed,
        [](int tick, SafetyInput& input) { input.velocity.z = tick == 450 ? no_number : 0; }, leak);
    expect_caught(SafetyRule::off, from_500([](SafetyInput& i) { i.on = false; }), leak);
    expect_caught(
        SafetyRule::panic, [](int tick, SafetyInput& input) { input.panic = tick == 400; }, leak);
    const auto bursts = [](int tick, SafetyInput& input) {
        if (tick == 300 || tick == 350 || tick == 400) input.wanted = vec3(1e300);
    };
    expect_caught(SafetyRule::shut_off, bursts, leak);
}

TEST(HapticsSafetyAudit, CountsTicksAndHeat) {
    SafetyAudit audit;
    const auto limits = safety_limits(omni_like(), 1);
    for (int tick = 0; tick < 25'000; ++tick) audit.record(limits, {.wanted = {0.5, 0, 0}}, {0.5, 0, 0});
    EXPECT_EQ(audit.ticks(), 25'000U);
    EXPECT_NEAR(audit.warmth(), 0.5, 1e-12);
    // Only the jump of the force at the start violates a rule.
    EXPECT_EQ(audit.violations(), audit.violations(SafetyRule::slew));
    for (int tick = 0; tick < 9000; ++tick) audit.record(limits, {}, {});
    EXPECT_NEAR(audit.warmth(), 0.5 * std::sqrt(0.1), 1e-12);
}

}  // namespace
}  // namespace thaum::haptics
