#include "game/bots/brewing.h"

#include <algorithm>
#include <cmath>

#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline bots {
namespace {

namespace hand = input::hand;

// Ticks for which the hand rests with the button Trace held, before and after the stroke itself.
constexpr Tick rest_before = 24, rest_after = 24;
constexpr double gentle = 0.65, plain = 1.2, hard = 1.9;  // mean force of a gentle, a usual and a hard stroke
                                                          // (N)

const Cauldron& cauldron_of(const Simulation& match) { return match.world().single<Cauldron>(); }

/// Place of the niche (place of ingredients) at which the wizard can pick up this ingredient: the nearest one
/// that is not empty. std::nullopt if all are empty.
std::optional<vec3> niche_of(const BotTurn& turn, std::uint32_t ingredient) {
    const auto& world = turn.match.world();
    const auto from = world.get<Motion>(wizard_of(world, turn.seat.player)).position;
    std::optional<vec3> best;
    world.view<const Niche, const Motion>().each([&](const Niche& niche, const Motion& motion) {
        if (niche.ingredient != ingredient || turn.tick < niche.back_at) return;
        if (!best || glm::distance(from, motion.position) < glm::distance(from, *best))
            best = motion.position;
    });
    return best;
}

/// Whether a straight way passes a place at less than `clear` (m). A way that leads away from the place does
/// not count.
bool comes_near(vec3 place, vec3 from, vec3 to, double clear) {
    const vec2 way(to.x - from.x, to.z - from.z), off(place.x - from.x, place.z - from.z);
    const double length = glm::dot(way, way);
    const double share = length > 0 ? std::clamp(glm::dot(off, way) / length, 0.0, 1.0) : 0;
    return share > 0 && glm::length(off - share * way) < clear;
}

/// Whether a straight way to a niche (a place of ingredients) passes no other niche that holds an ingredient.
bool passes_no_niche(const BotTurn& turn, vec3 from, vec3 niche) {
    const auto& match = turn.match;
    // Margin to the other niche (a place of ingredients), so that the bot does not pick up what lies there
    // (m)
    constexpr double room = 0.5;
    bool free = true;
    match.world().view<const Niche, const Motion>().each([&](const Niche& other, const Motion& motion) {
        if (turn.tick < other.back_at || motion.position == niche) return;
        free &= !comes_near(motion.position, from, niche, match.data().cauldron->niche_radius + room);
    });
    return free;
}

/// Place to walk to for a niche (a place of ingredients). It is the niche itself, or a place beside it if
/// another niche lies on the way. A wizard who walks over a niche takes the ingredient there, so the bot must
/// avoid the other one.
vec3 way_to_niche(const BotTurn& turn, vec3 from, vec3 niche) {
    if (passes_no_niche(turn, from, niche)) return niche;
    const auto& grid = turn.grid;
    const vec3 out = niche - cauldron_of(turn.match).middle;
    const vec3 side = vec3(-out.z, 0, out.x) / std::max(1e-6, off_axis(out));
    const double sign = glm::dot(from - niche, side) < 0 ? -1 : 1;
    for (const double beside : {3.0, 4.5, 2.2, -3.0, -4.5, -2.2}) {
        const vec3 place = niche + sign * beside * side;
        if (grid.in_large_region(grid.cell_at(place)) && passes_no_niche(turn, place, niche)) return place;
    }
    return niche;
}

/// Mean force with which a bot draws a stroke of a recipe: well within the range that the recipe allows (N).
double force_for(const RecipeStroke& stroke) {
    if (stroke.min_force > plain) return std::max(hard, 1.2 * stroke.min_force);
    return stroke.max_force < plain ? std::min(gentle, 0.8 * stroke.max_force) : plain;
}

/// Points of the gesture's first recorded stroke (its template), with their length (m).
struct StrokePath {
    std::span<const gesture::StrokePoint> points;
    double length{};
    bool mirrored = false;
    double force{};
};

StrokePath path_of(const Simulation& match, const Seat& seat, const StirPlan& plan) {
    const auto* gestures = gestures_of(match.context(), seat.player);
    const auto* stroke = next_stroke(match.data().recipes[plan.recipe], plan.stroke);
    if (gestures == nullptr || stroke == nullptr) return {};
    const auto number = gestures->number(stroke->gesture);
    if (!number || gestures->gestures()[*number].strokes.empty()) return {};
    StrokePath path{.points = gestures->gestures()[*number].strokes.front(), .force = force_for(*stroke)};
    double area = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const auto &a = path.points[i - 1].at, &b = path.points[i].at;
        path.length += glm::distance(vec2(a), vec2(b));
        area += a.x * b.y - b.x * a.y;
    }
    path.mirrored = (stroke->sense == CircleSense::clockwise && area > 0) ||
                    (stroke->sense == CircleSense::counterclockwise && area < 0);
    return path;
}

/// Time in which the hand draws the path (ticks). A hand that draws feels a drag proportional to its speed,
/// so the wanted mean force gives the mean speed: force / viscosity.
Tick time_of(const Simulation& match, const StrokePath& path) {
    const double speed = path.force / match.data().casting->viscosity;
    return std::max<Tick>(1, ticks(path.length / speed));
}

/// Point of the path after a share of its length, 0 to 1 (m).
vec2 place_on(const StrokePath& path, double share) {
    double left = std::clamp(share, 0.0, 1.0) * path.length;
    vec2 at(path.points.front().at);
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const vec2 from(path.points[i - 1].at), to(path.points[i].at);
        const double step = glm::distance(from, to);
        at = step > left ? glm::mix(from, to, left / step) : to;
        if (step >= left) break;
        left -= step;
    }
    return {path.mirrored ? -at.x : at.x, at.y};
}

}  // namespace

std::uint32_t choose_recipe(const Simulation& match, const Seat& seat, Random& random) {
    const auto& data = match.data();
    const auto wizard = wizard_of(match.world(), seat.player);
    const auto* pouch = match.world().find<Pouch>(wizard);
    std::uint32_t chosen = no_potion, count = 0;
    for (std::uint32_t i = 0; i < data.recipes.size(); ++i) {
        // A recipe with a random order belongs to the Great Work (to win a round by holding two rare things).
        // These bots do not try it.
        const auto& recipe = data.recipes[i];
        const bool acts = end_of(recipe.effects, match.world().get<Effects>(wizard)) != 0;
        const bool fits = pouch == nullptr || recipe.ingredients.front().ingredient == pouch->ingredient;
        if (recipe.drawn || acts || !fits) continue;
        ++count;
        if (random.below(count) == 0) chosen = i;
    }
    return chosen;
}

BrewStep next_brew_step(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& seat = turn.seat;
    const auto& plan = turn.stir_plan;
    const auto& cauldron = cauldron_of(match);
    const auto& recipe = match.data().recipes[plan.recipe];
    const auto order = order_of(recipe, match.world(), seat.player);
    const auto in = ingredients_in(cauldron);
    const auto contents = contents_to_come(cauldron);
    const bool mine = cauldron.begun == 0 || cauldron.owner == seat.player;
    for (std::size_t i = 0; i < in; ++i)
        if (i >= order.count || contents[i] != order.steps[i].ingredient) return {.task = BrewTask::done};
    if (!mine || cauldron.fault != BrewFault::none || in < plan.dropped) return {.task = BrewTask::done};
    const bool ripe = in == 0 || cauldron.reached >= order.steps[in - 1].least;
    if (in > 0 && cauldron.strokes_done == 0 && cauldron.reached > order.steps[in - 1].most)
        return {.task = BrewTask::done};
    if (in == order.count)
        return {.task = ripe || cauldron.strokes_done > 0 ? BrewTask::draw : BrewTask::carry};
    const auto* pouch = match.world().find<Pouch>(wizard_of(match.world(), seat.player));
    const auto wanted = order.steps[in].ingredient;
    if (pouch != nullptr && pouch->ingredient != wanted) return {.task = BrewTask::done};
    if (pouch != nullptr) return {.task = ripe ? BrewTask::drop : BrewTask::carry};
    if (!ripe) return {.task = BrewTask::carry};
    const auto niche = niche_of(turn, wanted);
    if (!niche) return {.task = BrewTask::done};
    const auto from = match.world().get<Motion>(wizard_of(match.world(), seat.player)).position;
    return {.task = BrewTask::fetch, .place = way_to_niche(turn, from, *niche)};
}

Tick stroke_length(const Simulation& match, const Seat& seat, const StirPlan& plan) {
    const auto path = path_of(match, seat, plan);
    return path.points.empty() ? 0 : rest_before + time_of(match, path) + rest_after;
}

void draw_hand(const Simulation& match, const Seat& seat, const StirPlan& plan, Tick tick,
               input::DeviceSample& sample) {
    sample.press(input::Button::trace);
    const auto path = path_of(match, seat, plan);
    const Tick age = tick - plan.drawing_from;
    if (path.points.size() < 2 || age < rest_before) return;
    const double micrometres = 1e6 / match.data().haptic_rules.clutch_per_count;
    const auto time = static_cast<double>(time_of(match, path));
    const auto counts_at = [&](Tick at) {
        const vec2 place = micrometres * place_on(path, static_cast<double>(at) / time);
        return std::pair(std::lround(place.x), std::lround(place.y));
    };
    const auto before = counts_at(age - rest_before), after = counts_at(age - rest_before + 1);
    sample.counts[hand::look_right] = static_cast<std::int32_t>(after.first - before.first);
    sample.counts[hand::look_up] = static_cast<std::int32_t>(after.second - before.second);
}

}  // namespace thaum::game::inline bots
