// Tests of the cauldron in a match: it gives the same results with any number of threads and after a restore,
// and is absent if the rule set has none.
#include "game/stations/cauldron/cauldron.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "game/components/hand_state.h"
#include "game/match/hand/arm_system.h"
#include "input/arm_servo.h"
#include "tests/scenes/stirring_hands.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

input::DeviceSpec mouse(std::uint32_t player) {
    return {.player = player, .kind = input::DeviceKind::script, .name = "mouse", .look_rad_per_count = 1e-3};
}

/// A match with two players at opposite sides of the rim and an object above the bowl.
std::unique_ptr<Simulation> at_the_rim(MatchSetup setup, std::vector<std::string> overrides = {}) {
    auto match = std::make_unique<Simulation>(duel_data(std::move(overrides)), std::move(setup));
    bench::place_at_the_rim(*match);
    return match;
}

std::unique_ptr<Simulation> at_the_rim(unsigned workers, std::vector<std::string> overrides = {}) {
    return at_the_rim({.seed = 4, .devices = {mouse(0), mouse(1)}, .workers = workers}, std::move(overrides));
}

using bench::stirring;

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
        EXPECT_GT(match->world().single<Cauldron>().speed, 0.1) << "the brew was not stirred";
    }
}

TEST(GameCauldron, RestoredWhileItIsStirredItGoesOnToTheSameBits) {
    const auto match = at_the_rim(0);
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(stirring(t));
    match->save(saved);
    for (Tick t = 0; t < 300; ++t) match->tick(stirring(keyframe_interval + t));
    const auto again = at_the_rim(1);
    for (Tick t = 0; t < 100; ++t) again->tick(stirring(3 * t));  // so that this match has another history
    ASSERT_TRUE(again->restore(saved, keyframe_interval));
    for (Tick t = 0; t < 300; ++t) again->tick(stirring(keyframe_interval + t));
    EXPECT_EQ(again->state_hash(), match->state_hash());
    EXPECT_EQ(again->force_hash(), match->force_hash());
}

TEST(GameCauldron, TheBrewGetsTheLadlesPushAndNotTheForceOnTheHand) {
    // With its forces switched off the hand feels nothing, but stirs as strongly.
    const auto felt = at_the_rim(0), unfelt = at_the_rim(0, {"haptics.share=0"});
    for (Tick t = 0; t < 400; ++t) {
        felt->tick(stirring(t));
        unfelt->tick(stirring(t));
    }
    const auto speed = [](const Simulation& match) { return match.world().single<Cauldron>().speed; };
    EXPECT_GT(speed(*unfelt), 0.8 * speed(*felt));
    EXPECT_EQ(glm::length(unfelt->world().get<HandState>(wizard_of(unfelt->world(), 0)).servo.safety.output),
              0);
}

// ---- faders of the forces ---------------------------------------------------------------------------------

using Percents = std::array<std::uint32_t, input::fluid_faders>;

/// Player 1 stirs with an arm, which is moved along a fixed path whatever force it exerts. `percents` are how
/// strongly the player feels each effect of the brew.
struct HeldLadle {
    std::unique_ptr<Simulation> match;
    input::ArmServo servo{};
    std::vector<std::uint64_t> brews{};  ///< hash of the brew's components, every 16 ticks
    double felt = 0;                     ///< sum of the force's magnitude over the ticks (N)
    std::uint64_t forces = 0;            ///< hash of all forces

    explicit HeldLadle(const Percents& percents) {
        auto hand = mouse(0);
        for (std::size_t i = 0; i < percents.size(); ++i) hand.set_fluid_percent(i, percents[i]);
        match = at_the_rim(
            {.seed = 4,
             .devices = {hand, mouse(1), {.player = 0, .kind = input::DeviceKind::arm, .name = "arm"}}},
            {"cauldron.brew.cells_across=12", "haptics.share=1"});
        auto& world = match->world_to_change();
        world.add(wizard_of(world, 0), Pouch{.ingredient = 2});
    }

    /// Path of the arm (um): rest, a circle, out to the wall and back, up through the surface and down
    /// again.
    static std::array<std::int32_t, 3> hand_um(Tick tick) {
        const auto t = static_cast<std::int32_t>(tick);
        if (t < 400) return {};
        if (t < 900) {
            const double a = 2 * pi * (t - 400) / 500;
            return {static_cast<std::int32_t>(30e3 * det::sin(a)), 0,
                    static_cast<std::int32_t>(30e3 * (1 - det::cos(a)))};
        }
        const auto there_and_back = [](std::int32_t at, std::int32_t half) {
            return half - std::abs(at - half);
        };
        if (t < 1300) return {500 * there_and_back(t - 900, 200), 0, 0};
        return {0, 100 * there_and_back(t - 1300, 300), 0};
    }

    void run(Tick ticks) {
        for (Tick t = 0; t < ticks; ++t) {
            input::ArmReading reading{.time_ns = static_cast<std::int64_t>(t + 1) * 1'000'000};
            reading.position_um = hand_um(t);
            (void)servo.step(reading);
            input::InputFrame frame;
            frame.devices[0].press(input::Button::stir);
            if (t > 600 && t < 620) frame.devices[0].press(input::Button::fire);
            frame.devices[2] = servo.take();
            match->tick(frame);
            if (fill_order(match->world(), match->haptic_setup(), 0, servo.order())) servo.publish();
            const vec3 force =
                match->world().get<HandState>(wizard_of(match->world(), 0)).servo.safety.output;
            felt += glm::length(force);
            forces = hash_value(force, forces);
            if (t % 16 == 15) brews.push_back(hash_of_brew());
        }
    }

    std::uint64_t hash_of_brew() const {
        auto hash = hash_value(match->world().single<Cauldron>(), 1);
        hash = hash_bytes(std::as_bytes(match->world().blob<BrewSamples>()), hash);
        hash = hash_bytes(std::as_bytes(match->world().blob<SurfaceSamples>()), hash);
        return hash;
    }
};

TEST(GameCauldron, FadersTakeFromTheHandAndNothingFromTheBrew) {
    constexpr Tick length = 1900;
    HeldLadle all({100, 100, 100, 100, 100, 100, 100}), none(Percents{});
    all.run(length);
    none.run(length);
    EXPECT_GT(all.match->world().single<Cauldron>().speed, 0.02) << "the brew is not stirred";
    EXPECT_EQ(all.match->world().single<Cauldron>().contents[0], 2U) << "no ingredient was dropped";
    EXPECT_EQ(none.brews, all.brews);
    EXPECT_GT(all.felt, 0);
    EXPECT_EQ(none.felt, 0);
    for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i) {
        Percents one{};
        one[i] = 50;
        HeldLadle only(one);
        only.run(length);
        EXPECT_EQ(only.brews, all.brews) << haptics::fluid_modes[i].name;
        EXPECT_GT(only.felt, 1) << haptics::fluid_modes[i].name;
    }
}

TEST(GameCauldron, ClassicRulesHaveNoCauldron) {
    auto data = load_match_data(assets(), {.rules = "classic"}).value();
    EXPECT_FALSE(data.cauldron.has_value());
    Simulation match(std::make_shared<const MatchData>(std::move(data)), {.devices = {mouse(0), mouse(1)}});
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

TEST(GameCauldron, AWizardAtTwoNichesCarriesOneIngredient) {
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
    const auto& what = match->world().single<Cauldron>().contents;
    EXPECT_EQ(what, (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(GameCauldron, AnotherRoundBeginsWithAStillBrew) {
    // A burst (a stone that explodes over the brew), recorded in the previous round, must not act again.
    const auto match = at_the_rim(
        0, {"quick.seconds=1", "quick.rounds=3", "quick.interval_s=0.1", "quick.boil_over.seconds=0"});
    const auto middle = match->world().single<Cauldron>().middle;
    record(match->context_to_change(),
           {.tick = 1, .kind = EventKind::burst, .subject = 0, .by = 0, .amount = 1, .place = middle});
    for (Tick t = 0; t < 40; ++t) match->tick({});
    EXPECT_NE(match->brew(), nullptr) << "the burst was felt";
    for (Tick t = 0; t < 1200; ++t) match->tick({});
    ASSERT_EQ(match->match().round, 1U);
    EXPECT_EQ(match->brew(), nullptr);
}

TEST(GameCauldron, StrokesOfOneThingAreMergedAndAFullQueueKeepsMomentum) {
    Cauldron cauldron;
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {1, 0, 0}, .ingredient = no_ingredient, .by = 7}));
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {0, 2, 0}, .ingredient = no_ingredient, .by = 7}));
    EXPECT_EQ(cauldron.next.count, players + 1);
    EXPECT_EQ(cauldron.next.list[players].impulse, vec3(1, 2, 0));
    while (cauldron.next.count < max_strokes)
        ASSERT_TRUE(add_stroke(cauldron, {.amount = 1, .ingredient = 0}));
    EXPECT_FALSE(add_stroke(cauldron, {.amount = 1, .ingredient = 0}));
    EXPECT_TRUE(add_stroke(cauldron, {.impulse = {0, 0, 3}, .ingredient = no_ingredient}));
    EXPECT_EQ(cauldron.next.count, max_strokes);
}

}  // namespace
}  // namespace thaum::game::test
