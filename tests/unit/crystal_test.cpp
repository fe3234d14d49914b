// Tests of crystals in a match: touching, carving, chips (pieces that shots break off), the Lens (the prize
// for a finished crystal), rounds, restored states, and hostile input.
#include "game/stations/crystal/crystal.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/file.h"
#include "core/text.h"
#include "game/components/casting.h"
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/context/shot.h"
#include "game/match/round.h"
#include "game/match/spawn.h"
#include "game/stations/crystal/crystal_shape.h"
#include "tests/scenes/carving_hands.h"
#include "unit/copied_assets.h"
#include "unit/crystal_rig.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

// ---- touching a crystal -----------------------------------------------------------------------------------

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

// ---- carving a crystal ------------------------------------------------------------------------------------

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

// ---- the Lens (the prize for a finished crystal) ----------------------------------------------------------

/// Makes the crystal's body equal to the shape hidden in it, so that the next use of a tool completes the
/// crystal.
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

// ---- chips that shots break off a crystal -----------------------------------------------------------------

/// A match in which the first wizard is far from the crystals, so that no hand touches them.
std::unique_ptr<Simulation> nobody_near() {
    auto match = at_the_crystal(false);
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    auto& motion = world.get<Motion>(wizard);
    motion.position = {8, match->data().wizard.height / 2, 16.5};
    match->physics().set_state(wizard.index, motion);
    world.get<Gaze>(wizard) = {pi / 2, 0};  // the wizard looks towards -x, at the height of a crystal there
    return match;
}

/// Turns the first wizard's view to a crystal and shoots with the wand in slot `slot` until a piece of the
/// crystal breaks off.
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

// ---- states of crystals that are restored -----------------------------------------------------------------

TEST(Crystal, RestoredWhileTwoCarveItGoesOnToTheSameBits) {
    const auto match = at_the_crystal();
    Bytes saved;
    for (Tick t = 0; t < keyframe_interval; ++t) match->tick(carving(t));
    match->save(saved);
    for (Tick t = 0; t < 600; ++t) match->tick(carving(keyframe_interval + t));
    const auto again = at_the_crystal();
    for (Tick t = 0; t < 300; ++t) again->tick(carving(3 * t));  // so that this match has another history
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

// ---- hostile input at a crystal ---------------------------------------------------------------------------

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

// ---- data files of crystals -------------------------------------------------------------------------------

TEST(CrystalRules, ToolsComeFromTheirFilesInTheOrderOfTheKeys) {
    const auto data = duel_data();
    ASSERT_TRUE(data->crystal);
    std::vector<std::string> names;
    for (const auto& tool : data->crystal->tools) names.push_back(tool.name);
    EXPECT_EQ(names, (std::vector<std::string>{"melt", "construct", "paint", "stamp"}));
    EXPECT_EQ(data->crystal->work_lasts, ticks(30.0));
    EXPECT_FALSE(load_match_data(assets(), {.rules = "classic"})->crystal) << "the classic rules have none";
}

TEST(CrystalRules, AWrongFileIsRefusedWithItsLine) {
    const CopiedAssets copied;
    const auto& copy = copied.path;
    const auto whole = read_text_file(assets() / "crystal.toml", 1U << 20U).value();
    const auto refused = [&](const std::string& from, const std::string& to) {
        auto words = whole;
        const auto at = words.find(from);
        if (at == std::string::npos) return std::string("no such words");
        std::ofstream(copy / "crystal.toml") << words.replace(at, from.size(), to);
        return message_of(load_match_data(copy, {}), "accepted");
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
}

}  // namespace
}  // namespace thaum::game::test
