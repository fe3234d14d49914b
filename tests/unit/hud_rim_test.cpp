// Tests of the card (the panel of text) at the cauldron, and of the HUD with as much content as possible: all
// texts are readable, and none overlap.
#include "game/hud/rim_card.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/text.h"
#include "game/components/cauldron.h"
#include "game/components/orb.h"
#include "game/hud/gesture_wall.h"
#include "game/hud/layout.h"
#include "game/hud/recipe_panel.h"
#include "game/stations/cauldron/potions.h"
#include "render/font.h"
#include "unit/hud_busy.h"
#include "unit/hud_rig.h"
#include "unit/hud_words.h"

namespace thaum::game::hud_tests {
namespace {

void put_circle(RecipePicture& recipe) {
    recipe.ghost_points = max_ghost_points;
    for (std::uint32_t i = 0; i < recipe.ghost_points; ++i) {
        const double angle = 2 * pi * i / (max_ghost_points - 1);
        recipe.ghost.at(i) = 0.3 * vec2(std::sin(angle), std::cos(angle));
    }
}

/// A recipe at one of its steps, with the longest possible texts.
RecipePicture recipe_at(RecipeStep step) {
    RecipePicture recipe;
    recipe.step = step;
    recipe.potion = "ironhide";
    recipe.newest = "ember";
    recipe.next = step == RecipeStep::ingredient ? "resin" : "";
    recipe.reached = 0.575;
    recipe.least = 0.6;
    recipe.most = 0.95;
    recipe.gesture = "circle";
    recipe.sense = CircleSense::counterclockwise;
    recipe.times = 3;
    recipe.done = 1;
    recipe.begun = true;
    recipe.min_force = 0.3;
    recipe.max_force = 1;
    if (step == RecipeStep::stroke) put_circle(recipe);
    constexpr std::array<std::string_view, 5> names{"azoth", "feather", "haste", "ironhide", "venom"};
    if (step == RecipeStep::choose) {
        for (const auto name : names) {
            recipe.choice_names.at(recipe.choices) = name;
            recipe.choice_ingredients.at(recipe.choices++) = {"ember", "resin",
                                                              name == "azoth" ? "mist" : ""};
        }
    }
    return recipe;
}

/// A player at the cauldron with everything shown at once: a brew that spoils in some seconds, an active
/// potion, the result of a stroke.
Picture busy_at(RecipeStep step) {
    auto picture = picture_of(*new_match());
    picture.cauldron.contents[0] = step == RecipeStep::choose ? "" : "ember";
    picture.cauldron.contents[1] = step == RecipeStep::stroke ? "salt" : "";
    picture.cauldron.spoils_in_s = step == RecipeStep::choose ? 0 : 11.2;
    picture.cauldron.whole_time_s = 20;
    picture.cauldron.fresh = 0.55;
    for (auto& p : picture.wizards) {
        p.stations.stirs = p.stations.at_rim = true;
        p.stations.recipe = recipe_at(step);
        p.vitals.giver_names[0] = "haste";
        p.vitals.giver_left_s[0] = 12.4;
        p.vitals.givers = 1;
        auto& reading = p.casting.reading;
        reading = {.age_s = 0.5, .gesture = 0, .nearest = 0, .probability = 0.97, .force = 0.6, .turns = 1};
        p.senses.heard_lines = static_cast<std::uint32_t>(p.senses.heard.size());
        p.senses.heard.fill(
            {.words = "stirring", .from = HeardFrom::ahead, .important = true, .verb = "pushes"});
    }
    picture.cauldron.owner = 0;
    picture.feed_lines = static_cast<std::uint32_t>(picture.feed.size());
    for (auto& line : picture.feed) line.event = {.kind = EventKind::work_half, .subject = 0, .by = 0};
    return picture;
}

constexpr std::array steps{RecipeStep::choose, RecipeStep::ingredient, RecipeStep::stroke,
                           RecipeStep::spoilt};

TEST(RimCard, EveryLineThatAPlayerNeedsIsReadableInEveryView) {
    const std::array<std::pair<RecipeStep, std::vector<std::string_view>>, 4> needed{
        {{RecipeStep::choose, {"Azoth: ember", "Venom: ember", "20 s", "hurts", "Haste 13 s"}},
         {RecipeStep::ingredient, {"Ironhide: ", "resin", "mixed 57 %", "12 s", "Haste 13 s"}},
         {RecipeStep::stroke,
          {"Ironhide: ", "circle", "Right mouse", "mixed 57 %", "12 s", "gently", "Haste 13 s"}},
         {RecipeStep::spoilt, {"Nothing comes", "12 s", "Haste 13 s"}}}};
    for (const auto& [step, words] : needed) {
        const auto& parts = words;  // a copy, because clang cannot capture a structured binding in a lambda
        const auto picture = busy_at(step);
        each_view([&](const HudSettings& settings, const std::string& name) {
            const auto overlay = overlay_of(picture, settings);
            const std::size_t views = settings.watch == Watch::both ? 2 : 1;
            for (const auto part : parts) {
                const auto found = find_words(overlay, part);
                EXPECT_GE(found.number, 2 * views) << name << ": " << part << " (each with its shadow)";
                EXPECT_GE(found.least, readable) << name << ": " << part;
            }
        });
    }
}

TEST(RimCard, ASpoiltRecipeKeepsTheMeasureOfItsBrew) {
    auto picture = busy_at(RecipeStep::stroke);
    picture.cauldron.mixed = 0.69;
    picture.cauldron.well_mixed = 0.92;
    auto& recipe = picture.wizards[0].stations.recipe;
    recipe.reached = 0.9;
    const auto before = rim_card_of(picture, {}, 0);
    EXPECT_NEAR(before.gauge.mixed, 0.9, 1e-6);
    recipe.step = RecipeStep::spoilt;  // the step that shows "Too late"
    const auto after = rim_card_of(picture, {}, 0);
    EXPECT_EQ(after.gauge.mixed, before.gauge.mixed) << "the brew has not come apart";
    EXPECT_FALSE(after.gauge.window);
    EXPECT_EQ(after.gauge.goal, 0) << "the mark of another measure";
    EXPECT_NE(after.brew.find("mixed 90 %"), std::string::npos) << after.brew;
    EXPECT_EQ(after.brew.find("heals"), std::string::npos) << "it has healed already";
    picture.cauldron.boon_open = true;
    EXPECT_NE(rim_card_of(picture, {}, 0).brew.find("even 69 % (heals you from 92 %)"), std::string::npos);
    EXPECT_EQ(rim_card_of(picture, {}, 1).brew.find("heals"), std::string::npos) << "for the owner";
}

TEST(RimCard, SaysWhichControlsDropAnIngredient) {
    PlayerPicture p;
    p.stations.recipe = recipe_at(RecipeStep::ingredient);
    p.stations.recipe.reached = 0.7;
    p.stations.recipe.choices = 0;
    p.stations.carries = p.stations.recipe.next;
    const ControlNames controls{.fire = "Left mouse", .stir = "E"};
    EXPECT_EQ(words_of_step(p, controls), "Ironhide: hold [E], then drop resin with [Left mouse]");
    p.stations.stirs = true;
    EXPECT_EQ(words_of_step(p, controls), "Ironhide: drop resin now with [Left mouse]");
    EXPECT_EQ(words_of_step(p, {}), "Ironhide: drop resin now with [use wand]");
}

TEST(RimCard, AStrokeInWordsHidesNeitherTheStepNorTheClock) {
    const auto picture = busy_at(RecipeStep::stroke);
    each_view([&](const HudSettings& settings, const std::string& name) {
        const auto overlay = overlay_of(picture, settings);
        for (const std::string_view part : {"Circle 97 %", "12 s", "Ironhide"})
            EXPECT_GE(find_words(overlay, part).least, readable) << name << ": " << part;
        for (const std::string_view part : {"Circle 97 %", "12 s", "Ironhide"})
            EXPECT_GE(find_words(overlay, part).number, 2U) << name << ": " << part;
    });
}

TEST(RimCard, NoTwoTextsOverlapAtTheBusiestMoment) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    for (const auto step : steps) {
        for (const bool draws : {false, true}) {
            auto picture = busy_at(step);
            for (auto& p : picture.wizards) {
                p.casting.stroke.drawing = draws;
                p.casting.stroke.on_brew = true;
                p.senses.force.source = "recoil";
                p.senses.force.cap = 1;
                p.senses.force.current = vec3(0.5);
            }
            each_view([&](const HudSettings& settings, const std::string& name) {
                for (const render::Size window : {render::Size{1280, 720}, {1920, 1080}, {800, 600}}) {
                    const auto words = words_of(overlay_of(picture, settings, window), *font);
                    EXPECT_GT(words.size(), 8U);
                    expect_apart(words, text(name, ", ", window.width, ", step ", static_cast<int>(step)));
                }
            });
        }
    }
}

TEST(RimCard, NamesEveryRecipeThatCanGoOn) {
    auto picture = busy_at(RecipeStep::ingredient);
    for (auto& p : picture.wizards) {
        p.stations.recipe.potion = "azoth";
        p.stations.recipe.next = "salt";
        p.stations.recipe.choices = 1;
        p.stations.recipe.choice_names[0] = "venom";
        p.stations.recipe.choice_ingredients[0] = {"ember"};
        p.stations.stirs = false;
    }
    EXPECT_EQ(words_of_step(picture.wizards[0], {}), "Azoth: fetch salt next   or Venom: ember");
}

/// The practice range with the gesture wall on and as many other texts as possible.
Picture at_wall() {
    auto picture = busy_at(RecipeStep::spoilt);
    picture.practice.on = true;
    picture.practice.score = "Bolt 12 of 14";
    picture.practice.below = "dummy: still";
    auto& wall = picture.practice.wall;
    wall.on = true;
    auto gestures = std::make_shared<std::vector<WallGesture>>();
    for (const auto& [name, spell] :
         {std::pair{"Circle", "Shield"}, {"S", "Fog"}, {"Star", "Recall"}, {"V", "Push"}}) {
        auto& one =
            gestures->emplace_back(WallGesture{.name = name, .spell = spell, .ghost = {}, .own = true});
        for (int i = 0; i < 20; ++i)
            one.ghost.push_back({0.01 * i, 0.03 * vec3(std::sin(0.3 * i), std::cos(0.3 * i), 0), 0.5});
    }
    wall.gestures = gestures;
    wall.scores = {97, -1, 42, -1};
    wall.chosen = 0;
    wall.lines = {"Shield, 97 % sure, gentle (0.6 N)", "end where you began",
                  "the upper left is the farthest off"};
    for (int i = 0; i < 40; ++i)
        wall.stroke.push_back({0.02 * i, 0.04 * vec3(std::sin(0.15 * i), std::cos(0.15 * i), 0), 0.5});
    auto& p = picture.wizards[0];
    p.stations.stirs = p.stations.at_rim = false;
    p.stations.carries = "iron";
    p.senses.force.source = "recoil";
    p.senses.force.cap = 1;
    p.senses.force.current = vec3(0.5);
    return picture;
}

TEST(GestureWall, CoversNoWordsAndNamesTheSpells) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    const auto picture = at_wall();
    for (const render::Size window : {render::Size{1280, 720}, {1920, 1080}, {800, 600}}) {
        for (double scale = 1; scale <= 2; scale += 0.5) {
            auto settings = busy_settings(render::Split::top_bottom, Watch::first, scale);
            const auto words = words_of(overlay_of(picture, settings, window), *font);
            const auto where = text(window.width, " at ", scale);
            expect_apart(words, where);
            // All texts of the gesture wall are in its box, below its first title; no other text is there.
            const auto said = [&](std::string_view part) {
                return std::find_if(words.begin(), words.end(),
                                    [&](const auto& w) { return w.words.find(part) != std::string::npos; });
            };
            for (const std::string_view part : {"Circle", "Shield, yours", "97 %", "42 %", "Push, yours",
                                                "Your stroke", "recoil", "Carrying the iron", "stirring"})
                EXPECT_TRUE(scale > 1 || said(part) != words.end()) << where << ": " << part;
            if (said("Shield, yours") == words.end() || said("Your stroke") == words.end()) continue;
            const Panel cells{said("Shield, yours")->box.low,
                              {said("Your stroke")->box.high.x, said("the upper left")->box.low.y}};
            for (const std::string_view part : {"recoil", "Carrying", "stirring", "Circle 97 %"}) {
                if (said(part) == words.end()) continue;
                EXPECT_FALSE(overlap(said(part)->box, cells)) << where << ": " << part;
            }
        }
    }
}

TEST(GestureWall, WordsAreReadableAndScoresStandOnOneLine) {
    const auto picture = at_wall();
    const auto settings = busy_settings(render::Split::top_bottom, Watch::first, 1);
    for (const render::Size window : {render::Size{1280, 720}, {1920, 1080}}) {
        const auto overlay = overlay_of(picture, settings, window);
        const float least = readable * static_cast<float>(window.height) / 720;
        for (const std::string_view part : {"Shield, yours", "Recall, yours", "97 %", "42 %", "Your stroke",
                                            "Shield, 97 % sure, gentle (0.6 N)", "the upper left is"}) {
            const auto found = find_words(overlay, part);
            EXPECT_GE(found.number, 2U) << part << " (each with its shadow)";
            EXPECT_GE(found.least, least) << part << " at " << window.width;
        }
    }
}

/// Box around the lines of a stroke in an overlay, which are found by their line width (px).
Panel box_of_lines(const render::Overlay& overlay, float width) {
    Panel box{fvec2(1e6F), fvec2(-1e6F)};
    for (const auto* line : items_of<render::LineItem>(overlay)) {
        if (std::abs(line->width - width) > 0.01F) continue;
        box.low = glm::min(box.low, glm::min(line->from, line->to));
        box.high = glm::max(box.high, glm::max(line->from, line->to));
    }
    return box;
}

TEST(GestureWall, AStrokeThatIsDrawnStaysInItsOwnPanel) {
    auto wall = at_wall().practice.wall;
    wall.drawing = true;
    wall.chosen = -1;
    render::Overlay overlay;
    add_gesture_wall(overlay, wall, wall.lines, {{0, 0}, {390, 340}}, 1);
    const auto stroke = box_of_lines(overlay, 4), ghosts = box_of_lines(overlay, 3);
    EXPECT_GT(stroke.high.x, stroke.low.x) << "it is drawn";
    EXPECT_GT(stroke.low.x, ghosts.high.x) << "right of all ghosts";
    EXPECT_LT(stroke.high.x, 390);
    EXPECT_GT(box_of_lines(overlay, 3.5F).low.x, box_of_lines(overlay, 3.5F).high.x) << "over no ghost yet";
    wall.drawing = false;
    wall.chosen = 2;
    overlay.items.clear();
    add_gesture_wall(overlay, wall, wall.lines, {{0, 0}, {390, 340}}, 1);
    const auto over = box_of_lines(overlay, 3.5F);
    EXPECT_LT(over.high.x, 130);
    EXPECT_GT(over.low.y, 100) << "over the ghost of the third gesture";
}

TEST(GestureWall, ScoresOfOlderStrokesArePale) {
    const auto wall = at_wall().practice.wall;
    render::Overlay overlay;
    add_gesture_wall(overlay, wall, wall.lines, {{0, 0}, {390, 340}}, 1);
    const auto paint_of = [&](std::string_view words) { return text_item(overlay, words)->colour; };
    EXPECT_GT(paint_of("97 %").a, 0.9F);
    EXPECT_GT(paint_of("42 %").a, 0.1F);
    EXPECT_LT(paint_of("42 %").a, 0.5F);
}

TEST(RimCard, TellsTheOrderOfAzothOnlyToWhomTheOrbHasToldIt) {
    auto match = new_match();
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    world.get<Motion>(wizard).position = world.single<Cauldron>().middle + vec3(1.2, 0, 0);
    const auto words = [&] { return words_of_step(picture_of(*match).wizards[0], {}); };
    EXPECT_NE(words().find("Azoth: ask the orb"), std::string::npos) << words();
    EXPECT_NE(words().find("Haste: ember, salt"), std::string::npos) << words();

    const auto& recipes = match->data().recipes;
    const auto azoth = std::ranges::find_if(recipes, &Recipe::drawn);
    ASSERT_NE(azoth, recipes.end());
    const auto order = order_of(*azoth, std::as_const(world), 0);
    const auto name = [&](std::size_t i) {
        return std::string(match->data().cauldron->ingredients[order.steps[i].ingredient].name);
    };
    world.get<WornModes>(wizard).order_told = 1;
    EXPECT_NE(words().find(text("Azoth: ", name(0), ", ", name(1), ", ", name(2))), std::string::npos)
        << words();
}

}  // namespace
}  // namespace thaum::game::hud_tests
