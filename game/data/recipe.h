// game/data/recipe.h: the recipes of potions, read from assets/potions. Each file there is one potion.
//
// A recipe is an order of ingredients and then an order of strokes. Its moments are told by one number, the share of
// the brew that the newest ingredient has reached (Cauldron::reached): 0 right after the drop, 1 once it is everywhere.
// The next ingredient, or after the last one the first stroke, must come while this share lies in the ingredient's
// window. Later strokes come whenever the wizard likes, since drawing them stirs as well.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "game/components/ingredient.h"
#include "game/data/cauldron_rules.h"
#include "game/data/potion_effect.h"

namespace thaum::game {

/// One ingredient of a recipe, and the window of Cauldron::reached in which the next step must come.
struct RecipeIngredient {
    std::uint32_t ingredient{no_ingredient};  ///< its number in CauldronRules::ingredients
    double least{}, most{};                   ///< window (share of the brew, 0 to 1)
};

/// Sense of a circle, as the wizard sees it.
enum class CircleSense : std::uint8_t { any, clockwise, counterclockwise };

/// One gesture of a recipe, drawn once or several times.
struct RecipeStroke {
    std::string gesture;    ///< name of the gesture
    std::uint32_t times{};  ///< number of times; a stroke with several whole circles counts once for each
    CircleSense sense{};
    double least_force{}, most_force{};  ///< band of the stroke's mean force (N)
};

/// What the potion makes of the brew, until the time is up or another ingredient is dropped in.
struct ChangedBrew {
    double viscosity{1};   ///< multiple of the pure brew's viscosity
    double density{1};     ///< multiple of the pure brew's density
    double elasticity{1};  ///< multiple of the tension of the surface
    double swirl{};        ///< mean speed below which the brew is driven round (m/s); 0: it is not
    double rise{};         ///< upward speed that the middle of the brew is given in each push (m/s)
    double aura{1};        ///< multiple of the aura's radius
    Tick lasts{};
    vec3 colour{};  ///< linear light, 0 to 1; for pictures only
};

/// What the potion does to the wizard who brewed it, besides its effects.
struct PotionGift {
    Tick lasts{};
    double pace{1};          ///< multiple of the walking speed
    double gravity{1};       ///< share of the weight that is left
    bool work_half = false;  ///< the wizard holds half of the Great Work until death
};

struct Recipe {
    std::string name;    ///< name of the file and of the potion
    std::string effect;  ///< what the potion does, in words for its wizard
    bool drawn = false;  ///< true: the order of the ingredients is drawn for each player (DrawnOrders)
    Tick more_time{};    ///< time until the brew spoils that each right ingredient after the first one adds
    std::vector<RecipeIngredient> ingredients;
    std::vector<RecipeStroke> strokes;
    ChangedBrew fluid;
    PotionGift gift;
    std::vector<std::shared_ptr<const PotionEffect>> effects;
};

/// The gesture that comes after `done` strokes; null if all are done.
const RecipeStroke* next_stroke(const Recipe& recipe, std::uint32_t done);

/// Names that a recipe may use, by their numbers.
struct RecipeNames {
    std::span<const Ingredient> ingredients;
    std::span<const std::string> gestures;
};

/// Reads one recipe. Reports unknown ingredients and gestures.
Recipe read_recipe(const Config& file, std::string name, const RecipeNames& names);

}  // namespace thaum::game
