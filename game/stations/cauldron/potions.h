// game/stations/cauldron/potions.h: potions in the match (MANUAL.md, "The cauldron"): which recipes a brew
// can still become, and how strokes drawn on it are judged. context/effects.h has what a potion does to its
// wizard.
//
//     ingredients in their order, each in the window of the one before   drop_for_recipe()
//     strokes, the first one in the window of the last ingredient        brew_by_stroke()
//     last stroke: the wizard drinks the potion, the brew is changed     Effects, Cauldron::potion
//
// A step is in the window of an ingredient while the share of the brew that this ingredient has reached lies
// in a range that the recipe gives. A wrong step costs only time: a wrong stroke may be drawn again. But
// after a wrong ingredient or a step that comes too late, the brew can become no potion until it has boiled
// over.
#pragma once
#include "game/components/stroke_reading.h"
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline stations {

/// A recipe's ingredients in the order that one player must follow.
struct RecipeOrder {
    std::array<RecipeIngredient, max_recipe_ingredients> steps{};
    std::size_t count{};
};
/// The order of a recipe for a player. Reads DrawnOrders.
RecipeOrder order_of(const Recipe& recipe, const ecs::World& world, std::uint32_t player);

/// A list of recipes by their numbers.
struct RecipeList {
    std::array<std::uint32_t, max_potions> numbers{};
    std::size_t count{};
};
/// Recipes that this player can still complete with the present brew: all recipes if the brew is empty, none
/// after a fault.
RecipeList recipes_open_to(const MatchData& data, const ecs::World& world, const Cauldron& cauldron,
                           std::uint32_t player);

/// Number of ingredients in the brew, including those queued for the next fluid step.
std::size_t ingredients_in(const Cauldron& cauldron);
/// Contents of the brew after the next fluid step.
Contents contents_to_come(const Cauldron& cauldron);

/// Tick of play at which the brew boils over; without meaning for a brew without ingredients.
Tick spoils_at(const MatchData& data, const Cauldron& cauldron);

/// Judges an ingredient and records a right or wrong step. Must be called just before the ingredient is
/// dropped in. Writes Cauldron, EventLog and resource::Journal.
void drop_for_recipe(MatchContext& context, Cauldron& cauldron, std::uint32_t player,
                     std::uint32_t ingredient, Tick tick);
/// Records that a fourth ingredient has no room in the brew.
void refuse_fourth(MatchContext& context, const Cauldron& cauldron, std::uint32_t player, Tick tick);

/// A stroke drawn on the brew. The recipe asks for it while the share of the brew that the newest ingredient
/// has reached (Cauldron::reached) lies in a range. Drawing also mixes the brew and so raises the share. So
/// the end of the range is compared with the share when the stroke began. The beginning of the range is
/// compared with the share when the stroke was finished.
struct BrewStroke {
    StrokeReading reading{};
    double begun_at{};  ///< share of the brew reached by the newest ingredient as the stroke began, 0 to 1
};

/// Judges a stroke that a wizard with a Ladle has drawn, in a gameplay tick. A stroke that was not recognised
/// is ignored. The calling system must have declared brew_by_stroke_reads() and brew_by_stroke_writes().
void brew_by_stroke(MatchContext& context, ecs::Entity wizard, const BrewStroke& stroke, Tick tick);
ecs::Mask brew_by_stroke_reads(const ecs::World& world);
ecs::Mask brew_by_stroke_writes(const MatchContext& context);

/// Draws the random orders of recipes' ingredients from the match's seed.
void draw_orders(MatchContext& context, std::uint64_t seed);

/// Shows a player the order of ingredients of each recipe whose order was drawn at random. Reads DrawnOrders,
/// writes EventLog and resource::Journal.
void tell_order(MatchContext& context, std::uint32_t player, Tick tick);

/// Ends the change of a brew by a potion when its time is up, and drives a brew that swirls or rises. Writes
/// Cauldron.
void change_brew(const MatchData& data, Cauldron& cauldron, Tick tick);

/// Clears the data about one filling of the cauldron: owner, times, recipe and strokes.
void forget_filling(Cauldron& cauldron);

/// Adds the system that shows players the orders of ingredients that were drawn at random. In an arena with
/// an orb, the orb shows those orders instead (game/stations/orb/scrying.h).
void add_drawn_orders_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
