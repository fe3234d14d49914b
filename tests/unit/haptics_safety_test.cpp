// Tests of the safety stage (the last part of the servo, which limits forces), rule by rule.
#include "haptics/safety.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/random.h"
#include "haptics/audit/safety_audit.h"
#include "tests/scenes/safety_attack.h"
#include "unit/omni_like.h"

namespace thaum::haptics {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A safety stage with its audit, an independent check of its output. A test fails if the audit counts a
/// violation of a rule.
struct Stage {
    SafetyLimits limits = safety_limits(omni_like(), 1);
    SafetyState state{};
    SafetyAudit audit{};

    Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() { EXPECT_EQ(audit.violations(), 0); }

    vec3 feel(const SafetyInput& input) {
        const vec3 output = make_safe(limits, state, input);
        audit.record(limits, input, output);
        return output;
    }
    vec3 feel(vec3 wanted) { return feel(SafetyInput{.wanted = wanted}); }
    vec3 feel(const SafetyInput& input, int ticks) {
        for (int i = 1; i < ticks; ++i) feel(input);
        return feel(input);
    }
    SafetyCause cause() const { return static_cast<SafetyCause>(state.cause); }
};

TEST(HapticsSafety, LimitsComeFromTheDeviceAndThePlayersShare) {
    const auto limits = safety_limits(omni_like(), gentle_share);
    EXPECT_DOUBLE_EQ(limits.cap, 1.485);
    EXPECT_DOUBLE_EQ(limits.excess, 13.2);
    EXPECT_DOUBLE_EQ(limits.spring_excess, 165);
    EXPECT_EQ(limits.continuous, 0.88);
    EXPECT_EQ(limits.slew, 40);
    for (const double none : {0.0, -1.0, not_a_number})
        EXPECT_EQ(safety_limits(omni_like(), none).cap, 0) << none;
    EXPECT_EQ(safety_limits(omni_like(), 7).cap, 3.3);
}

/// A driver may not know which force its motors can hold continuously. Such an arm is neither useless from
/// the start nor unlimited: it may give a burst at its peak force, and then less than any known arm can hold.
TEST(HapticsSafety, AnUnknownContinuousForceIsASmallOne) {
    auto spec = omni_like();
    spec.continuous_force = 0;
    Stage stage;
    stage.limits = safety_limits(spec, 1);
    stage.feel({.wanted = vec3(0)}, 10);
    EXPECT_NEAR(stage.feel({.wanted = vec3(3, 0, 0)}, 200).x, 3, 1e-9);
    const double held = stage.feel({.wanted = vec3(3, 0, 0)}, 30'000).x;
    EXPECT_GT(held, 0.1 * spec.peak_force);
    EXPECT_LT(held, 0.165 * spec.peak_force);
}

TEST(HapticsSafety, NothingIsFeltBeforeAForceInRange) {
    Stage at_once;
    // The first force grows slowly, as after a switch of its source.
    EXPECT_NEAR(at_once.feel({2, 0, 0}).x, 0.04, 1e-12);
    Stage stage;
    EXPECT_EQ(stage.feel({3.31, 0, 0}), vec3(0));
    EXPECT_EQ(stage.cause(), SafetyCause::waiting);
    EXPECT_EQ(stage.feel({not_a_number, 0, 0}), vec3(0));
    // The start gate, which waits for a force in range, opens. The force grows slowly.
    EXPECT_NEAR(stage.feel({2, 0, 0}).x, 0.04, 1e-12);
    EXPECT_NEAR(stage.feel({2, 0, 0}).x, 0.08, 1e-12);
    EXPECT_NEAR(stage.feel({.wanted = {2, 0, 0}}, 48).x, 2, 1e-12);
    EXPECT_EQ(stage.feel({-2, 0, 0}).x, -2);  // after the ramp, the output follows the wanted force at once
    EXPECT_EQ(stage.feel({-2, 0, 0}), vec3(-2, 0, 0));
    EXPECT_EQ(stage.cause(), SafetyCause::none);
}

TEST(HapticsSafety, TheCapKeepsTheDirectionWhateverTheSize) {
    for (const double share : {0.0, gentle_share, 1.0}) {
        Stage stage;
        stage.limits = safety_limits(omni_like(), share);
        stage.limits.excess = unlimited;
        stage.feel(vec3(0));
        for (const double size : {3.300001, 5.0, 1e3, 1e200, 1e308}) {
            const vec3 force = stage.feel(size * vec3(0.6, 0, -0.8));
            EXPECT_LE(glm::length(force), stage.limits.cap);
            EXPECT_NEAR(glm::length(force - stage.limits.cap * vec3(0.6, 0, -0.8)), 0, 1e-12) << size;
            EXPECT_EQ(stage.cause(), SafetyCause::capped);
        }
    }
}

TEST(HapticsSafety, WhatIsNotFiniteIsZero) {
    for (const double bad : {not_a_number, unlimited, -unlimited}) {
        Stage stage;
        stage.feel({1, 0, 0});
        stage.feel({.wanted = {1, 0, 0}}, 30);
        EXPECT_EQ(stage.feel({1, bad, 0}), vec3(0));
        EXPECT_EQ(stage.feel({1, 0, 0}).x, 1);
        EXPECT_EQ(stage.state.excess_count, 1U);
    }
}

TEST(HapticsSafety, ASwitchSlewsAndWithinASourceNothingIsDelayed) {
    Stage stage;
    stage.feel(vec3(0));
    EXPECT_EQ(stage.feel({0, 2.5, 0}).y, 2.5);
    const vec3 first = stage.feel({.wanted = {2.5, 0, 0}, .switched = true});
    EXPECT_NEAR(glm::length(first - vec3(0, 2.5, 0)), 0.04, 1e-12);
    int ticks = 1;
    for (vec3 force = first; force != vec3(2.5, 0, 0); ++ticks) force = stage.feel({2.5, 0, 0});
    EXPECT_EQ(ticks, static_cast<int>(std::ceil(2.5 * std::sqrt(2.0) / 0.04)));
    EXPECT_EQ(stage.feel(vec3(0)), vec3(0));
}

TEST(HapticsSafety, WhileASwitchFadesTheSourceIsNotDelayed) {
    // A spring whose force swings by 0.4 N in 6 ms changes two and a half times as fast as the slew limit
    // allows. The output nevertheless reaches it within 50 ms.
    Stage stage;
    stage.feel(vec3(0));
    const auto swings = [](int tick) { return vec3(2 + 0.4 * std::sin(1e-3 * 250 * tick), 0, 0); };
    stage.feel({.wanted = swings(0), .switched = true});
    for (int tick = 1; tick < 50; ++tick) {
        const double offset = -2.0 * (1 - (tick + 1) / 50.0);
        EXPECT_NEAR(stage.feel(swings(tick)).x - swings(tick).x, offset, 1e-9) << tick;
    }
    for (int tick = 50; tick < 100; ++tick) EXPECT_EQ(stage.feel(swings(tick)), swings(tick)) << tick;
}

TEST(HapticsSafety, AFadeEndsWithinTwiceTheCapWhateverIsWanted) {
    Random random{3};
    for (int round = 0; round < 200; ++round) {
        Stage stage;
        stage.limits.continuous = 1e3;  // so that the heat limit does not hide the force
        stage.feel(vec3(0));
        const auto anything = [&random] {
            return vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
        };
        stage.feel({.wanted = anything()}, 100);
        stage.feel({.wanted = anything(), .switched = true});
        for (int tick = 1; tick < 2 * 3.3 / 0.04; ++tick) stage.feel(anything());
        const vec3 last = stage.feel({0, 1.5, 0});
        EXPECT_EQ(last, vec3(0, 1.5, 0)) << round;
    }
}

TEST(HapticsSafety, AHandThatYieldsToWhatFadesIsLetGoOf) {
    // The force of a removed source fades by 40 N/s. A hand that yields to it receives 0.01 J and no more.
    for (const double speed : {0.01, 0.1, 0.5}) {
        for (const double way : {1.0, -1.0}) {
            Stage stage;
            stage.feel({.wanted = {3, 0, 0}}, 100);
            SafetyInput gone{.switched = true};
            double given = 0, taken = 0;
            for (int tick = 0; tick < 100; ++tick) {
                const double force = stage.feel(gone).x;
                EXPECT_LE(force, std::max(0.0, 3 - 0.04 * (tick + 1)) + 1e-9);
                EXPECT_GE(force, 0);
                (way > 0 ? given : taken) += force * speed * tick_seconds;
                gone.switched = false;
                gone.tip.x += way * speed * tick_seconds;
            }
            EXPECT_LE(given, switch_energy + 3 * speed * tick_seconds) << "all but the last tick is known";
            if (way < 0) {
                EXPECT_NEAR(taken, 3 * 3 / 80.0 * speed, 0.07 * speed) << "it resists as long as it may";
            }
        }
    }
}

TEST(HapticsSafety, TheCapDoesNotSwallowTheBrake) {
    Stage stage;
    stage.feel(vec3(0));
    const vec3 far{50, 0, 0};
    EXPECT_NEAR(stage.feel({.wanted = far, .spring = far}).x, 3.3, 1e-12);
    EXPECT_NEAR(stage.feel({.wanted = far, .spring = far, .brake = {-2, 0, 0}}).x, 1.3, 1e-12);
    EXPECT_NEAR(stage.feel({.wanted = far, .spring = far, .brake = {2, 0, 0}}).x, 3.3, 1e-12);
    EXPECT_NEAR(stage.state.unrequested.x, 0, 1e-12) << "what the cap let through of it";
    EXPECT_NEAR(stage.feel({.wanted = far, .spring = far, .brake = {not_a_number, 0, 0}}).x, 3.3, 1e-12);
}

TEST(HapticsSafety, ForcesThatAPlayerSwitchesOffRampToZero) {
    Stage stage;
    stage.feel({.wanted = {2, 0, 0}}, 60);
    SafetyInput off{.wanted = {2, 0, 0}, .on = false};
    for (int tick = 1; tick <= 50; ++tick) {
        EXPECT_NEAR(stage.feel(off).x, 2 * (1 - tick / 50.0), 1e-12);
        EXPECT_EQ(stage.cause(), SafetyCause::off);
    }
    EXPECT_EQ(stage.feel(off), vec3(0));
    EXPECT_NEAR(stage.feel({2, 0, 0}).x, 0.04, 1e-12);
    stage.feel({.wanted = {2, 0, 0}}, 60);
    off.velocity = {5, 0, 0};
    EXPECT_EQ(stage.feel(off), vec3(0)) << "a hand that is too fast gets none at once";
}

TEST(HapticsSafety, PanicIsZeroAtOnceAndComesBackSlowly) {
    Stage stage;
    stage.feel({.wanted = {2, 0, 0}}, 60);
    EXPECT_EQ(stage.feel({.wanted = {2, 0, 0}, .panic = true}), vec3(0));
    // The emergency key has been pressed, so forces stay off.
    EXPECT_EQ(stage.feel({.wanted = {2, 0, 0}}, 100'000), vec3(0));
    EXPECT_EQ(stage.cause(), SafetyCause::panic);
    // An emergency key that is still down has priority. Then a first wanted force out of range keeps the
    // start gate shut, which waits for one in range, so no force passes.
    EXPECT_EQ(stage.feel({.wanted = {2, 0, 0}, .panic = true, .rearm = true}), vec3(0));
    EXPECT_EQ(stage.feel({.wanted = {5, 0, 0}, .rearm = true}), vec3(0));
    EXPECT_EQ(stage.cause(), SafetyCause::waiting);
    EXPECT_EQ(stage.feel({5, 0, 0}), vec3(0));
    EXPECT_NEAR(stage.feel({2, 0, 0}).x, 0.04, 1e-12);
    // A needless request to switch forces on again changes nothing. The key for it, when held, must not keep
    // the start gate shut.
    EXPECT_NEAR(stage.feel({.wanted = {2, 0, 0}, .rearm = true}).x, 0.08, 1e-12);
}

TEST(HapticsSafety, ADeadModelRampsDownOnceAndStaysAtZero) {
    Stage stage;
    stage.feel({.wanted = {2, -1, 0}}, 100);
    EXPECT_EQ(stage.feel({.wanted = {2, -1, 0}, .model_age = 20}), vec3(2, -1, 0));
    for (std::uint32_t tick = 1; tick <= 50; ++tick) {
        const vec3 force = stage.feel({.wanted = {3, 3, 3}, .model_age = 20 + tick});
        EXPECT_NEAR(glm::length(force - vec3(2, -1, 0) * (1 - tick / 50.0)), 0, 1e-12) << tick;
        EXPECT_EQ(stage.cause(), SafetyCause::stale);
    }
    EXPECT_EQ(stage.feel({.wanted = {2, -1, 0}, .model_age = 4'000'000'000}, 200), vec3(0));
    EXPECT_NEAR(glm::length(stage.feel({2, -1, 0})), 0.04, 1e-12);
    // A jump of the haptic model's age does not shorten the ramp.
    stage.feel({.wanted = {2, -1, 0}}, 100);
    EXPECT_NEAR(stage.feel({.wanted = {2, -1, 0}, .model_age = 5000}).x, 2 * 0.98, 1e-12);
}

TEST(HapticsSafety, AHandThatFliesIsLeftAloneUntilItHasBeenSlow) {
    for (const vec3 wild :
         {vec3(0, 4.001, 0), vec3(1e300), vec3(not_a_number, 0, 0), vec3(0, -unlimited, 0)}) {
        Stage stage;
        stage.feel({.wanted = {1, 0, 0}, .velocity = {0, 0, 4}}, 60);
        EXPECT_EQ(stage.state.output.x, 1);
        const auto at = [](double speed) {
            return SafetyInput{.wanted = {1, 0, 0}, .velocity = {speed, 0, 0}};
        };
        EXPECT_EQ(stage.feel({.wanted = {1, 0, 0}, .velocity = wild}), vec3(0));
        EXPECT_EQ(stage.cause(), SafetyCause::over_speed);
        EXPECT_EQ(stage.feel(at(1.9), 99), vec3(0));
        EXPECT_EQ(stage.feel(at(2)), vec3(0));  // 2 m/s is not slow enough: the waiting time starts again
        EXPECT_EQ(stage.feel(at(1.9), 100), vec3(0));
        // Once forces are on again after the cut for too high a speed, an ordinary speed is allowed again.
        EXPECT_NEAR(stage.feel(at(3.9)).x, 0.04, 1e-12);
    }
}

TEST(HapticsSafety, ThreeBurstsOfExcessInTenSecondsShutItOff) {
    const vec3 calm{0.5, 0, 0}, wild{0, 14, 0};
    const auto bursts = [&](Stage& stage, std::initializer_list<int> pauses) {
        stage.feel({.wanted = calm}, 100);
        stage.feel(wild);
        for (const int pause : pauses) {
            stage.feel({.wanted = calm}, pause);
            stage.feel(wild);
        }
        return stage.cause() == SafetyCause::shut_off;
    };
    const auto shuts_off = [&bursts](std::initializer_list<int> pauses) {
        Stage stage;
        return bursts(stage, pauses);
    };
    EXPECT_FALSE(shuts_off({21}));
    EXPECT_TRUE(shuts_off({20, 20}));
    EXPECT_FALSE(shuts_off({19, 19, 19, 19, 19}));  // a single long burst
    // Three bursts of too large a force within 10 s, counted from start to start.
    EXPECT_TRUE(shuts_off({4999, 4999}));
    EXPECT_FALSE(shuts_off({4999, 5000}));
    EXPECT_TRUE(shuts_off({9000, 2000, 100}));  // four bursts, of which the last three are within 10 s

    Stage stage;
    ASSERT_TRUE(bursts(stage, {100, 100}));
    EXPECT_EQ(stage.feel({.wanted = calm}, 50'000), vec3(0));
    EXPECT_NEAR(stage.feel({.wanted = calm, .rearm = true}).x, 0.04, 1e-12);
    EXPECT_FALSE(bursts(stage, {100}));  // switching forces on again has set the number of bursts to zero
}

TEST(HapticsSafety, ASpringThatTheWorldStretchesClipsAndIsNoFault) {
    const auto shut_off_by = [](const SafetyInput& wild) {
        Stage stage;
        for (int burst = 0; burst < 5; ++burst) {
            stage.feel({.wanted = {0.5, 0, 0}}, 100);
            stage.feel(wild, 30);
        }
        return stage.cause() == SafetyCause::shut_off;
    };
    EXPECT_FALSE(shut_off_by({.wanted = {0, 125, 0}, .spring = {0, 125, 0}}));
    EXPECT_FALSE(shut_off_by({.wanted = {0, 125, 13}, .spring = {0, 125, 0}}));
    // The force is shut off because of the part that is added to the spring's.
    EXPECT_TRUE(shut_off_by({.wanted = {0, 125, 14}, .spring = {0, 125, 0}}));
    // The force is shut off because the spring is stretched beyond its limit.
    EXPECT_TRUE(shut_off_by({.wanted = {0, 166, 0}, .spring = {0, 166, 0}}));
    // The force is shut off because of the part of the force that is not the spring's.
    EXPECT_TRUE(shut_off_by({.wanted = {0, 1, 0}, .spring = {0, 20, 0}}));
    EXPECT_TRUE(shut_off_by({.wanted = {0, 1, 0}, .spring = {0, not_a_number, 0}}));
    EXPECT_TRUE(shut_off_by({.wanted = {0, not_a_number, 0}, .spring = {0, 1, 0}}));
}

TEST(HapticsSafety, AFullLobPullUsesTheWholeBudget) {
    // 2.75 N for 1 s equals 0.87 N for 10 s, as a root mean square; an Omni allows 0.88 N. The stage passes
    // this burst unchanged for 0.8 s. It may reduce the rest, which uses the last fifth of the heat budget. A
    // second burst right after it is reduced, because the motors are warm.
    Stage stage;
    stage.feel(vec3(0));
    double asked = 0;
    for (int tick = 0; tick < 1000; ++tick) {
        const double force = stage.feel({0, 0, 2.75}).z;
        EXPECT_TRUE(tick >= 800 || force == 2.75) << tick;
        asked += 2.75 * 2.75;
    }
    EXPECT_NEAR(std::sqrt(asked / 10'000), 0.87, 0.001);
    EXPECT_EQ(stage.cause(), SafetyCause::warm);
    EXPECT_GT(stage.audit.warmth(), 0.82);
    EXPECT_LT(stage.audit.warmth(), 0.88);
    EXPECT_LT(stage.feel({0, 0, 2.75}).z, 0.75 * 2.75);
    RecordProperty("rms_n", std::to_string(stage.audit.warmth()));
}

TEST(HapticsSafety, HeatIsSharedOutSmoothlyAndNeverTooMuch) {
    // A force comes and goes for a minute, at times that are worst for a stage that sums heat in bins. In
    // this stage the window of 10 s moves tick by tick, so no times are worse than others.
    for (const int period : {1, 333, 500, 1499, 10'000, 60'000}) {
        Stage stage;
        stage.feel(vec3(0));
        std::vector<double> squares;
        double sum = 0, most = 0, before = 0, jump = 0;
        bool wanted_before = false;
        for (int tick = 0; tick < 60'000; ++tick) {
            const bool wants = tick / period % 2 == 0;
            const double force = stage.feel(wants ? vec3(3.3, 0, 0) : vec3(0)).x;
            squares.push_back(force * force);
            sum += squares.back() - (tick >= 10'000 ? squares[static_cast<std::size_t>(tick) - 10'000] : 0);
            most = std::max(most, sum);
            if (wants && wanted_before) jump = std::max(jump, std::abs(force - before));
            before = force;
            wanted_before = wants;
        }
        EXPECT_LE(std::sqrt(most / 10'000), 0.88) << period;
        EXPECT_GE(std::sqrt(most / 10'000), 0.83) << period;  // the output is not limited more than necessary
        EXPECT_LE(jump, 0.1) << period;                       // change within a tick, up or down (N)
    }
}

TEST(HapticsSafety, AHandThatPressesOnIsLedToTheContinuousForceAndKeptThere) {
    // A burst takes nine tenths of the heat budget of 10 s. The remaining tenth is spread evenly until the
    // burst is 10 s old, which no control law can avoid. Then the force approaches the force that the motors
    // can hold continuously, and no second burst follows.
    const double budget = 0.88 * 0.88 * 10,
                 last = 0.88 * std::sqrt(10 / 10.5);  // final force (N): 0.88 N for 10 s, spread over 10.5 s
    for (const double wanted : {3.3, 2.0, 1.2}) {
        Stage stage;
        stage.feel(vec3(0));
        double heat = 0, floor = 0, before = wanted, jump = 0;
        bool fell = false;
        for (int tick = 1; tick < 60'000; ++tick) {
            const double force = stage.feel({0, wanted, 0}).y;
            const double seconds = tick * tick_seconds;
            jump = std::max(jump, std::abs(force - before));
            if (fell) {
                EXPECT_GE(force, before - 1e-9) << wanted << " at " << seconds;
            }
            if (seconds > 6 && !fell) {
                fell = true;
                floor = force;
                EXPECT_NEAR(floor, std::sqrt((budget - heat) / (10.5 - seconds)), 1e-6) << wanted;
                EXPECT_GT(floor, 0.3 * 0.88) << wanted;
            }
            if (seconds > 6 && seconds < 10.499) {
                EXPECT_NEAR(force, floor, 1e-6) << seconds;
            }
            if (seconds > 10.5) {
                EXPECT_NEAR(force, last - (last - floor) * std::exp((10.499 - seconds) / 0.5), 0.01)
                    << wanted << " at " << seconds;
            }
            heat += force * force * tick_seconds;
            before = force;
        }
        EXPECT_NEAR(before, last, 1e-9) << wanted;
        EXPECT_LE(jump, 0.1) << wanted;
        EXPECT_LE(stage.audit.warmth(), 0.88) << wanted;
    }
}

TEST(HapticsSafety, ALowerCapOnWarmMotorsMakesNoJump) {
    for (int ticks = 1300; ticks <= 1440; ticks += 20) {
        Stage stage;
        stage.feel(vec3(0));
        double before = stage.feel({.wanted = {2.2, 0, 0}}, ticks).x;
        stage.limits = with_share(stage.limits, 0.35);
        for (int tick = 0; tick < 20; ++tick) {
            const double force = stage.feel({2.2, 0, 0}).x;
            EXPECT_LE(before - force, cap_slew * tick_seconds + 1e-12) << ticks << " and " << tick;
            before = force;
        }
        EXPECT_LE(before, stage.limits.cap);
    }
}

TEST(HapticsSafety, WhoLetsGoAndRestsHasABurstAgain) {
    Stage stage;
    stage.feel(vec3(0));
    stage.feel({.wanted = {3.3, 0, 0}}, 5000);
    EXPECT_EQ(stage.cause(), SafetyCause::warm);
    stage.feel({.wanted = {}}, 10'500);
    EXPECT_EQ(stage.cause(), SafetyCause::none);
    for (int tick = 0; tick < 500; ++tick) EXPECT_EQ(stage.feel({3.3, 0, 0}).x, 3.3) << tick;
}

TEST(HapticsSafety, WhatTheMotorsBearIsNotHeldBackHoweverWarmTheyAre) {
    Stage stage;
    stage.feel(vec3(0));
    stage.feel({.wanted = {3.3, 0, 0}}, 2000);
    const double bearable = stage.state.output.x;
    for (int tick = 0; tick < 5000; ++tick) EXPECT_EQ(stage.feel({0.9 * bearable, 0, 0}).x, 0.9 * bearable);
    EXPECT_EQ(stage.cause(), SafetyCause::none);
}

TEST(HapticsSafety, AFastPathIsAFastHandThoughItLeadsNowhere) {
    for (const double fast : {4.001, 1e300, unlimited, not_a_number}) {
        Stage stage;
        stage.feel({.wanted = {1, 0, 0}, .path_speed = 4}, 60);
        EXPECT_EQ(stage.state.output.x, 1);
        EXPECT_EQ(stage.feel({.wanted = {1, 0, 0}, .path_speed = fast}), vec3(0)) << fast;
        EXPECT_EQ(stage.cause(), SafetyCause::over_speed);
        EXPECT_EQ(stage.feel({.wanted = {1, 0, 0}, .path_speed = 1.9}, 99), vec3(0));
        EXPECT_EQ(stage.feel({.wanted = {1, 0, 0}, .path_speed = 2}), vec3(0));
        EXPECT_EQ(stage.feel({.wanted = {1, 0, 0}, .path_speed = 1.9}, 100), vec3(0));
        EXPECT_NEAR(stage.feel({1, 0, 0}).x, 0.04, 1e-12);
    }
}

TEST(HapticsSafety, TheGravestCauseIsReported) {
    Stage stage;
    SafetyInput input{.wanted = {5, 0, 0}};
    stage.feel(vec3(0));
    const auto cause = [&] { return stage.feel(input), stage.cause(); };
    EXPECT_EQ(cause(), SafetyCause::capped);
    input.model_age = 21;
    EXPECT_EQ(cause(), SafetyCause::stale);
    input.velocity = {5, 0, 0};
    EXPECT_EQ(cause(), SafetyCause::over_speed);
    input.on = false;
    EXPECT_EQ(cause(), SafetyCause::off);
    for (int burst = 0; burst < 3; ++burst) {
        stage.feel({.on = false}, 30);
        input.wanted = {unlimited, 0, 0};
        cause();
    }
    EXPECT_EQ(cause(), SafetyCause::shut_off);
    input.panic = true;
    EXPECT_EQ(cause(), SafetyCause::panic);
}

TEST(HapticsSafety, TheSameTicksGiveTheSameBits) {
    const auto run = [] {
        bench::SafetyAttack attack(omni_like(), 11);
        SafetyState state;
        std::uint64_t hash = 0;
        for (int tick = 0; tick < 20'000; ++tick) {
            const auto input = attack.next();
            make_safe(attack.limits(), state, input);
            hash = hash_value(state, hash);
        }
        return hash;
    };
    EXPECT_EQ(run(), run());
    // The hash must be the same in every build and on every processor. It changes only if the safety rules
    // are changed on purpose.
    EXPECT_EQ(run(), 740212102724250974ULL);
}

}  // namespace
}  // namespace thaum::haptics
