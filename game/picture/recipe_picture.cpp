#include "game/picture/recipe_picture.h"

#include <algorithm>

#include "game/components/casting.h"
#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/match/simulation.h"
#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline picture {
namespace {

/// Signed area of a closed stroke; positive: counterclockwise, with y up (m^2).
double area_of(std::span<const gesture::StrokePoint> points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto &a = points[i].at, &b = points[(i + 1) % points.size()].at;
        sum += a.x * b.y - b.x * a.y;
    }
    return sum / 2;
}

/// Copies the first example stroke of a gesture into the picture, in the direction of rotation that the
/// recipe asks for.
void take_ghost(const gesture::Gesture& gesture, CircleSense sense, double scale, RecipePicture& out) {
    if (gesture.strokes.empty() || gesture.strokes.front().size() < 2) return;
    const std::span points(gesture.strokes.front());
    vec2 low(1e9), high(-1e9);
    for (const auto& point : points) {
        low = glm::min(low, vec2(point.at));
        high = glm::max(high, vec2(point.at));
    }
    const double turns = area_of(points);
    const bool mirrored = (sense == CircleSense::clockwise && turns > 0) ||
                          (sense == CircleSense::counterclockwise && turns < 0);
    for (std::size_t i = 0; i < max_ghost_points; ++i) {
        const auto from = i * (points.size() - 1) / (max_ghost_points - 1);
        const vec2 at = scale * (vec2(points[from].at) - (low + high) / 2.0);
        out.ghost.at(i) = {mirrored ? -at.x : at.x, at.y};
    }
    out.ghost_points = max_ghost_points;
}

void take_stroke(const Simulation& match, const Cauldron& cauldron, const Recipe& recipe,
                 std::uint32_t player, RecipePicture& out) {
    out.step = RecipeStep::stroke;
    std::uint32_t done = cauldron.strokes_done;
    out.begun = done > 0;
    for (const auto& stroke : recipe.strokes) {
        if (done >= stroke.times) {
            done -= stroke.times;
            continue;
        }
        out.gesture = stroke.gesture;
        out.sense = stroke.sense;
        out.done = done;
        out.times = stroke.times;
        out.min_force = stroke.min_force;
        out.max_force = stroke.max_force;
        const auto* gestures = gestures_of(match.context(), player);
        const auto number = gestures != nullptr ? gestures->number(stroke.gesture) : std::nullopt;
        if (number)
            take_ghost(gestures->gestures()[*number], stroke.sense,
                       match.data().cauldron->ladle.metres_per_metre, out);
        return;
    }
}

/// Whether the wizard knows the order of a recipe. Only for some recipes must the orb reveal it.
bool knows(const Simulation& match, ecs::Entity wizard, const Recipe& recipe) {
    const auto* modes = match.world().find<WornModes>(wizard);
    return !recipe.drawn || modes == nullptr || modes->order_told != 0;
}

/// The wizard whose recipes are shown.
struct Brewer {
    std::uint32_t player{};
    ecs::Entity wizard;
};

/// Copies the names of all recipes that can still be made (`open`) except one, with their ingredients from
/// the step `before` on. A recipe with a secret order is listed only at the beginning: later its name would
/// reveal that the ingredients so far are right.
void take_choices(const Simulation& match, const Brewer& brewer, const RecipeList& open, const Recipe* but,
                  std::size_t before, RecipePicture& out) {
    for (std::size_t i = 0; i < open.count; ++i) {
        const auto& recipe = match.data().recipes[open.numbers[i]];
        const bool known = knows(match, brewer.wizard, recipe);
        if (&recipe == but || (!known && before > 0)) continue;
        const auto order = order_of(recipe, match.world(), brewer.player);
        for (std::size_t k = before; known && k < order.count; ++k)
            out.choice_ingredients.at(out.choices).at(k - before) =
                match.data().cauldron->ingredients[order.steps[k].ingredient].name;
        out.choice_names.at(out.choices++) = recipe.name;
    }
}

/// The recipe to show: one that needs the carried ingredient, or else the first. A recipe whose order of
/// ingredients only the orb reveals is chosen only if there is no other.
const Recipe& shown_recipe(const Simulation& match, const Brewer& brewer, const RecipeList& open,
                           std::size_t before, std::uint32_t carried) {
    const Recipe* first = nullptr;
    for (std::size_t i = 0; i < open.count; ++i) {
        const auto& recipe = match.data().recipes[open.numbers[i]];
        if (!knows(match, brewer.wizard, recipe)) continue;
        if (first == nullptr) first = &recipe;
        const auto order = order_of(recipe, match.world(), brewer.player);
        if (before < order.count && order.steps[before].ingredient == carried) return recipe;
    }
    return first != nullptr ? *first : match.data().recipes[open.numbers[0]];
}

}  // namespace

void take_recipe(const Simulation& match, std::uint32_t player, ecs::Entity wizard, std::uint32_t carried,
                 RecipePicture& out) {
    out = {};
    const auto& data = match.data();
    if (data.recipes.empty()) return;
    const auto& cauldron = match.world().single<Cauldron>();
    const auto open = recipes_open_to(data, match.world(), cauldron, player);
    const auto before = ingredients_in(cauldron);
    const Brewer brewer{player, wizard};
    if (cauldron.begun == 0) {
        if (open.count > 0) out.step = RecipeStep::choose;
        return take_choices(match, brewer, open, nullptr, 0, out);
    }
    const auto* drawn = match.world().find<DrawnStroke>(wizard);
    out.reached = cauldron.reached;
    out.begun_at = drawn != nullptr && drawn->on_brew != 0 && drawn->count > 0 ? drawn->reached : out.reached;
    if (open.count == 0) {
        out.step = RecipeStep::spoilt;
        return;
    }
    const auto& recipe = shown_recipe(match, brewer, open, before, carried);
    const auto order = order_of(recipe, match.world(), player);
    const auto& names = data.cauldron->ingredients;
    const auto& window = order.steps[before - 1];
    out.potion = recipe.name;
    out.newest = names[window.ingredient].name;
    out.least = window.least;
    out.most = window.most;
    if (const auto* ladle = match.world().find<Ladle>(wizard)) {
        out.force =
            data.casting->viscosity * glm::length(ladle->velocity) / data.cauldron->ladle.metres_per_metre;
        out.yaw = match.world().get<AtStation>(wizard).yaw;
    }
    if (before >= order.count) return take_stroke(match, cauldron, recipe, player, out);
    out.step = RecipeStep::ingredient;
    out.secret = !knows(match, wizard, recipe);
    if (!out.secret) out.next = names[order.steps[before].ingredient].name;
    take_choices(match, brewer, open, &recipe, before, out);
}

}  // namespace thaum::game::inline picture
