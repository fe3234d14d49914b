// game/picture/recipe_picture.h: what a wizard at the cauldron can brew next, as plain data for the HUD.
#pragma once
#include <array>
#include <string_view>

#include "ecs/world.h"
#include "game/data/recipe.h"

namespace thaum::game::inline match {
class Simulation;
}

namespace thaum::game::inline picture {

/// Kind of the next step of a recipe.
enum class RecipeStep : std::uint8_t {
    none,        ///< no recipe can be continued: there is no cauldron, or the wizard is not at it
    choose,      ///< the brew is pure, so any recipe can be begun
    ingredient,  ///< the next step is an ingredient
    stroke,      ///< the next step is a stroke
    spoilt       ///< the brew can no longer become a potion
};

inline constexpr std::size_t max_ghost_points = 40;

struct RecipePicture {
    RecipeStep step{};
    std::string_view potion;  ///< name of the shown recipe
    std::string_view newest;  ///< newest ingredient in the brew; empty: none
    std::string_view next;    ///< next ingredient; empty: the next step is a stroke
    bool secret{};            ///< true: the next ingredient is in an order that only the orb reveals
    double reached{};         ///< share of the brew that the newest ingredient has reached so far, 0 to 1
    /// Value of the share `reached` when the present stroke on the brew began; without a stroke, the present
    /// value.
    double begun_at{};
    double least{}, most{};    ///< least and greatest `reached` at which the next step may come
    std::string_view gesture;  ///< next gesture; empty: the next step is an ingredient
    CircleSense sense{};       ///< required direction of rotation of the next gesture
    /// Number of correct strokes of this gesture so far, and the required number.
    std::uint32_t done{}, times{};
    bool begun{};  ///< true after the first correct stroke: from then on `reached` no longer matters
    double min_force{}, max_force{};  ///< allowed range of the mean force of the next stroke (N)
    double force{};                   ///< present force of the ladle, computed as the force of a stroke is
                                      ///< (N)
    /// Shape of the next gesture as the wizard sees it: x to the right, y away, around the middle of the brew
    /// (m, as large as the ladle draws it). Only the first `ghost_points` are used.
    std::array<vec2, max_ghost_points> ghost{};
    std::uint32_t ghost_points{};
    double yaw{};  ///< yaw of the frame in which the ladle moves (rad); valid while the wizard stirs
    /// Recipes that can be begun, or others that can be continued: their names, and the ingredients still
    /// needed; only the first `choices` are used. No ingredients are listed if only the orb reveals them.
    std::array<std::string_view, 8> choice_names{};
    std::array<std::array<std::string_view, 3>, 8> choice_ingredients{};
    std::uint32_t choices{};

    /// Whether the newest ingredient has spread as far as the next step of the recipe requires, and not too
    /// far.
    bool in_time() const { return begun || (reached >= least && begun_at <= most); }
};

/// Copies the recipes that a player can begin or continue. `carried`: number of the carried ingredient;
/// no_ingredient: none.
void take_recipe(const Simulation& match, std::uint32_t player, ecs::Entity wizard, std::uint32_t carried,
                 RecipePicture& out);

}  // namespace thaum::game::inline picture
