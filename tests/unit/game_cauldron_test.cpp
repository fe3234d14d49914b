// The cauldron in the match: the same with any number of threads, restored, and absent where the rules have none.
#include "game/cauldron/cauldron.h"

#include <gtest/gtest.h>

#include "game/components/grip.h"
#include "game/match/touch.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

input::DeviceSpec mouse(std::uint32_t player) {
    return {.player = player, .kind = input::DeviceKind::script, .name = "mouse", .look_rad_per_count = 1e-3};
}

/// Two players at opposite sides of the rim, with a thing above the bowl.
std::unique_ptr<Simulation> at_the_rim(unsigned workers, std::vector<std::string> overrides = {}) {
    auto match = std::make_unique<Simulation>(
        duel_data(std::move(overrides)),
        MatchSetup{.seed = 4, .devices = {mouse(0), mouse(1)}, .workers = workers});
    auto& world = match->world_to_change();
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto wizard = wizard_of(world, player);
        auto& motion = world.get<Motion>(wizard);
        motion.position = {player == 0 ? -2.2 : 2.2, match->data().wizard.height / 2, 0};
        match->physics().set_state(wizard.index, motion);
    }
    return match;
}

/// Both hold Stir and go round, one faster than the other.
input::InputFrame stirring(Tick tick) {
    input::InputFrame frame;
    for (std::size_t player = 0; player < players; ++player) {
        const double angle = 2 * pi * static_cast<double>(tick) / (player == 0 ? 800 : 1300);
        auto& sample = frame.devices[player];
        sample.press(input::Button::stir);
        sample.counts[input::hand::look_right] = static_cast<std::int32_t>(std::lround(3 * det::cos(angle)));
        sample.counts[input::hand::look_up] = static_cast<std::int32_t>(std::lround(3 * det::sin(angle)));
    }
    return frame;
}

TEST(GameCauldron, TheSameWithAnyNumberOfThreads) {
    std::vector<std::uint64_t> expected;
    for (const unsigned workers : {0U, 1U, 2U}) {
        const auto match = at_the_rim(workers);
        for (Tick t = 0; t < 1200; ++t) {
            match->tick(stirring(t));
            if (t % 40 != 39) continue;
            if (workers == 0) {
                expected.push_back(match->state_hash());
            } else {
                ASSERT_EQ(match->state_hash(), expected[t / 40]) << workers << " workers, tick " << t;
            }
        }
        EXPECT_GT(match->world().single<Cauldron>().speed, 0.1) << "it was stirred";
    }
}

TEST(GameCauldron, RestoredWhileItIsStirredItGoesOnToTheSameBits) {
    const auto match = at_the_rim(0);
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(stirring(t));
    match->save(saved);
    for (Tick t = 0; t < 300; ++t) match->tick(stirring(keyframe_interval + t));
    const auto again = at_the_rim(1);
    for (Tick t = 0; t < 100; ++t) again->tick(stirring(3 * t));  // some other history first
    ASSERT_TRUE(again->restore(saved, keyframe_interval));
    for (Tick t = 0; t < 300; ++t) again->tick(stirring(keyframe_interval + t));
    EXPECT_EQ(again->state_hash(), match->state_hash());
    EXPECT_EQ(again->force_hash(), match->force_hash());
}

TEST(GameCauldron, WhatTheLadleGivesTheBrewGetsAndNotWhatTheHandIsTold) {
    // Forces off: the hand is told nothing, and stirs as hard.
    const auto felt = at_the_rim(0), unfelt = at_the_rim(0, {"haptics.share=0"});
    for (Tick t = 0; t < 400; ++t) {
        felt->tick(stirring(t));
        unfelt->tick(stirring(t));
    }
    const auto speed = [](const Simulation& match) { return match.world().single<Cauldron>().speed; };
    EXPECT_GT(speed(*unfelt), 0.8 * speed(*felt));
    EXPECT_EQ(glm::length(unfelt->world().get<Grip>(wizard_of(unfelt->world(), 0)).servo.safety.output), 0);
}

TEST(GameCauldron, ThereIsNoneByClassicRules) {
    DataChoice choice;
    choice.rules = "classic";
    auto data = load_match_data(assets(), choice);
    ASSERT_TRUE(data.has_value());
    EXPECT_FALSE(data->cauldron.has_value());
    Simulation match(std::make_shared<const MatchData>(std::move(*data)), {.devices = {mouse(0), mouse(1)}});
    for (Tick t = 0; t < 100; ++t) match.tick(stirring(t));
    EXPECT_EQ(match.world().count<Cauldron>(), 0U);
    EXPECT_EQ(match.brew(), nullptr);
}

TEST(GameCauldron, TheBasinIsTheBowlsInside) {
    const BowlSize bowl{.radius = 1.5, .height = 1.1, .thickness = 0.15};
    const auto basin = basin_of(bowl, 0.88);
    EXPECT_EQ(basin.profile.front().y, 0);
    EXPECT_EQ(basin.profile.back().x, 0);
    EXPECT_NEAR(basin.radius, 1.35, 1e-12);
    EXPECT_EQ(width_at(basin, -basin.depth - 0.01), 0);
    EXPECT_NEAR(width_at(basin, 0.5), basin.profile.front().x, 1e-12);
    for (std::size_t i = 1; i < basin.profile.size(); ++i) {
        const vec2 middle = 0.5 * (basin.profile[i - 1] + basin.profile[i]);
        EXPECT_NEAR(width_at(basin, middle.y), middle.x, 1e-12);
    }
}

TEST(GameCauldron, WhoWalksOverTwoNichesCarriesOne) {
    const auto match = at_the_rim(0, {"cauldron.brewing.niche_radius_m=5"});
    for (Tick t = 0; t < 64; ++t) match->tick({});
    const auto& world = match->world();
    for (std::uint32_t player = 0; player < players; ++player)
        EXPECT_TRUE(world.has<Pouch>(wizard_of(world, player)));
    std::size_t taken = 0;
    world.view<const Niche>().each([&](const Niche& niche) { taken += niche.back_at > 0 ? 1U : 0U; });
    EXPECT_EQ(taken, players);
}

TEST(GameCauldron, AFourthIngredientStaysInTheHand) {
    const auto match = at_the_rim(0);
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    input::InputFrame held, pressed;
    held.devices[0].press(input::Button::stir);
    pressed.devices[0].buttons = held.devices[0].buttons | input::bit(input::Button::fire);
    for (Tick t = 0; t < 16; ++t) match->tick(held);
    for (std::uint32_t ingredient = 0; ingredient < 4; ++ingredient) {
        if (!world.has<Pouch>(wizard)) world.add(wizard, Pouch{.ingredient = ingredient});
        for (Tick t = 0; t < 8; ++t) match->tick(pressed);
        for (Tick t = 0; t < 40; ++t) match->tick(held);
        EXPECT_EQ(world.has<Pouch>(wizard), ingredient == 3) << ingredient;
    }
    const auto& what = match->world().single<Cauldron>().what;
    EXPECT_EQ(what, (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(GameCauldron, AnotherRoundBeginsWithAStillBrew) {
    // What burst at the brew in the last round is not told again.
    const auto match = at_the_rim(0, {"quick.seconds=1", "quick.rounds=3", "quick.interval_s=0.1"});
    auto& world = match->world_to_change();
    const auto middle = match->world().single<Cauldron>().middle;
    record(world, {.tick = 1, .kind = EventKind::burst, .subject = 0, .by = 0, .amount = 1, .place = middle});
    for (Tick t = 0; t < 40; ++t) match->tick({});
    EXPECT_NE(match->brew(), nullptr) << "the burst was felt";
    for (Tick t = 0; t < 1200; ++t) match->tick({});
    ASSERT_EQ(match->match().round, 1U);
    EXPECT_EQ(match->brew(), nullptr);
}

TEST(GameCauldron, StrokesOfOneThingBecomeOneAndWhatDoesNotFitIsRefusedOrKept) {
    Cauldron cauldron;
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {1, 0, 0}, .ingredient = no_ingredient, .by = 7}));
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {0, 2, 0}, .ingredient = no_ingredient, .by = 7}));
    EXPECT_EQ(cauldron.next.count, players + 1);
    EXPECT_EQ(cauldron.next.list[players].impulse, vec3(1, 2, 0));
    while (cauldron.next.count < most_strokes)
        ASSERT_TRUE(add_stroke(cauldron, {.amount = 1, .ingredient = 0}));
    EXPECT_FALSE(add_stroke(cauldron, {.amount = 1, .ingredient = 0}));
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {0, 0, 3}, .ingredient = no_ingredient}));
    EXPECT_EQ(cauldron.next.count, most_strokes);
}

}  // namespace
}  // namespace thaum::game::test
