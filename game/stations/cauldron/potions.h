// game/stations/cauldron/potions.h: potions in the match (MANUAL.md, "The cauldron"): which recipes a brew follows, what comes of the
// strokes drawn in it, and what a potion does to its wizard.
//
//     ingredients in their order, each in the window of the one before   drop_for_recipe()
//     strokes, the first one in the window of the last ingredient        brew_by_stroke()
//     last stroke: the wizard drinks the potion, the brew is changed     Potions, Cauldron::potion
//
// A wrong step costs time only. A stroke that does not fit may be drawn again. A wrong ingredient, or a step that comes
// too late, spoils the recipe: nothing comes of the brew until it has boiled over.
#pragma once
#include "game/components/stroke_reading.h"
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game {

/// A recipe's ingredients in the order that holds for one player.
struct RecipeOrder {
    std::array<RecipeIngredient, most_recipe_ingredients> steps{};
    std::size_t count{};
};
/// Reads DrawnOrders.
RecipeOrder order_of(const Recipe& recipe, const ecs::World& world, std::uint32_t player);

/// Recipes, by their numbers.
struct RecipeList {
    std::array<std::uint32_t, most_potions> numbers{};
    std::size_t count{};
};
/// Recipes that the brew can still become for this player. All recipes for an empty brew; none after a fault.
RecipeList recipes_open_to(const MatchData& data, const ecs::World& world, const Cauldron& cauldron,
                           std::uint32_t player);

/// Number of ingredients in the brew, with those that the next fluid step takes.
std::size_t ingredients_in(const Cauldron& cauldron);
/// Contents after the next fluid step.
Contents contents_to_come(const Cauldron& cauldron);

/// Tick of play at which the brew boils over; no meaning for a brew without ingredients.
Tick spoils_at(const MatchData& data, const Cauldron& cauldron);

/// Judges an ingredient that is about to be dropped in. Must be called before it is. Records a right or wrong step.
/// Writes Cauldron, EventLog and resource::Journal.
void drop_for_recipe(MatchContext& context, Cauldron& cauldron, std::uint32_t player,
                     std::uint32_t ingredient, Tick tick);
/// Records that a fourth ingredient does not fit into the brew.
void refuse_fourth(MatchContext& context, const Cauldron& cauldron, std::uint32_t player, Tick tick);

/// A stroke on the brew. It stirs the brew as well. So the moment at which it began counts for the end of a window, and
/// the moment at which it is done for its beginning.
struct BrewStroke {
    StrokeReading reading{};
    double begun_at{};  ///< Cauldron::reached when it began
};

/// Judges a stroke that a wizard with a Ladle has drawn, in a gameplay tick. A reading without a gesture is ignored.
/// The calling system must have declared brew_by_stroke_reads() and brew_by_stroke_writes().
void brew_by_stroke(MatchContext& context, ecs::Entity wizard, const BrewStroke& stroke, Tick tick);
ecs::Mask brew_by_stroke_reads(const ecs::World& world);
ecs::Mask brew_by_stroke_writes(const MatchContext& context);

/// Components and resources that potions write when they are drunk, are over or are lost.
ecs::Mask potion_writes(const MatchContext& context);

/// Takes all potions from a wizard who dies. Writes potion_writes(), reads Wizard and Motion.
void lose_potions(MatchContext& context, ecs::Entity wizard, Tick tick);

/// Share of the full walking speed that a wizard has by potions. `potions` may be null.
double pace_of(const MatchData& data, const Potions* potions, Tick tick);
/// Share of the weight that a wizard has by potions. `potions` may be null.
double weight_of(const MatchData& data, const Potions* potions, Tick tick);

/// Draws the orders of recipes from the match's seed.
void draw_orders(MatchContext& context, std::uint64_t seed);

/// Tells a player the orders of recipes that were drawn. Reads DrawnOrders, writes EventLog and resource::Journal.
void tell_order(MatchContext& context, std::uint32_t player, Tick tick);

/// Ends a changed brew whose time is up, and drives one that swirls or rises. Writes Cauldron.
void change_brew(const MatchData& data, Cauldron& cauldron, Tick tick);

/// Removes what belongs to one filling of the cauldron: owner, clock, recipe and strokes.
void forget_filling(Cauldron& cauldron);

/// Adds the systems that end potions, hurt by poison and tell drawn recipes, every gameplay tick. With an orb in the
/// arena, it tells them instead (game/stations/orb/scrying.h).
void add_potion_systems(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game
