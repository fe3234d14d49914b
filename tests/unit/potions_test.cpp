// Tests of potions: recipes step by step, the effects of right and wrong steps, and what a potion does to its
// wizard.
#include "game/stations/cauldron/potions.h"

#include <fstream>
#include <set>

#include "game/match/kind_tables.h"
#include "game/stations/cauldron/brewing.h"
#include "unit/copied_assets.h"
#include "unit/kitchen_rig.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

constexpr std::uint32_t circle = 0, s = 1, star = 2, v = 3;

void brew_haste(Kitchen& kitchen) {
    kitchen.drop("ember");
    kitchen.drop("salt");
    for (int i = 0; i < 3; ++i) kitchen.draw(drawn(circle, 0.6, 1));
}

TEST(Potions, EachRecipeGivesItsPotion) {
    struct Brewing {
        const char* name;
        std::vector<const char*> ingredients;
        std::vector<StrokeReading> strokes;
    };
    const Brewing all[] = {
        {"haste", {"ember", "salt"}, {drawn(circle, 0.5, 1), drawn(circle, 0.5, 2)}},
        {"ironhide", {"iron", "resin"}, {drawn(v, 1.6), drawn(v, 4)}},
        {"feather", {"down", "mist"}, {drawn(s, 0.4)}},
        {"venom", {"moss", "ember"}, {drawn(star, 1.2)}},
    };
    for (const auto& brewing : all) {
        Kitchen kitchen;
        for (const auto* one : brewing.ingredients) kitchen.drop(one);
        for (const auto& stroke : brewing.strokes) {
            EXPECT_EQ(kitchen.brewed(), "") << brewing.name;
            kitchen.draw(stroke);
        }
        EXPECT_EQ(kitchen.brewed(), brewing.name);
        EXPECT_EQ(kitchen.fault(), BrewFault::none) << brewing.name;
        const auto& recipe = kitchen.match().data().recipes[kitchen.number_of(brewing.name)];
        EXPECT_GT(end_of(recipe.effects, kitchen.effects(0)), kitchen.now()) << brewing.name;
        EXPECT_EQ(kitchen.effects(1), Effects{}) << "the other wizard has drunk nothing";
    }
}

TEST(Potions, AzothNeedsItsOwnOrderOfEachPlayer) {
    Kitchen kitchen;
    const auto& recipe = kitchen.match().data().recipes[kitchen.number_of("azoth")];
    const auto mine = order_of(recipe, kitchen.world(), 0), foes = order_of(recipe, kitchen.world(), 1);
    ASSERT_EQ(mine.count, 3U);
    const auto name = [&](const RecipeOrder& order, std::size_t i) {
        return kitchen.match().data().cauldron->ingredients[order.steps[i].ingredient].name;
    };
    EXPECT_FALSE(name(mine, 0) == name(foes, 0) && name(mine, 1) == name(foes, 1)) << "both have one order";
    for (std::size_t i = 0; i < 3; ++i) kitchen.drop(name(mine, i));
    EXPECT_EQ(kitchen.fault(), BrewFault::none);
    for (const auto& stroke : {drawn(circle, 0.5, -3), drawn(v, 2), drawn(star, 1)}) kitchen.draw(stroke);
    EXPECT_EQ(kitchen.brewed(), "azoth");
    EXPECT_TRUE(kitchen.holds_half(0));
    EXPECT_EQ(kitchen.count(EventKind::work_half), 1U);

    Kitchen other;
    for (std::size_t i = 0; i < 3; ++i) other.drop(name(foes, i));
    EXPECT_EQ(other.fault(), BrewFault::order) << "the foe's order is not mine";
}

TEST(Potions, OrdersFollowFromTheSeedAndDiffer) {
    std::set<std::uint32_t> first;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Kitchen kitchen({}, seed), again({}, seed);
        const auto& order = kitchen.world().single<DrawnOrders>().order;
        EXPECT_EQ(order, again.world().single<DrawnOrders>().order);
        EXPECT_NE(order[0], order[1]);
        first.insert(order[0][0] * 9 + order[0][1] * 3 + order[0][2]);
    }
    EXPECT_GE(first.size(), 3U) << "of six possible orders";
}

TEST(Potions, WithoutAnOrbBothPlayersAreToldTheirOrder) {
    auto data = load_match_data(assets(), {.arena = "the_well"}).value();
    Simulation match(std::make_shared<const MatchData>(std::move(data)), two_hands());
    for (Tick t = 0; t < ticks(1.2); ++t) match.tick({});
    std::vector<std::uint32_t> told;
    const auto& events = match.events();
    for (auto i = events.first(); i < events.count(); ++i)
        if (events[i].kind == EventKind::recipe_told) told.push_back(events[i].detail);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_NE(told[0], told[1]);
    const auto& recipes = match.data().recipes;
    const auto recipe = std::find_if(recipes.begin(), recipes.end(), [](const Recipe& r) { return r.drawn; });
    ASSERT_NE(recipe, recipes.end());
    const auto order = order_of(*recipe, match.world(), 0);
    EXPECT_EQ((told[0] >> 8U) & 0xFFU, order.steps[0].ingredient);
    EXPECT_EQ((told[0] >> 24U) & 0xFFU, order.steps[2].ingredient);
}

TEST(Potions, AWrongOrderSpoilsTheRecipe) {
    Kitchen kitchen;
    kitchen.drop("salt");
    kitchen.drop("ember");
    EXPECT_EQ(kitchen.fault(), BrewFault::order);
    const auto health = kitchen.world().get<Health>(kitchen.wizard(0)).points;
    for (int i = 0; i < 3; ++i) kitchen.draw(drawn(circle, 0.5, 1));
    EXPECT_EQ(kitchen.fault(), BrewFault::off);
    EXPECT_EQ(kitchen.brewed(), "");
    EXPECT_EQ(kitchen.world().get<Health>(kitchen.wizard(0)).points, health) << "it costs nothing but time";
}

TEST(Potions, TheMomentOfTheNextIngredientCounts) {
    for (const auto& [reached, fault] : {std::pair(0.1, BrewFault::early), std::pair(0.97, BrewFault::late),
                                         std::pair(0.6, BrewFault::none)}) {
        Kitchen kitchen;
        kitchen.drop("ember");
        kitchen.drop("salt", reached);
        EXPECT_EQ(kitchen.fault(), fault) << reached;
        EXPECT_EQ(kitchen.cauldron().fault, fault) << reached;
    }
}

TEST(Potions, AStrokeThatBeginsInTimeMayStirTheBrewBeyondItsWindow) {
    Kitchen kitchen;
    kitchen.drop("ember");
    kitchen.drop("salt");
    kitchen.draw_from(drawn(circle, 0.5, 1), 0.2, 0.4);
    EXPECT_EQ(kitchen.fault(), BrewFault::soon);
    kitchen.draw_from(drawn(circle, 0.5, 1), 0.85, 0.97);
    EXPECT_EQ(kitchen.cauldron().strokes_done, 1U);
    EXPECT_EQ(kitchen.cauldron().fault, BrewFault::none);
}

TEST(Potions, TheMomentOfTheFirstStrokeCounts) {
    Kitchen kitchen;
    kitchen.drop("ember");
    kitchen.drop("salt");
    kitchen.draw(drawn(circle, 0.5, 1), 0.1);
    EXPECT_EQ(kitchen.fault(), BrewFault::soon);
    EXPECT_EQ(kitchen.cauldron().fault, BrewFault::none) << "an early stroke may be drawn again";
    kitchen.draw(drawn(circle, 0.5, 1), 0.6);
    EXPECT_EQ(kitchen.cauldron().strokes_done, 1U);
    kitchen.draw(drawn(circle, 0.5, 2), 0.95);
    EXPECT_EQ(kitchen.brewed(), "haste") << "later strokes may come whenever the wizard likes";

    Kitchen late;
    late.drop("ember");
    late.drop("salt");
    late.draw(drawn(circle, 0.5, 1), 0.95);
    EXPECT_EQ(late.fault(), BrewFault::late);
    late.draw(drawn(circle, 0.5, 3), 0.6);
    EXPECT_EQ(late.fault(), BrewFault::off);
}

TEST(Potions, AStrokeThatDoesNotFitCostsOnlyItself) {
    Kitchen kitchen;
    kitchen.draw(drawn(circle, 0.5, 1));
    EXPECT_EQ(kitchen.fault(), BrewFault::unfinished) << "a pure brew";
    kitchen.drop("ember");
    kitchen.draw(drawn(circle, 0.5, 1));
    EXPECT_EQ(kitchen.fault(), BrewFault::unfinished) << "ember alone";
    kitchen.drop("salt");
    kitchen.draw({});
    kitchen.draw(drawn(v, 0.5));
    EXPECT_EQ(kitchen.fault(), BrewFault::gesture);
    kitchen.draw(drawn(circle, 0.5, -1));
    EXPECT_EQ(kitchen.fault(), BrewFault::sense);
    kitchen.draw(drawn(circle, 0.2, 1));
    EXPECT_EQ(kitchen.fault(), BrewFault::gentle);
    kitchen.draw(drawn(circle, 1.2, 1));
    EXPECT_EQ(kitchen.fault(), BrewFault::hard);
    EXPECT_EQ(kitchen.cauldron().strokes_done, 0U);
    EXPECT_EQ(kitchen.count(EventKind::brew_fault), 6U) << "a stroke without a gesture is nothing";
    kitchen.draw(drawn(circle, 0.5, 3));
    EXPECT_EQ(kitchen.brewed(), "haste");
}

TEST(Potions, TheFoesBrewTakesNoStrokes) {
    Kitchen kitchen;
    kitchen.drop("ember");
    kitchen.drop("salt");
    kitchen.draw(drawn(circle, 0.5, 3), 0.7, 1);
    EXPECT_EQ(kitchen.fault(), BrewFault::foreign);
    EXPECT_EQ(kitchen.brewed(), "");
}

TEST(Potions, AFourthIngredientIsKeptInTheHand) {
    Kitchen kitchen;
    for (const auto* one : {"ember", "salt", "iron"}) kitchen.drop(one);
    kitchen.drop("moss");
    EXPECT_EQ(kitchen.fault(), BrewFault::full);
    EXPECT_TRUE(kitchen.world().has<Pouch>(kitchen.wizard(0)));
    EXPECT_EQ(ingredients_in(kitchen.cauldron()), 3U);
}

TEST(Potions, ThePotionEmptiesTheBrewAndChangesItForAWhile) {
    Kitchen kitchen;
    kitchen.drop("down");
    kitchen.drop("mist");
    kitchen.draw(drawn(s, 0.5));
    EXPECT_EQ(kitchen.cauldron().begun, 0U);
    kitchen.run(4 * fluid_period);
    EXPECT_EQ(ingredients_in(kitchen.cauldron()), 0U);
    EXPECT_NEAR(kitchen.cauldron().density, 0.6, 1e-9);
    EXPECT_TRUE(is_light(kitchen.match().data().cauldron->aura, kitchen.cauldron()));
    EXPECT_GT(kitchen.cauldron().speed, 0.01) << "the light brew rises";
    kitchen.stop_stirring();
    kitchen.run(ticks(21));
    EXPECT_NEAR(kitchen.cauldron().density, 1, 1e-9) << "pure again";
    EXPECT_EQ(kitchen.count(EventKind::boiled_over), 0U) << "there is nothing left that could spoil";
    EXPECT_EQ(kitchen.count(EventKind::potion_over), 1U);
    EXPECT_EQ(kitchen.effects(0), Effects{});
}

TEST(Potions, ThicknessTensionAndSwirlFollow) {
    Kitchen kitchen;
    kitchen.drop("iron");
    kitchen.drop("resin");
    for (int i = 0; i < 2; ++i) kitchen.draw(drawn(v, 2));
    kitchen.run(4 * fluid_period);
    const auto& rules = *kitchen.match().data().cauldron;
    EXPECT_NEAR(kitchen.cauldron().viscosity, 4, 1e-9);
    EXPECT_NEAR(kitchen.match().brew()->brew.surface.settings.tension, 4 * rules.surface.tension, 1e-9);
    EXPECT_TRUE(is_thick(rules.aura, kitchen.cauldron()));
    EXPECT_LT(pace_at(kitchen.match().data(), kitchen.world(), {-2.2, 1, 0}), 1);

    Kitchen haste;
    brew_haste(haste);
    haste.run(ticks(2));
    const auto* work = haste.match().brew();
    const auto& middle = haste.cauldron().middle;
    // The flow is clockwise seen from above, so north of the middle it goes east.
    EXPECT_GT(current_at(haste.world(), work, middle + vec3(0, -0.3, -0.7), haste.now()).x, 0.1);
    EXPECT_GT(haste.cauldron().speed, 0.2);
}

TEST(Potions, HasteAndIronhideChangeTheWalk) {
    const auto walked = [](auto brew) {
        Kitchen kitchen;
        brew(kitchen);
        kitchen.stop_stirring();
        kitchen.place(0, {-5, 0, -5});
        const auto from = kitchen.world().get<Motion>(kitchen.wizard(0)).position;
        for (Tick t = 0; t < 1000; ++t) {
            input::InputFrame frame;
            frame.devices[0].counts[input::hand::forward] = 127;
            kitchen.match().tick(frame);
        }
        return glm::distance(from, kitchen.world().get<Motion>(kitchen.wizard(0)).position);
    };
    const double usual = walked([](Kitchen& kitchen) { kitchen.run(100); });
    EXPECT_NEAR(usual, 4.5, 0.3);
    EXPECT_NEAR(walked(brew_haste) / usual, 1.3, 0.03);
    EXPECT_NEAR(walked([](Kitchen& kitchen) {
                    kitchen.drop("iron");
                    kitchen.drop("resin");
                    for (int i = 0; i < 2; ++i) kitchen.draw(drawn(v, 2));
                }) / usual,
                0.9, 0.03);
}

TEST(Potions, IronhideTakesFourTenthsOfAHarm) {
    Kitchen kitchen;
    kitchen.drop("iron");
    kitchen.drop("resin");
    for (int i = 0; i < 2; ++i) kitchen.draw(drawn(v, 2));
    const auto& health = kitchen.world().get<Health>(kitchen.wizard(0));
    const double before = health.points;
    const auto hit = [&] {
        hurt(kitchen.match().context_to_change(), kitchen.wizard(0), kitchen.now(),
             {.points = 10, .by = 1, .how = hit_kind("bolt_hit")});
    };
    hit();
    EXPECT_NEAR(before - health.points, 6, 1e-9);
    kitchen.run(ticks(12.1));
    const double later = health.points;
    hit();
    EXPECT_NEAR(later - health.points, 10, 1e-9) << "the potion has worn off";
}

TEST(Potions, PoisonHurtsOnceASecond) {
    Kitchen kitchen;
    auto& health = kitchen.world().get<Health>(kitchen.wizard(1));
    health.poison = 4;
    health.poisoned_until = kitchen.now() + ticks(8);
    health.poisoned_by = 0;
    health.shielded_until = 0;
    kitchen.run(ticks(9));
    EXPECT_EQ(kitchen.count(EventKind::poison), 8U);
    EXPECT_NEAR(kitchen.world().get<Health>(kitchen.wizard(1)).points, 100 - 32, 1e-9);
}

TEST(Potions, DeathTakesAllPotions) {
    Kitchen kitchen;
    brew_haste(kitchen);
    kitchen.world().get<WorkHalf>(kitchen.wizard(0)).held = 1;
    kitchen.world().get<Health>(kitchen.wizard(0)).points = 0;
    kitchen.run(3 * gameplay_period);
    EXPECT_EQ(kitchen.effects(0), Effects{});
    EXPECT_FALSE(kitchen.holds_half(0));
    EXPECT_EQ(kitchen.count(EventKind::work_lost), 1U);
    EXPECT_EQ(kitchen.count(EventKind::potion_over), 0U);
}

TEST(Potions, DeathTakesAllPotionsAlsoFromAWizardWhoReturnsAtOnce) {
    Kitchen kitchen({"quick.respawn_s=0"});
    brew_haste(kitchen);
    kitchen.world().get<WorkHalf>(kitchen.wizard(0)).held = 1;
    kitchen.world().get<WandBelt>(kitchen.wizard(0)).venom = 4;
    kitchen.world().get<Health>(kitchen.wizard(0)).points = 0;
    kitchen.run(3 * gameplay_period);
    EXPECT_FALSE(kitchen.world().has<Dead>(kitchen.wizard(0)));
    EXPECT_EQ(kitchen.count(EventKind::death), 1U);
    EXPECT_EQ(kitchen.effects(0), Effects{});
    EXPECT_FALSE(kitchen.holds_half(0));
    EXPECT_EQ(kitchen.world().get<WandBelt>(kitchen.wizard(0)).venom, 0);
    EXPECT_EQ(kitchen.count(EventKind::work_lost), 1U);
}

TEST(Potions, ARestoredBrewGoesOnToTheSameBits) {
    Kitchen kitchen;
    brew_haste(kitchen);
    while (kitchen.match().now() % keyframe_interval != 0) kitchen.run(1);
    Bytes saved;
    kitchen.match().save(saved);
    const auto at = kitchen.match().now();
    kitchen.run(400);
    const auto expected = kitchen.match().state_hash();
    Kitchen again;
    ASSERT_TRUE(again.match().restore(saved, at));
    again.run(400);
    EXPECT_EQ(again.match().state_hash(), expected);
}

TEST(Potions, SpoilingForgetsHowLongTheBrewWasMixed) {
    Kitchen kitchen({"cauldron.brewing.spoils_after_s=1", "cauldron.boon.mixed=0"});
    kitchen.drop("ember");
    kitchen.run(ticks(0.5));
    EXPECT_NE(kitchen.cauldron().mixed_since, 0U);
    kitchen.stop_stirring();
    while (kitchen.count(EventKind::boiled_over) == 0) kitchen.run(1);
    EXPECT_EQ(kitchen.cauldron().mixed_since, 0U);
}

TEST(Potions, AWrongRecipeFileIsRefusedWithItsLine) {
    namespace fs = std::filesystem;
    const CopiedAssets copied;
    const auto& copy = copied.path;
    const auto refused = [&](const std::string& more, const std::string& effect = "x") {
        std::ofstream(copy / "potions" / "brine.toml")
            << "version = 1\n[[ingredient]]\nname = \"salt\"\nleast = 0.1\nmost = 1\n[[stroke]]\ngesture = "
               "\"s\"\n"
               "[fluid]\nlasts_s = 1\n[look]\ncolour = [1, 1, 1]\neffect = \""
            << effect << "\"\n"
            << more;
        return message_of(load_match_data(copy, {}), "accepted");
    };
    EXPECT_EQ(refused(""), "accepted");
    EXPECT_NE(refused("", "").find("effect must say"), std::string::npos)
        << "a potion without words for what it does";
    EXPECT_NE(refused("[[ingredient]]\nname = \"sand\"\nleast = 0\nmost = 1\n").find("no ingredient 'sand'"),
              std::string::npos);
    EXPECT_NE(refused("[[stroke]]\ngesture = \"loop\"\n").find("the name 'loop'"), std::string::npos);
    EXPECT_NE(refused("colour_of_foam = 1\n").find("colour_of_foam"), std::string::npos);
    EXPECT_NE(refused("[[ingredient]]\nname = \"salt\"\nleast = 0\nmost = 1\n").find("may come once"),
              std::string::npos);
    EXPECT_NE(refused("[[stroke]]\ngesture = \"v\"\nleast_n = 2\nmost_n = 1\n").find("less than"),
              std::string::npos);
    fs::copy_file(copy / "potions" / "haste.toml", copy / "potions" / "brine.toml",
                  fs::copy_options::overwrite_existing);
    const auto message = message_of(load_match_data(copy, {}));
    EXPECT_NE(message.find("those of brine"), std::string::npos) << message;
}

TEST(Potions, ALogNamesThem) {
    const auto data = duel_data();
    const auto tables = kind_tables(*data);
    const auto found =
        std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.group == "potion"; });
    ASSERT_NE(found, tables.end());
    EXPECT_EQ(found->kinds.size(), data->recipes.size());
    const auto file = std::find_if(data->files.begin(), data->files.end(),
                                   [](const auto& one) { return one.name == "potions/haste.toml"; });
    EXPECT_NE(file, data->files.end()) << "a changed recipe must be noticed by a replay";
    const auto changed = duel_data({"haste.effect[0].factor=2"});
    EXPECT_EQ(changed->recipes[2].effects[0].rules->factors(1).pace, 2);
}

}  // namespace
}  // namespace thaum::game::test
