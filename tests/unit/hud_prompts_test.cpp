// Tests of prompts: they name the control for what the player can do, and disappear once the player has done
// it.
#include "game/data/control_names.h"
#include "game/hud/prompts.h"

#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {
namespace {

const ControlNames names{
    .fire = "Left mouse", .stir = "E", .throw_ = "F", .next_wand = "Wheel down", .wands = {"1"}};

std::string said_to(const PlayerPicture& player, const ControlNames& controls = names) {
    const auto prompt = prompt_of(player, controls);
    return prompt ? prompt->words : std::string();
}

TEST(Prompts, NameTheControlOfWhatCanBeDone) {
    PlayerPicture p;
    EXPECT_EQ(said_to(p), "");
    p.wand.target.kind = TargetKind::take;
    EXPECT_EQ(said_to(p), "[Left mouse] Lift");
    p.wand.target.kind = TargetKind::too_heavy;
    EXPECT_EQ(said_to(p), "");
    p.wand.held = vec3(0);
    p.wand.holds_thing = true;
    EXPECT_EQ(said_to(p), "[F] Throw");
    p = {};
    p.wand.target.kind = TargetKind::hook;
    EXPECT_EQ(said_to(p), "[Left mouse] Swing");
    p.stations.at_rim = true;
    EXPECT_EQ(said_to(p), "[E] Stir");
    p.stations.stirs = true;
    EXPECT_EQ(said_to(p), "");
    p.stations.carries = "iron";
    EXPECT_EQ(said_to(p), "[Left mouse] Drop iron");
    p.vitals.dead = true;
    EXPECT_EQ(said_to(p), "");
}

TEST(Prompts, SayHowToPutAwayWhatWouldSpoilTheRecipe) {
    PlayerPicture p;
    p.stations.carries = "iron";
    p.stations.at_rim = true;
    p.stations.recipe.step = RecipeStep::stroke;
    EXPECT_EQ(said_to(p), "[E] Stir");
    p.stations.stirs = true;
    EXPECT_EQ(said_to(p), "[F] Put away iron");
    p.stations.recipe.step = RecipeStep::ingredient;
    p.stations.recipe.next = "salt";
    EXPECT_EQ(said_to(p), "[F] Put away iron");
    for (const auto step : {RecipeStep::none, RecipeStep::choose, RecipeStep::spoilt}) {
        p.stations.recipe.step = step;
        EXPECT_EQ(said_to(p), "[Left mouse] Drop iron");
    }
    p.stations.recipe.step = RecipeStep::ingredient;
    p.stations.recipe.next = "iron";
    EXPECT_EQ(said_to(p), "[Left mouse] Drop iron");
}

TEST(Prompts, AtTheRimSayThatStirMustBeHeldForADrop) {
    PlayerPicture p;
    p.stations.at_rim = true;
    p.stations.carries = "iron";
    for (const auto step : {RecipeStep::none, RecipeStep::choose}) {
        p.stations.recipe.step = step;
        EXPECT_EQ(said_to(p), "Hold [E], then [Left mouse] Drop iron");
    }
    auto toggling = names;
    toggling.stir_toggles = true;
    EXPECT_EQ(said_to(p, toggling), "Press [E], then [Left mouse] Drop iron");
    p.stations.recipe.step = RecipeStep::ingredient;
    p.stations.recipe.next = "salt";
    EXPECT_EQ(said_to(p), "[F] Put away iron");
    p.stations.recipe.next = "iron";
    EXPECT_EQ(said_to(p), "Hold [E], then [Left mouse] Drop iron");
    p.stations.recipe.least = 0.2;
    EXPECT_EQ(said_to(p), "[E] Stir") << "it is too soon for the drop";
    p.stations.recipe.step = RecipeStep::spoilt;
    EXPECT_EQ(said_to(p), "[E] Stir");
}

TEST(Prompts, WordsOfALessonNameThePlayersOwnControls) {
    const auto data = picture_of(*new_match()).shown;
    const auto filled = [&](std::string_view words) { return with_controls(words, names, *data); };
    EXPECT_EQ(filled("Hold {stir}, then {fire}: {throw}."), "Hold [E], then [Left mouse]: [F].");
    EXPECT_EQ(filled("{wand:bolt} takes Bolt"), "[1] takes Bolt");
    EXPECT_EQ(filled("{wand:lob} takes Lob"), "[Wheel down] (next wand) takes Lob")
        << "a wand without a control of its own";
    EXPECT_EQ(with_controls("{wand:lob}", {}, *data), "[not bound]");
    EXPECT_EQ(filled("{jump}"), "[not bound]");
    EXPECT_EQ(filled("{nothing} {"), "{nothing} {");
}

TEST(Prompts, AreNotShownToWhoeverHasNoControl) {
    PlayerPicture p;
    p.stations.at_rim = true;
    EXPECT_EQ(said_to(p, {}), "");
}

TEST(Prompts, FadeAsTheThingIsDoneAndAreGoneAfterTheThirdTime) {
    const Prompt prompt{PromptKind::stir, "[E] Stir"};
    PromptUses uses;
    float before = 2;
    for (std::uint32_t done = 0; done < PromptUses::learnt; ++done) {
        const float current = strength_of(prompt, 1, PromptWish::until_learnt, uses);
        EXPECT_GT(current, 0);
        EXPECT_LT(current, before);
        before = current;
        ++uses.of(1, PromptKind::stir);
    }
    EXPECT_EQ(strength_of(prompt, 1, PromptWish::until_learnt, uses), 0);
    EXPECT_EQ(strength_of(prompt, 0, PromptWish::until_learnt, uses), 1) << "the other player";
    EXPECT_EQ(strength_of(prompt, 1, PromptWish::always, uses), 1);
    EXPECT_EQ(strength_of(prompt, 0, PromptWish::never, uses), 0);
}

TEST(Prompts, AControlThatTogglesIsPressedAndNotHeld) {
    ControlNames controls;
    controls.fire = "RT";
    controls.stir = "LT";
    const Presentation none;
    const auto words = [&] {
        return with_controls("Hold {stir} at the cauldron, and hold {fire} or {stir}.", controls, none);
    };
    EXPECT_EQ(words(), "Hold [LT] at the cauldron, and hold [RT] or [LT].");
    controls.stir_toggles = true;
    EXPECT_EQ(words(), "Press [LT] at the cauldron, and hold [RT] or [LT].");
    controls.fire_toggles = true;
    EXPECT_EQ(words(), "Press [LT] at the cauldron, and press [RT] or [LT].");
}

TEST(Prompts, APressOfStirOneStepTooFarAwaySaysSoForAMoment) {
    Picture before, now;
    PromptUses uses;
    const auto show = [&](Tick tick) {
        now.tick = tick;
        count_uses(before, now, uses);
        before = now;
    };
    now.wizards[1].stations.misses_rim = true;
    show(100);
    now.wizards[1].stations.misses_rim = false;
    show(180);
    EXPECT_EQ(words_of_missed_station(180, 1, uses), "Too far from the cauldron: step to the rim");
    EXPECT_EQ(words_of_missed_station(180, 0, uses), "");
    EXPECT_EQ(words_of_missed_station(2099, 1, uses), "Too far from the cauldron: step to the rim");
    EXPECT_EQ(words_of_missed_station(2100, 1, uses), "");
    EXPECT_EQ(words_of_missed_station(50, 1, uses), "") << "an earlier match, or a place of a replay";
    now.wizards[1].stations.at_rim = true;
    show(300);
    EXPECT_EQ(words_of_missed_station(300, 1, uses), "") << "the player has come to the rim";
}

TEST(Prompts, AWizardThrownFromOrbOrCrystalIsTold) {
    for (const bool orb : {true, false}) {
        Picture before, now;
        before.tick = 100;
        now.tick = 110;
        before.wizards[0].stations.scrying.scries = before.wizards[0].stations.scrying.near = orb;
        before.wizards[0].stations.carving.carves = before.wizards[0].stations.carving.near = !orb;
        PromptUses uses;
        count_uses(before, now, uses);
        const auto words =
            orb ? "Out of reach of the orb: step up to it" : "Out of reach of the crystal: step up to it";
        EXPECT_EQ(words_of_missed_station(110, 0, uses), words);
        now.wizards[0].stations.scrying.near = orb;
        now.wizards[0].stations.carving.near = !orb;
        PromptUses near;
        count_uses(before, now, near);
        EXPECT_EQ(words_of_missed_station(110, 0, near), "") << "the player has let Stir go";
        now.wizards[0] = {};
        now.wizards[0].stations.scrying.misses = orb;
        now.wizards[0].stations.carving.misses = !orb;
        PromptUses far;
        count_uses(now, now, far);
        auto later = now;
        later.tick = 120;
        count_uses(now, later, far);
        EXPECT_EQ(words_of_missed_station(120, 0, far), words) << "Stir out of reach";
    }
}

/// Uses of controls that are counted between two pictures 10 ticks apart. `change` modifies the second
/// picture.
template <class F>
PromptUses uses_of(Picture before, F change) {
    before.tick = 100;
    Picture current = before;
    current.tick = 110;
    change(current.wizards[0]);
    PromptUses uses;
    count_uses(before, current, uses);
    return uses;
}

TEST(Prompts, UsesAreCountedFromWhatThePicturesShow) {
    Picture start;
    EXPECT_EQ(uses_of(start, [](PlayerPicture&) {}), PromptUses{});
    EXPECT_EQ(uses_of(start, [](PlayerPicture& p) { p.stations.stirs = true; }).of(0, PromptKind::stir), 1U);
    EXPECT_EQ(uses_of(start, [](PlayerPicture& p) { p.wand.held = vec3(0); }).of(0, PromptKind::swing), 1U);
    start.wizards[0].stations.stirs = true;
    start.wizards[0].stations.carries = "iron";
    EXPECT_EQ(uses_of(start, [](PlayerPicture& p) { p.stations.carries = {}; }).of(0, PromptKind::drop), 1U);
    const auto away = uses_of(start, [](PlayerPicture& p) {
        p.stations.carries = {};
        p.senses.gift = {.tick = 5, .kind = EventKind::put_away};
    });
    EXPECT_EQ(away.of(0, PromptKind::put_away), 1U);
    EXPECT_EQ(away.of(0, PromptKind::drop), 0U);
    start = {};
    start.wizards[0].wand.held = vec3(0);
    start.wizards[0].wand.holds_thing = true;
    const auto let_go = [](PlayerPicture& p) {
        p.wand.held.reset();
        p.wand.holds_thing = false;
    };
    EXPECT_EQ(uses_of(start, let_go), PromptUses{}) << "a thing that is put down is not thrown";
    const auto thrown = uses_of(start, [&](PlayerPicture& p) {
        let_go(p);
        ++p.wand.fired;
    });
    EXPECT_EQ(thrown.of(0, PromptKind::throw_thing), 1U);
    const auto died = uses_of(start, [](PlayerPicture& p) {
        p.stations.stirs = true;
        ++p.vitals.lives;
    });
    EXPECT_EQ(died, PromptUses{}) << "a new life is no deed";
}

}  // namespace
}  // namespace thaum::game::hud_tests
