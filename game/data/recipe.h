// game/data/recipe.h: the recipes of potions, read from assets/potions. Each file there is one potion.
//
// A recipe is a sequence of ingredients, followed by a sequence of strokes. When a step is due depends on one
// number, the share of the brew that the newest ingredient has reached (Cauldron::reached): 0 right after the
// drop, 1 once the ingredient is everywhere. The next ingredient, or after the last one the first stroke,
// must come while this share lies in the ingredient's window. Later strokes have no window, since drawing
// them stirs the brew as well.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "game/components/ingredient.h"
#include "game/data/cauldron_rules.h"
#include "game/data/effect.h"

namespace thaum::game::inline data {

/// One ingredient of a recipe, and how far it must have spread in the brew when the next step comes.
struct RecipeIngredient {
    std::uint32_t ingredient{no_ingredient};  ///< the ingredient's number in CauldronRules::ingredients
    /// The next step must come while the share of the brew that the ingredient has reached
    /// (Cauldron::reached) is between these limits, 0 to 1.
    double least{}, most{};
};

/// Direction of rotation of a circle, as the wizard sees it.
enum class CircleSense : std::uint8_t { any, clockwise, counterclockwise };

/// One gesture of a recipe, drawn once or several times.
struct RecipeStroke {
    std::string gesture;  ///< name of the gesture
    /// Required number of times; a stroke with several whole circles counts once for each circle.
    std::uint32_t times{};
    CircleSense sense{};
    double min_force{}, max_force{};  ///< allowed range of the stroke's mean force (N)
};

/// Change of the brew by the potion, until the time is up or another ingredient is dropped in.
struct ChangedBrew {
    double viscosity{1};   ///< factor on the pure brew's viscosity
    double density{1};     ///< factor on the pure brew's density
    double elasticity{1};  ///< factor on the tension of the brew's surface
    /// Mean speed of the brew below which it is driven in a circle, clockwise seen from above (m/s); 0:
    /// never.
    double swirl{};
    double rise{};   ///< mean speed of the brew below which its middle is pushed upwards (m/s); 0: never
    double aura{1};  ///< factor on the radius within which the brew has effects on wizards (AuraRules)
    Tick lasts{};
    vec3 colour{};  ///< colour as linear light, 0 to 1; for pictures only
};

struct Recipe {
    std::string name;    ///< name of the file and of the potion
    std::string words;   ///< what the potion does, in words for its wizard
    bool drawn = false;  ///< true: the order of the ingredients is drawn for each player (DrawnOrders)
    /// Time by which each right ingredient after the first delays the spoiling of the brew (ticks)
    Tick more_time{};
    std::vector<RecipeIngredient> ingredients;
    std::vector<RecipeStroke> strokes;
    ChangedBrew fluid;
    EffectList effects{};  ///< what the potion does to the wizard who brewed it
};

/// The gesture that comes after `done` strokes; null if all strokes are done.
const RecipeStroke* next_stroke(const Recipe& recipe, std::uint32_t done);

/// Names that a recipe may use, by their numbers.
struct RecipeNames {
    std::span<const Ingredient> ingredients;
    std::span<const std::string> gestures;
};

/// Reads one recipe. Reports unknown ingredients and gestures.
Recipe read_recipe(const Config& file, std::string name, const RecipeNames& names);

}  // namespace thaum::game::inline data
