// Tests of turning a crystal and of its grain, which resists cuts into the hidden shape.
#include "game/stations/crystal/grain.h"

#include <gtest/gtest.h>

#include "unit/crystal_rig.h"

namespace thaum::game::test {
namespace {

// ---- turning a crystal ------------------------------------------------------------------------------------

TEST(Crystal, WalkingSidewaysTurnsItAndTheCarverStays) {
    const auto match = at_the_crystal(false);
    const auto wizard = wizard_of(match->world(), 0);
    run(*match, 40, held({input::Button::stir}));
    const auto place = match->world().get<Motion>(wizard).position;
    const auto yaw = crystal_in(*match).yaw;
    for (const int strafe : {127, -127}) {
        auto frame = held({input::Button::stir});
        frame.devices[0].counts[input::hand::strafe] = strafe;
        const auto from = crystal_in(*match).yaw;
        run(*match, 500, frame);
        EXPECT_NEAR(std::remainder(crystal_in(*match).yaw - from, 2 * pi), strafe > 0 ? pi / 6 : -pi / 6,
                    1e-3);
    }
    EXPECT_NEAR(std::remainder(crystal_in(*match).yaw - yaw, 2 * pi), 0, 1e-9);
    EXPECT_LT(glm::distance(match->world().get<Motion>(wizard).position, place), 0.01) << "nobody walks";
    auto drift = held({input::Button::stir});
    drift.devices[0].counts[input::hand::strafe] = 30;
    run(*match, 500, drift);
    EXPECT_NEAR(std::remainder(crystal_in(*match).yaw - yaw, 2 * pi), 0, 1e-9)
        << "a stick that leans a little";
}

TEST(Crystal, ItShowsItsFlatSideToTheOneWhoBegins) {
    const auto match = at_the_crystal(false);
    const vec3 middle = crystal_in(*match).middle;
    bench::stand(*match, 0, {middle.x - 1.5, match->data().wizard.height / 2, middle.z});
    run(*match, 40, held({input::Button::stir}));
    EXPECT_NEAR(std::abs(std::remainder(crystal_in(*match).yaw, pi)), pi / 2, 0.01);
    const auto yaw = crystal_in(*match).yaw;
    bench::stand(*match, 1, {middle.x, match->data().wizard.height / 2, middle.z + 1.5});
    auto frame = held({input::Button::stir});
    frame.devices[1].press(input::Button::stir);
    run(*match, 40, frame);
    ASSERT_EQ(match->world().count<Chisel>(), 2U);
    EXPECT_EQ(crystal_in(*match).yaw, yaw) << "not while another carves it";
}

TEST(Crystal, AHandThatRestsFeelsItTurnAtOnce) {
    const auto match = at_the_crystal(false);
    const auto wizard = wizard_of(match->world(), 0);
    const auto force = [&] { return match->world().get<HandState>(wizard).servo.safety.output; };
    auto frame = held({input::Button::stir});
    frame.devices[0].counts[input::hand::forward] = 127;
    for (Tick t = 0; t < 2000 && glm::length(force()) < 0.3; ++t) match->tick(frame);
    frame.devices[0].counts[input::hand::forward] = 0;
    run(*match, 1000, frame);
    const vec3 still = force();
    ASSERT_GT(glm::length(still), 0.2) << "pressed";
    run(*match, 100, frame);
    EXPECT_LT(glm::distance(force(), still), 0.005) << "nothing moves";
    frame.devices[0].counts[input::hand::strafe] = 127;
    run(*match, 100, frame);
    EXPECT_GT(glm::distance(force(), still), 0.025);
}

TEST(Crystal, TurningUnderTheHandStaysWithinTheCapsAndCreatesNoEnergy) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto match = at_the_crystal(true, {}, seed);
        double turned = 0, felt = 0, before = crystal_in(*match).yaw;
        for (Tick t = 0; t < 8000; ++t) {
            auto frame = carving(t);
            frame.devices[0].counts[input::hand::strafe] = t % 1400 < 700 ? 127 : -127;
            // The hand presses forward during the first half of every 3 s.
            if (t % 3000 < 1500) frame.devices[0].counts[input::hand::forward] = 127;
            match->tick(frame);
            turned += std::abs(std::remainder(crystal_in(*match).yaw - before, 2 * pi));
            before = crystal_in(*match).yaw;
            for (std::uint32_t player = 0; player < players; ++player) {
                const auto& servo = match->world().get<HandState>(wizard_of(match->world(), player)).servo;
                const double force = glm::length(servo.safety.output);
                felt = std::max(felt, force);
                ASSERT_LE(force, force_cap(match->haptic_setup(), player) + 1e-9);
                ASSERT_LE(servo.energy.most_created, 0.02) << "seed " << seed << ", tick " << t;
            }
        }
        EXPECT_GT(turned, 2 * pi);
        EXPECT_GT(felt, 0.5) << "no hand has met the crystal";
    }
}

TEST(Crystal, TurnedAndRestoredItGoesOnToTheSameBits) {
    const auto turning = [](Tick t) {
        auto frame = carving(t);
        frame.devices[0].counts[input::hand::strafe] = 127;
        return frame;
    };
    const auto match = at_the_crystal();
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(turning(t));
    match->save(saved);
    for (Tick t = 0; t < 300; ++t) match->tick(turning(keyframe_interval + t));
    const auto again = at_the_crystal();
    ASSERT_TRUE(again->restore(saved, keyframe_interval));
    for (Tick t = 0; t < 300; ++t) again->tick(turning(keyframe_interval + t));
    EXPECT_EQ(again->state_hash(), match->state_hash());
    EXPECT_EQ(again->force_hash(), match->force_hash());
}

// ---- the grain of a crystal -------------------------------------------------------------------------------

/// Middle of a voxel for which `which(voxel)` is true: the voxel with the most such voxels around it
/// (crystal's frame).
template <class Which>
vec3 midst_of(const Crystal& crystal, Which which) {
    constexpr int side = crystal_side, around = 2;
    const auto at = [](int i, int j, int k) {
        const auto row = static_cast<std::size_t>(j) + std::size_t{side} * static_cast<std::size_t>(k);
        return static_cast<std::size_t>(i) + std::size_t{side} * row;
    };
    vec3 best(0);
    int most = -1;
    for (int k = around; k < side - around; ++k)
        for (int j = around; j < side - around; ++j)
            for (int i = around; i < side - around; ++i) {
                if (!which(at(i, j, k))) continue;
                int count = 0;
                for (int d = 0; d < 125; ++d)
                    count += which(at(i + d % 5 - 2, j + d / 5 % 5 - 2, k + d / 25 - 2)) ? 1 : 0;
                if (count > most) most = count, best = vec3(i, j, k);
            }
    return spacing_of(crystal) * (best - 0.5 * (side - 1));
}

TEST(Crystal, TheToolsWorthIsThatOfTheDab) {
    const auto match = at_the_crystal(false);
    run(*match, 40, held({input::Button::stir}));
    const auto& crystal = crystal_in(*match);
    const auto& inside = match->crystals().list[0].overlap.inside;
    const vec3 surplus = midst_of(crystal, [&](std::size_t i) { return inside[i] == 1; });
    const vec3 missing = midst_of(crystal, [&](std::size_t i) { return inside[i] == 2; });
    const vec3 done = midst_of(crystal, [&](std::size_t i) { return inside[i] == 3; });
    const vec3 nothing(-0.28, 0.28, 0.28);
    const auto& tools = match->data().crystal->tools;
    const auto worth = [&](std::size_t tool, vec3 place) {
        return worth_of_dab(match->context(), match->crystals(), crystal, tools.at(tool),
                            {.place = place, .seconds = 0.15});
    };
    const auto before = match->state_hash();
    const auto melt = std::array{worth(0, surplus), worth(0, missing), worth(0, done), worth(0, nothing)};
    EXPECT_EQ(melt, (std::array{DabWorth::helps, DabWorth::nothing, DabWorth::spoils, DabWorth::nothing}));
    const auto build = std::array{worth(1, surplus), worth(1, missing), worth(1, done), worth(1, nothing)};
    EXPECT_EQ(build, (std::array{DabWorth::nothing, DabWorth::helps, DabWorth::nothing, DabWorth::spoils}));
    EXPECT_EQ(worth(2, surplus), DabWorth::nothing) << "paint";
    EXPECT_EQ(worth(3, missing), DabWorth::helps) << "stamp";
    EXPECT_EQ(match->state_hash(), before);
    EXPECT_EQ(worth(0, vec3(9)), DabWorth::nothing) << "outside";
}

TEST(Crystal, WhatLeadsAwayFromTheKeyGoesSlowly) {
    const auto change = [](const char* share, bool wrong) {
        const auto match = at_the_crystal(false, {text("crystal.against_key=", share)});
        run(*match, 40, held({input::Button::stir}));
        const auto& inside = match->crystals().list[0].overlap.inside;
        auto& crystal = crystal_to_change(*match);
        const vec3 place = midst_of(crystal, [&](std::size_t i) { return inside[i] == (wrong ? 3 : 1); });
        const auto before = crystal.overlap;
        for (int i = 0; i < 40; ++i)
            carve_crystal(match->context_to_change(), match->crystals_to_change(), crystal,
                          match->data().crystal->tools[0], {.place = place, .seconds = 0.005});
        expect_full_count(*match, crystal, *match);
        return crystal.overlap - before;
    };
    EXPECT_LT(change("1", true), -0.002);
    EXPECT_GT(change("0.1", true), 0.25 * change("1", true));
    EXPECT_GT(change("0.1", false), 0.9 * change("1", false)) << "what leads to the key goes as fast";
}

}  // namespace
}  // namespace thaum::game::test
