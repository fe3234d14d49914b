// game/bots/brewing.h: how a bot brews a potion. It fetches the ingredients one by one, stirs until the
// moment of the next step has come, drops them in, and then draws the gestures with the button Trace held, as
// a person does.
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Chooses a recipe that a bot could now brew from the beginning; no_potion if there is none.
std::uint32_t choose_recipe(const Simulation& match, const Seat& seat, Random& random);

/// Next step of a bot that brews.
enum class BrewTask : std::uint32_t {
    fetch,  ///< walk to the place where the next ingredient lies
    carry,  ///< carry the ingredient to the cauldron's rim, or stir there
    drop,   ///< let the ingredient fall into the brew
    draw,   ///< draw the next gesture
    done    ///< the potion is brewed, or can no longer succeed
};

struct BrewStep {
    BrewTask task{};
    vec3 place{};  ///< place to walk to (m, world)
};
/// Next step of the recipe that the bot brews, which StirPlan::recipe names.
BrewStep next_brew_step(const BotTurn& turn);

/// Duration of the stroke that the plan's recipe wants next (ticks), with the rests of the hand before and
/// after it.
Tick stroke_length(const Simulation& match, const Seat& seat, const StirPlan& plan);
/// Writes the hand's motion of this tick of a stroke that began at plan.drawing_from.
void draw_hand(const Simulation& match, const Seat& seat, const StirPlan& plan, Tick tick,
               input::DeviceSample& sample);

}  // namespace thaum::game::inline bots
