// game/picture/recipe_picture.h: what a wizard at the cauldron can brew next, as plain data for the HUD.
#pragma once
#include <array>
#include <string_view>

#include "ecs/world.h"
#include "game/data/recipe.h"

namespace thaum::game {

class Simulation;

/// Next step of a recipe.
enum class RecipeStep : std::uint8_t {
    none,        ///< no recipe is open: there is no cauldron, or the wizard is not at it
    choose,      ///< the brew is pure: any recipe can be begun
    ingredient,  ///< an ingredient comes next
    stroke,      ///< a stroke comes next
    spoilt       ///< nothing can come of this brew
};

inline constexpr std::size_t most_ghost_points = 40;

struct RecipePicture {
    RecipeStep step{};
    std::string_view potion;        ///< name of the recipe that is shown
    std::string_view newest;        ///< ingredient that was dropped in last; empty: none
    std::string_view next;          ///< ingredient that comes next; empty: a stroke
    bool secret{};                  ///< the recipe goes on by an order that only the orb tells
    double reached{};               ///< share of the brew that the newest one has reached, 0 to 1
    double begun_at{};              ///< that share when the present stroke on the brew began; else `reached`
    double least{}, most{};         ///< window of `reached` for the next step
    std::string_view gesture;       ///< gesture that comes next; empty: an ingredient
    CircleSense sense{};            ///< sense of that gesture
    std::uint32_t done{}, times{};  ///< number of right strokes of this gesture, and of all that are wanted
    bool begun{};                   ///< true after the first right stroke: the moment no longer counts
    double least_force{}, most_force{};  ///< band of the stroke's mean force (N)
    double force{};                      ///< present force of the ladle, as a stroke has it (N)
    /// Shape of the next gesture as the wizard sees it: x to the right, y away, in metres of the ladle about the middle of
    /// the brew. The first `ghost_points` are in use.
    std::array<vec2, most_ghost_points> ghost{};
    std::uint32_t ghost_points{};
    double yaw{};  ///< direction of the ladle's frame (rad); meaningful while the wizard stirs
    /// Recipes that can be begun, or other ones that can go on: their names, and the ingredients that come; the first
    /// `choices`. Without ingredients: only the orb tells them.
    std::array<std::string_view, 8> choice_names{};
    std::array<std::array<std::string_view, 3>, 8> choice_ingredients{};
    std::uint32_t choices{};

    /// True while the next step may be done by its moment.
    bool in_time() const { return begun || (reached >= least && begun_at <= most); }
};

/// Takes the recipes that are open to a player. `carried`: number of the carried ingredient; no_ingredient: none.
void take_recipe(const Simulation& match, std::uint32_t player, ecs::Entity wizard, std::uint32_t carried,
                 RecipePicture& out);

}  // namespace thaum::game
