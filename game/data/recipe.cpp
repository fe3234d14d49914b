#include "game/data/recipe.h"

#include <algorithm>

#include "core/colour.h"
#include "core/near_name.h"
#include "core/text.h"
#include "game/components/potions.h"

namespace thaum::game::inline data {
namespace {

constexpr Range part{0, 1};  // range of a share, 0 to 1

RecipeIngredient read_ingredient(const ConfigTable& table, const RecipeNames& names) {
    const auto name = table.string("name");
    const auto found = std::find_if(names.ingredients.begin(), names.ingredients.end(),
                                    [&](const Ingredient& i) { return i.name == name; });
    if (found == names.ingredients.end())
        table.report("name", text("cauldron.toml has no ingredient '", name, "'",
                                  did_you_mean(name, names.ingredients, &Ingredient::name)));
    const RecipeIngredient read{.ingredient = static_cast<std::uint32_t>(found - names.ingredients.begin()),
                                .least = table.number("least", part),
                                .most = table.number("most", part)};
    if (read.most < read.least) table.report("most", "'most' must not be less than 'least'");
    return read;
}

RecipeStroke read_stroke(const ConfigTable& table, const RecipeNames& names) {
    constexpr Range force{0, 1000};
    RecipeStroke read{.gesture = table.string("gesture"),
                      .times = static_cast<std::uint32_t>(table.integer("times", {1, 20}, 1))};
    const auto found = std::find(names.gestures.begin(), names.gestures.end(), read.gesture);
    if (found == names.gestures.end())
        table.report("gesture", text("no file of gestures has the name '", read.gesture, "'",
                                     did_you_mean(read.gesture, names.gestures)));
    read.sense = static_cast<CircleSense>(table.choice("turn", {"any", "clockwise", "counterclockwise"}, 0));
    read.min_force = table.number("least_n", force, 0);
    read.max_force = table.number("most_n", {0.05, force.high}, force.high);
    if (read.max_force < read.min_force) table.report("most_n", "'most_n' must not be less than 'least_n'");
    return read;
}

ChangedBrew read_changed_brew(const ConfigTable& table) {
    constexpr Range factor{0.01, 100};
    return {.viscosity = table.number("viscosity", factor, 1),
            .density = table.number("density", factor, 1),
            .elasticity = table.number("elasticity", factor, 1),
            .swirl = table.number("swirl_m_s", {0, 5}, 0),
            .rise = table.number("rise_m_s", {0, 5}, 0),
            .aura = table.number("aura", factor, 1),
            .lasts = ticks(table.number("lasts_s", {0, 3600}))};
}

void check_lengths(const ConfigTable& root, const Recipe& recipe) {
    if (recipe.ingredients.empty() || recipe.ingredients.size() > max_recipe_ingredients)
        root.report("ingredient", text("there must be 1 to ", max_recipe_ingredients, " ingredients"));
    for (std::size_t i = 1; i < recipe.ingredients.size(); ++i) {
        const auto end = recipe.ingredients.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::any_of(recipe.ingredients.begin(), end, [&](const RecipeIngredient& other) {
                return other.ingredient == recipe.ingredients[i].ingredient;
            }))
            root.report("ingredient", "each ingredient may come once");
    }
    if (recipe.strokes.empty()) root.report("stroke", "there must be a stroke at least");
}

}  // namespace

const RecipeStroke* next_stroke(const Recipe& recipe, std::uint32_t done) {
    for (const auto& stroke : recipe.strokes) {
        if (done < stroke.times) return &stroke;
        done -= stroke.times;
    }
    return nullptr;
}

Recipe read_recipe(const Config& file, std::string name, const RecipeNames& names) {
    const auto root = file.root();
    const auto look = root.table("look");
    Recipe recipe{.name = std::move(name),
                  .words = look.string("effect"),
                  .drawn = root.boolean("drawn_order", false),
                  .more_time = ticks(root.number("more_time_s", {0, 3600}, 0)),
                  .ingredients = {},
                  .strokes = {},
                  .fluid = read_changed_brew(root.table("fluid")),
                  .effects = read_effects(root)};
    if (recipe.words.empty()) look.report("effect", "effect must say in a few words what the potion does");
    recipe.fluid.colour = read_linear_colour(look, "colour");
    for (const auto& table : root.tables("ingredient"))
        recipe.ingredients.push_back(read_ingredient(table, names));
    for (const auto& table : root.tables("stroke")) recipe.strokes.push_back(read_stroke(table, names));
    check_lengths(root, recipe);
    return recipe;
}

}  // namespace thaum::game::inline data
