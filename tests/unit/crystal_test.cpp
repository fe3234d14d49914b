// Tests of crystals in a match: touching, carving, chips, the Lens, rounds, restored states, and hostile input.
#include "game/crystal/crystal.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/file.h"
#include "core/text.h"
#include "game/arena/spawn.h"
#include "game/components/casting.h"
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/crystal/crystal_shape.h"
#include "game/crystal/grain.h"
#include "game/match/round.h"
#include "game/wands/shot.h"
#include "tools/bench/carving_hands.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using bench::carving;

std::unique_ptr<Simulation> at_the_crystal(bool both = true, std::vector<std::string> overrides = {},
                                           std::uint64_t seed = 3) {
    auto setup = two_hands();
    setup.seed = seed;
    auto match = std::make_unique<Simulation>(duel_data(std::move(overrides)), setup);
    bench::place_at_the_crystal(*match, both);
    return match;
}

const Crystal& crystal_in(const Simulation& match, std::uint32_t number = 0) {
    return match.world().get<Crystal>(crystal_entity(match.world(), number));
}
Crystal& crystal_to_change(Simulation& match, std::uint32_t number = 0) {
    return match.world_to_change().get<Crystal>(crystal_entity(match.world(), number));
}
std::span<float> densities(Simulation& match, std::uint32_t number = 0) {
    return match.world_to_change().blob<CrystalDensity>().subspan(number * crystal_voxels, crystal_voxels);
}
std::size_t count_of(const Simulation& match, EventKind kind) {
    std::uint64_t from = 0;
    std::size_t count = 0;
    match.events().each_new(from, [&](const Event& event) { count += event.kind == kind ? 1 : 0; });
    return count;
}
Event last_of(const Simulation& match, EventKind kind) {
    std::uint64_t from = 0;
    Event last;
    match.events().each_new(from, [&](const Event& event) {
        if (event.kind == kind) last = event;
    });
    return last;
}
void run(Simulation& match, Tick length, const input::InputFrame& frame = {}) {
    for (Tick t = 0; t < length; ++t) match.tick(frame);
}
input::InputFrame held(std::initializer_list<input::Button> buttons) {
    input::InputFrame frame;
    for (const auto button : buttons) frame.devices[0].press(button);
    return frame;
}
void expect_full_count(const Simulation& match, const Crystal& crystal, Simulation& changed) {
    const auto& body = match.crystals().list.at(crystal.number);
    const auto view = voxels_of(changed.world_to_change(), changed.crystals_to_change(), crystal);
    const auto full = field::overlap_with(view, body.key, crystal_surface);
    EXPECT_EQ(body.overlap.both, full.both);
    EXPECT_EQ(body.overlap.either, full.either);
    EXPECT_EQ(crystal.overlap, full.ratio());
}

// ---- touching ---------------------------------------------------------------------------------------------

TEST(Crystal, NobodysTouchMeansNoVoxels) {
    const auto match = at_the_crystal(false);
    run(*match, 200);
    EXPECT_EQ(match->world().count<Crystal>(), 2U);
    EXPECT_EQ(match->world().count<CrystalDensity>(), 0U);
    EXPECT_EQ(crystal_in(*match).touched, 0U);
    EXPECT_NE(crystal_in(*match, 0).seed, crystal_in(*match, 1).seed);
}

TEST(Crystal, AHandThatTouchesItMakesTheRoughBodyOfItsSeedOnly) {
    const auto match = at_the_crystal(false);
    run(*match, 40, held({input::Button::stir}));
    const auto& crystal = crystal_in(*match);
    EXPECT_EQ(crystal.touched, 1U);
    EXPECT_EQ(crystal_in(*match, 1).touched, 0U);
    const auto key = key_density(crystal.seed, crystal_side);
    const auto rough = rough_density(crystal.seed, key, crystal_side);
    EXPECT_TRUE(std::ranges::equal(densities(*match), rough));
    EXPECT_EQ(match->crystals().list[0].key, key);
    EXPECT_GT(crystal.overlap, 0.4);
    expect_full_count(*match, crystal, *match);
}

TEST(Crystal, TheOverlapOfKnownBodies) {
    const auto match = at_the_crystal(false);
    run(*match, 40, held({input::Button::stir}));
    auto& crystal = crystal_to_change(*match);
    const auto& key = match->crystals().list[0].key;
    const auto overlap_of = [&] {
        rebuild_crystals(match->context_to_change(), match->crystals_to_change());
        return match->crystals().list[0].overlap.ratio();
    };
    std::ranges::copy(key, densities(*match).begin());
    EXPECT_EQ(overlap_of(), 1);
    std::ranges::fill(densities(*match), 0.0F);
    EXPECT_EQ(overlap_of(), 0);
    std::ranges::fill(densities(*match), 1.0F);
    const auto volume = std::ranges::count_if(key, [](float d) { return d >= crystal_surface; });
    EXPECT_EQ(overlap_of(), static_cast<double>(volume) / static_cast<double>(crystal_voxels));
    EXPECT_EQ(crystal.touched, 1U);
}

// ---- carving ----------------------------------------------------------------------------------------------

TEST(Crystal, CountsWhileTwoCarveWithAllToolsAreThoseOfAFullCount) {
    const auto match = at_the_crystal();
    double least = 1, most = 0;
    for (Tick t = 0; t < 6000; ++t) {
        match->tick(carving(t));
        if (t % 500 != 499) continue;
        expect_full_count(*match, crystal_in(*match), *match);
        least = std::min(least, crystal_in(*match).overlap);
        most = std::max(most, crystal_in(*match).overlap);
    }
    EXPECT_GT(most - least, 0.005) << "nothing was carved";
    EXPECT_EQ(match->world().count<Chisel>(), 2U);
    EXPECT_GE(count_of(*match, EventKind::tool_taken), 4U);
}

TEST(Crystal, TwoCarversChangeMoreThanOne) {
    const auto changed = [](bool both) {
        const auto match = at_the_crystal(both);
        run(*match, 40, carving(0));
        std::vector<float> before(densities(*match).begin(), densities(*match).end());
        for (Tick t = 0; t < 700; ++t) match->tick(carving(t));
        std::size_t count = 0;
        for (std::size_t i = 0; i < before.size(); ++i) count += before[i] != densities(*match)[i] ? 1 : 0;
        return count;
    };
    const auto one = changed(false);
    EXPECT_GT(one, 50U);
    EXPECT_GT(changed(true), one + 50);
}

TEST(Crystal, ACutTakesFocusByTimeAndNoneWithoutFocus) {
    const auto match = at_the_crystal(false, {"casting.focus.regain_per_s=0"});
    const auto wizard = wizard_of(match->world(), 0);
    run(*match, 40, held({input::Button::stir}));
    EXPECT_EQ(match->world().get<Focus>(wizard).points, 100);
    run(*match, 1000, held({input::Button::stir, input::Button::fire}));
    EXPECT_NEAR(match->world().get<Focus>(wizard).points, 97, 1e-9);
    match->world_to_change().get<Focus>(wizard).points = 0.05;
    run(*match, 800, held({input::Button::stir, input::Button::fire}));
    EXPECT_EQ(count_of(*match, EventKind::blunt), 1U);
    EXPECT_GE(match->world().get<Focus>(wizard).points, 0);
    EXPECT_EQ(match->world().get<Chisel>(wizard).cutting, 0U);
    const auto before = match->state_hash();
    std::vector<float> voxels(densities(*match).begin(), densities(*match).end());
    run(*match, 200, held({input::Button::stir, input::Button::fire}));
    EXPECT_TRUE(std::ranges::equal(voxels, densities(*match))) << "a blunt tool cuts nothing";
    EXPECT_NE(before, match->state_hash());
    run(*match, 20, held({input::Button::stir}));
    run(*match, 20, held({input::Button::stir, input::Button::fire}));
    EXPECT_EQ(count_of(*match, EventKind::blunt), 2U) << "the next try is told again";
}

TEST(Crystal, KeysOfWandsTakeTools) {
    const auto match = at_the_crystal(false);
    const auto wizard = wizard_of(match->world(), 0);
    run(*match, 40, held({input::Button::stir}));
    const auto belt = match->world().get<WandBelt>(wizard).selected;
    for (std::uint32_t key = 1; key <= 4; ++key) {
        auto frame = held({input::Button::stir});
        frame.devices[0].wand = static_cast<std::uint8_t>(key);
        run(*match, 16, frame);
        run(*match, 16, held({input::Button::stir}));
        EXPECT_EQ(match->world().get<Lens>(wizard).tool, key - 1);
    }
    run(*match, 16, held({input::Button::stir, input::Button::next_wand}));
    EXPECT_EQ(match->world().get<Lens>(wizard).tool, 0U) << "after the last tool comes the first";
    EXPECT_EQ(match->world().get<WandBelt>(wizard).selected, belt) << "the wand stays";
    const auto fired = match->world().get<WandBelt>(wizard).fired;
    run(*match, 300, held({input::Button::stir, input::Button::fire}));
    EXPECT_EQ(match->world().get<WandBelt>(wizard).fired, fired);
}

TEST(Crystal, WorkEndsWithStirWithDeathAndOutOfReach) {
    const auto match = at_the_crystal(false);
    const auto wizard = wizard_of(match->world(), 0);
    const auto works = [&] {
        return match->world().has<Chisel>(wizard) && match->world().has<AtStation>(wizard);
    };
    const auto stir = held({input::Button::stir});
    run(*match, 40, stir);
    EXPECT_TRUE(works());
    EXPECT_FALSE(match->context().output.models.read()[0].primitives.items().empty());
    run(*match, 16);
    EXPECT_FALSE(works());
    EXPECT_TRUE(match->context().output.models.read()[0].primitives.items().empty());
    run(*match, 40, stir);
    EXPECT_TRUE(works());
    match->world_to_change().get<Health>(wizard).points = 0;
    run(*match, 24, stir);
    EXPECT_FALSE(works());
    EXPECT_FALSE(match->world().has<AtStation>(wizard));
}

// ---- turning ----------------------------------------------------------------------------------------------

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

TEST(Crystal, TurningUnderTheHandStaysWithinTheCapsAndCreatesNoEnergy) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto match = at_the_crystal(true, {}, seed);
        double turned = 0, felt = 0, before = crystal_in(*match).yaw;
        for (Tick t = 0; t < 8000; ++t) {
            auto frame = carving(t);
            frame.devices[0].counts[input::hand::strafe] = t % 1400 < 700 ? 127 : -127;
            if (t % 3000 < 1500) frame.devices[0].counts[input::hand::forward] = 127;  // presses all the time
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

// ---- the grain --------------------------------------------------------------------------------------------

/// Middle of the voxel of which `which(voxel)` is true and that has most like it around; crystal's frame.
template <class Which>
vec3 midst_of(const Crystal& crystal, Which which) {
    constexpr int side = crystal_side, around = 2;
    const auto at = [](int i, int j, int k) { return static_cast<std::size_t>(i + side * (j + side * k)); };
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

// ---- the Lens ---------------------------------------------------------------------------------------------

/// Lets the body be the key, so that the next dab finds it carved.
void carve_whole(Simulation& match) {
    std::ranges::copy(match.crystals().list[0].key, densities(match).begin());
    rebuild_crystals(match.context_to_change(), match.crystals_to_change());
}

TEST(Crystal, ACarvedKeyGivesTheLensAndANewRoughBody) {
    const auto match = at_the_crystal(false);
    const auto wizard = wizard_of(match->world(), 0);
    run(*match, 40, held({input::Button::stir}));
    carve_whole(*match);
    const auto seed = crystal_in(*match).seed;
    run(*match, 40, held({input::Button::stir}));
    EXPECT_EQ(match->world().get<Lens>(wizard).held, 0U) << "not by itself";
    run(*match, 24, held({input::Button::stir, input::Button::fire}));
    EXPECT_EQ(match->world().get<Lens>(wizard).held, 1U);
    EXPECT_EQ(count_of(*match, EventKind::lens), 1U);
    const auto& crystal = crystal_in(*match);
    EXPECT_NE(crystal.seed, seed);
    EXPECT_LT(crystal.overlap, 0.65);
    expect_full_count(*match, crystal, *match);
    run(*match, 16);
    match->world_to_change().get<Health>(wizard).points = 0;
    run(*match, 16);
    EXPECT_EQ(match->world().get<Lens>(wizard).held, 0U);
    EXPECT_EQ(count_of(*match, EventKind::lens_lost), 1U);
}

// ---- chips ------------------------------------------------------------------------------------------------

/// A match in which the first wizard is far away from the crystals, so that nobody touches them.
std::unique_ptr<Simulation> nobody_near() {
    auto match = at_the_crystal(false);
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    auto& motion = world.get<Motion>(wizard);
    motion.position = {8, match->data().wizard.height / 2, 16.5};
    match->physics().set_state(wizard.index, motion);
    world.get<Gaze>(wizard) = {pi / 2, 0};  // towards -x, at the crystal's height
    return match;
}

/// Aims the first wizard's eyes at a crystal and shoots with the wand of a slot until it is chipped.
bool shoot_until_chipped(Simulation& match, std::uint32_t slot, Tick limit) {
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, 0);
    for (Tick t = 0; t < limit; ++t) {
        const vec3 eye = eye_of(match.data().wizard, world.get<Motion>(wizard).position);
        const vec3 to = crystal_in(match).middle - eye;
        world.get<Gaze>(wizard) = {det::atan2(-to.x, -to.z),
                                   det::atan2(to.y, std::sqrt(to.x * to.x + to.z * to.z))};
        world.get<WandBelt>(wizard).selected = slot;
        match.tick(t % 1000 < 500 ? held({input::Button::fire}) : input::InputFrame{});
        if (crystal_in(match).chipped != 0) return true;
    }
    return false;
}

TEST(Crystal, ShotsChipIt) {
    for (const auto* wand : {"bolt", "blast"}) {
        const auto match = nobody_near();
        const auto slot = wand_of(match->data(), wand).stats.slot;
        ASSERT_TRUE(shoot_until_chipped(*match, slot, 6000)) << wand;
        const auto event = last_of(*match, EventKind::chipped);
        EXPECT_EQ(event.by, 0U) << wand;
        EXPECT_EQ(event.subject, no_player) << "nobody has carved it";
        EXPECT_GT(event.amount, 1) << wand;
        EXPECT_LT(event.amount, 70) << wand;
        EXPECT_EQ(crystal_in(*match).touched, 1U);
        EXPECT_EQ(crystal_in(*match, 1).touched, 0U);
        expect_full_count(*match, crystal_in(*match), *match);
    }
}

TEST(Crystal, AThrownThingChipsItAndOneThatLiesThereDoesNot) {
    const auto match = nobody_near();
    Thing thing;
    thing.prop = true;
    thing.surface = Surface::crate;
    thing.body.size = vec3(0.2);
    thing.body.mass = 20;
    thing.body.layer = layer::prop;
    thing.position = crystal_in(*match).middle + vec3(0, 0.52, 0);
    spawn_thing(match->world_to_change(), thing);
    run(*match, 500);
    EXPECT_EQ(crystal_in(*match).chipped, 0U) << "a crate set on top";
    thing.position = crystal_in(*match).middle + vec3(3, 0.1, 0);
    const auto thrown = spawn_thing(match->world_to_change(), thing);
    match->world_to_change().get<Prop>(thrown) = {.moved_at = match->match().played, .moved_by = 1};
    auto motion = match->world().get<Motion>(thrown);
    motion.velocity = {-10, 1, 0};
    match->world_to_change().get<Motion>(thrown) = motion;
    match->physics().set_state(thrown.index, motion);
    run(*match, 500);
    EXPECT_NE(crystal_in(*match).chipped, 0U);
    EXPECT_EQ(last_of(*match, EventKind::chipped).by, 1U);
    EXPECT_LE(count_of(*match, EventKind::chipped), 2U) << "one blow is one chip";
}

TEST(Crystal, ALobThatBurstsBesideItChipsItAndOneFarAwayDoesNot) {
    for (const double off : {0.7, 3.0}) {
        const auto match = nobody_near();
        auto& context = match->context_to_change();
        const vec3 place = crystal_in(*match).middle + vec3(off, 0, 0);
        burst(
            context,
            {.place = place, .size = 0.1, .radius = 4, .damage = 1, .player = 1, .how = hit_kind("lob_hit")},
            match->match().played);
        context.world.apply_commands();
        run(*match, 8);
        EXPECT_EQ(crystal_in(*match).chipped != 0, off < 1) << off;
    }
}

// ---- states -----------------------------------------------------------------------------------------------

TEST(Crystal, RestoredWhileTwoCarveItGoesOnToTheSameBits) {
    const auto match = at_the_crystal();
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(carving(t));
    match->save(saved);
    for (Tick t = 0; t < 600; ++t) match->tick(carving(keyframe_interval + t));
    const auto again = at_the_crystal();
    for (Tick t = 0; t < 300; ++t) again->tick(carving(3 * t));  // gives the match another history first
    ASSERT_TRUE(again->restore(saved, keyframe_interval));
    for (Tick t = 0; t < 600; ++t) again->tick(carving(keyframe_interval + t));
    EXPECT_EQ(again->state_hash(), match->state_hash());
    EXPECT_EQ(again->force_hash(), match->force_hash());
    EXPECT_EQ(again->crystals().list[0].overlap.inside, match->crystals().list[0].overlap.inside);
}

TEST(Crystal, RestoredBeforeItWasTouchedItIsUntouched) {
    const auto match = at_the_crystal();
    Bytes saved;
    run(*match, keyframe_interval);
    match->save(saved);
    const auto before = match->state_hash();
    for (Tick t = 0; t < 400; ++t) match->tick(carving(t));
    ASSERT_EQ(match->world().count<CrystalDensity>(), 1U);
    ASSERT_TRUE(match->restore(saved, keyframe_interval));
    EXPECT_EQ(match->world().count<CrystalDensity>(), 0U);
    EXPECT_EQ(match->state_hash(), before);
    for (Tick t = 0; t < 400; ++t) match->tick(carving(t));
    expect_full_count(*match, crystal_in(*match), *match);
}

TEST(Crystal, BricksOfACrystalNeverLookOlder) {
    const auto match = at_the_crystal();
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(carving(t));
    match->save(saved);
    for (Tick t = 0; t < 100; ++t) match->tick(carving(t));
    const auto newest = match->crystals().list[0].bricks.newest;
    ASSERT_TRUE(match->restore(saved, keyframe_interval));
    EXPECT_GT(match->crystals().list[0].bricks.newest, newest);
}

TEST(Crystal, ANewRoundHasOtherUntouchedCrystals) {
    const auto match = at_the_crystal();
    for (Tick t = 0; t < 500; ++t) match->tick(carving(t));
    const auto seed = crystal_in(*match).seed;
    Jobs jobs(0);
    BrewSolver solver{jobs};
    begin_next_round(match->context_to_change(), solver, match->crystals_to_change());
    EXPECT_EQ(match->world().count<CrystalDensity>(), 0U);
    EXPECT_EQ(crystal_in(*match).touched, 0U);
    EXPECT_NE(crystal_in(*match).seed, seed);
    EXPECT_EQ(match->world().get<Lens>(wizard_of(match->world(), 0)).held, 0U);
    bench::place_at_the_crystal(*match);
    for (Tick t = 0; t < 500; ++t) match->tick(carving(t));
    expect_full_count(*match, crystal_in(*match), *match);
}

TEST(Crystal, EditedDataKeepWhatWasCarved) {
    const auto match = at_the_crystal();
    for (Tick t = 0; t < 500; ++t) match->tick(carving(t));
    const auto next = match->continued_with(duel_data({"bolt.shot.damage=1"}));
    EXPECT_TRUE(std::ranges::equal(densities(*next), densities(*match)));
    EXPECT_EQ(crystal_in(*next).overlap, crystal_in(*match).overlap);
    for (Tick t = 500; t < 900; ++t) next->tick(carving(t));
    expect_full_count(*next, crystal_in(*next), *next);
    const auto fewer = match->continued_with(duel_data({"crystal.overlap=0.9"}));
    for (Tick t = 500; t < 900; ++t) fewer->tick(carving(t));
    expect_full_count(*fewer, crystal_in(*fewer), *fewer);
}

// ---- hostile ----------------------------------------------------------------------------------------------

TEST(Crystal, CarvingUnderTheHandStaysWithinTheCapsAndCreatesNoEnergy) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto match = at_the_crystal(true, {}, seed);
        for (Tick t = 0; t < 8000; ++t) {
            match->tick(carving(t));
            for (std::uint32_t player = 0; player < players; ++player) {
                const auto& servo = match->world().get<HandState>(wizard_of(match->world(), player)).servo;
                ASSERT_LE(glm::length(servo.safety.output), force_cap(match->haptic_setup(), player) + 1e-9);
                ASSERT_LE(servo.energy.most_created, 0.02) << "seed " << seed << ", tick " << t;
            }
        }
    }
}

TEST(Crystal, NaNDoesNotGetInAndDoesNotGetOut) {
    const auto match = at_the_crystal(false);
    run(*match, 40, held({input::Button::stir}));
    auto& crystal = crystal_to_change(*match);
    auto& context = match->context_to_change();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto before = match->state_hash();
    for (const auto& tool : match->data().crystal->tools) {
        for (const auto& dab : {field::Dab{.place = {nan, 0, 0}, .seconds = 0.008},
                                field::Dab{.place = {}, .motion = {0, nan, 0}, .seconds = 0.008},
                                field::Dab{.place = {HUGE_VAL, 0, 0}, .seconds = 0.008}})
            EXPECT_EQ(cut_crystal(context, match->crystals_to_change(), crystal, tool, dab).voxels, 0U);
    }
    EXPECT_EQ(match->state_hash(), before);
    for (std::size_t i = 0; i < crystal_voxels; i += 3)
        densities(*match)[i] = std::numeric_limits<float>::quiet_NaN();
    for (Tick t = 0; t < 1500; ++t) {
        match->tick(carving(t));
        const auto& hand_state = match->world().get<HandState>(wizard_of(match->world(), 0));
        ASSERT_TRUE(is_finite(hand_state.servo.safety.output) && is_finite(hand_state.device.position)) << t;
    }
}

// ---- files ------------------------------------------------------------------------------------------------

TEST(CrystalRules, ToolsComeFromTheirFilesInTheOrderOfTheKeys) {
    const auto data = duel_data();
    ASSERT_TRUE(data->crystal);
    std::vector<std::string> names;
    for (const auto& tool : data->crystal->tools) names.push_back(tool.name);
    EXPECT_EQ(names, (std::vector<std::string>{"melt", "construct", "paint", "stamp"}));
    EXPECT_EQ(data->crystal->work_lasts, ticks(30.0));
    DataChoice classic;
    classic.rules = "classic";
    const auto plain = load_match_data(assets(), classic);
    ASSERT_TRUE(plain);
    EXPECT_FALSE(plain->crystal) << "the classic rules have none";
}

TEST(CrystalRules, AWrongFileIsRefusedWithItsLine) {
    namespace fs = std::filesystem;
    auto folder = (fs::temp_directory_path() / "thaum-crystal-XXXXXX").string();
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const auto copy = fs::path(folder) / "assets";
    fs::copy(assets(), copy, fs::copy_options::recursive);
    const auto whole = read_text_file(assets() / "crystal.toml", 1U << 20U).value();
    const auto refused = [&](const std::string& from, const std::string& to) {
        auto words = whole;
        const auto at = words.find(from);
        if (at == std::string::npos) return std::string("no such words");
        std::ofstream(copy / "crystal.toml") << words.replace(at, from.size(), to);
        const auto data = load_match_data(copy, {});
        return data ? std::string("accepted") : data.error().message;
    };
    EXPECT_EQ(refused("voxels in both", "voxels in both"), "accepted");
    EXPECT_EQ(refused("overlap = 0.8 ", "overlap = 1.8 ").find("assets/crystal.toml:8: 'overlap'"), 0U);
    EXPECT_EQ(refused("name = \"paint\"", "name = \"saw\""),
              "assets/crystal.toml:15: tool 'saw': there is no carving/saw.toml");
    EXPECT_EQ(refused("name = \"paint\"", "name = \"melt\""),
              "assets/crystal.toml:15: tool 'melt' is there twice");
    EXPECT_EQ(refused("name = \"paint\"", "name = \"squirt\""),
              "assets/crystal.toml:15: carving/squirt.toml changes the material; crystals of a match have "
              "only one");
    EXPECT_NE(refused("hold_s = 30", "held_s = 30").find("hold_s"), std::string::npos);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace thaum::game::test
