#include "game/hud/recipe_panel.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {
namespace {

using render::ArcItem;
using render::LineItem;
using render::Overlay;
using render::RectItem;

// height of the row about the next stroke, and width of one of its dots (HUD units)
constexpr float min_row = 18, dot_wide = 14;
constexpr float min_band = 60;  // minimum width of the force scale (HUD units)
// Text size of the words for the force (HUD units), and the smallest size that is used (px).
constexpr float words_size = 13, min_words_px = 12;
constexpr double max_shown_n = 2.5;  ///< force at the right end of the force scale (N)

std::string percent(double share) { return text(std::lround(100 * share), " %"); }

/// Names of the possible recipes with their ingredients, separated by three spaces. `before`: a word in front
/// of each.
std::string words_of_choices(const RecipePicture& recipe, std::string_view before = {}) {
    std::string words;
    for (std::uint32_t i = 0; i < recipe.choices; ++i) {
        words += text(i == 0 ? "" : "   ", before, capitalised(recipe.choice_names.at(i)), ": ");
        bool first = true;
        for (const auto name : recipe.choice_ingredients.at(i)) {
            if (name.empty()) continue;
            words += text(first ? "" : ", ", name);
            first = false;
        }
        if (first) words += "ask the orb";
    }
    return words;
}

std::string words_of_waiting(const RecipePicture& recipe) {
    if (recipe.begun_at > recipe.most) return text(recipe.newest, " is mixed too far: let it boil over");
    return text("stir until ", recipe.newest, " is mixed ", percent(recipe.least));
}

std::string_view words_of_sense(CircleSense sense) {
    switch (sense) {
        case CircleSense::any: break;
        case CircleSense::clockwise: return " clockwise";
        case CircleSense::counterclockwise: return " counterclockwise";
    }
    return "";
}

/// Words for the required force: " gently", " hard", or empty if any force is allowed.
std::string_view words_of_force(const RecipePicture& recipe) {
    constexpr double harsh = 1.2;  // required force from which on the words say "hard" (N)
    if (recipe.min_force >= harsh) return " hard";
    return recipe.max_force < max_shown_n ? " gently" : "";
}

std::string words_of_stroke(const RecipePicture& recipe, bool stirs, const ControlNames& controls) {
    const auto how = text(recipe.gesture, words_of_sense(recipe.sense), words_of_force(recipe));
    const auto count =
        recipe.times > 1 ? text(" (", recipe.done + 1, " of ", recipe.times, ")") : std::string();
    return text(stirs ? "hold " : "stir, then hold ", bracketed(controls.trace, "Trace"), " and draw: ", how,
                count);
}

/// How to drop the carried ingredient: "drop salt now with [Left mouse]". A player who does not hold the
/// ladle must take it first, because otherwise the same control would shoot.
std::string words_of_drop(const RecipePicture& recipe, bool stirs, const ControlNames& controls) {
    const auto fire = text("[", controls.fire.empty() ? "use wand" : controls.fire, "]");
    if (stirs) return text("drop ", recipe.next, " now with ", fire);
    return text(hold_or_press(controls.stir_toggles), "[", controls.stir.empty() ? "Stir" : controls.stir,
                "], then drop ", recipe.next, " with ", fire);
}

/// The required force in words: "gently", "hard", "any force".
std::string words_of_band(const RecipePicture& recipe) {
    const auto words = words_of_force(recipe);
    return words.empty() ? "any force" : std::string(words.substr(1));
}

/// Text size of the words for the force, at least min_words_px (px).
float words_em(float u) { return std::max(min_words_px, std::floor(words_size * u)); }

/// Adds one dot for each required stroke; those already drawn are filled.
void add_dots(Overlay& out, const RecipePicture& recipe, fvec2 low, float u) {
    for (std::uint32_t i = 0; i < recipe.times; ++i) {
        const fvec2 centre = low + u * fvec2(6 + dot_wide * static_cast<float>(i), 6);
        out.items.emplace_back(ArcItem{centre, 3.5F * u, 5.5F * u, 0, whole_turn, paints.white});
        if (i < recipe.done)
            out.items.emplace_back(ArcItem{centre, 0, 3.5F * u, 0, whole_turn, paints.white});
    }
}

/// Adds the bar of the force, with the allowed range and a mark at the current force.
void add_force_band(Overlay& out, const RecipePicture& recipe, const Panel& bar, float u) {
    const auto x = [&](double force) {
        const auto share = static_cast<float>(std::clamp(force / max_shown_n, 0.0, 1.0));
        return bar.low.x + share * (bar.high.x - bar.low.x);
    };
    out.items.emplace_back(RectItem{bar.low, bar.high, paints.track, 3 * u});
    const bool inside = recipe.force >= recipe.min_force && recipe.force <= recipe.max_force;
    out.items.emplace_back(RectItem{{x(recipe.min_force), bar.low.y},
                                    {x(recipe.max_force), bar.high.y},
                                    inside ? paints.white : paints.soft,
                                    3 * u});
    const float current = x(recipe.force);
    out.items.emplace_back(
        LineItem{{current, bar.low.y - 4 * u}, {current, bar.high.y + 4 * u}, 5 * u, paints.dark});
    out.items.emplace_back(
        LineItem{{current, bar.low.y - 3 * u}, {current, bar.high.y + 3 * u}, 2.5F * u, paints.amber});
}

}  // namespace

std::string words_of_step(const PlayerPicture& player, const ControlNames& controls) {
    const auto& recipe = player.stations.recipe;
    const auto potion = capitalised(recipe.potion);
    switch (recipe.step) {
        case RecipeStep::none: return {};
        case RecipeStep::choose: return words_of_choices(recipe);
        case RecipeStep::spoilt:
            return "Nothing comes of this brew any more: stand back until it has boiled over";
        case RecipeStep::ingredient:
            if (recipe.secret) return "What comes next, only the orb tells";
            if (player.stations.stirs && !recipe.in_time())
                return text(potion, ": ", words_of_waiting(recipe));
            return text(potion, ": ",
                        player.stations.carries == recipe.next
                            ? words_of_drop(recipe, player.stations.stirs, controls)
                            : text("fetch ", recipe.next, " next"),
                        recipe.choices > 0 ? "   " : "", words_of_choices(recipe, "or "));
        case RecipeStep::stroke:
            if (!recipe.in_time()) return text(potion, ": ", words_of_waiting(recipe));
            return text(potion, ": ", words_of_stroke(recipe, player.stations.stirs, controls));
    }
    return {};
}

void add_ghost(Overlay& out, const RecipePicture& recipe, fvec2 centre, float half, double seconds, float u) {
    const std::span points(recipe.ghost.data(), recipe.ghost_points);
    double largest = 1e-6;
    for (const auto& point : points) largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    const auto at = [&](std::size_t i) {
        return centre + half / static_cast<float>(largest) * fvec2(vec2(points[i].x, -points[i].y));
    };
    for (std::size_t i = 1; i < points.size(); ++i)
        out.items.emplace_back(LineItem{at(i - 1), at(i), std::max(1.5F, 2 * u), paints.soft});
    out.items.emplace_back(ArcItem{at(0), 0, 3 * u, 0, whole_turn, paints.white});
    // Time of one run of the dot along the stroke's shape (s), and share of it for which the dot rests at the
    // end.
    constexpr double period = 1.6, pause = 0.25;
    const double share = std::min(1.0, std::fmod(seconds, period) / period / (1 - pause));
    const auto runner = static_cast<std::size_t>(share * static_cast<double>(points.size() - 1));
    out.items.emplace_back(ArcItem{at(runner), 0, 4.5F * u, 0, whole_turn, paints.amber});
}

float stroke_row_high(float u) { return std::max(min_row * u, FittedWords::line_spacing * words_em(u)); }

float stroke_row_wide(const RecipePicture& recipe, float u) {
    return (dot_wide * static_cast<float>(recipe.times) + 4 + min_band + 16) * u +
           width_of(words_of_band(recipe), words_em(u)) + 2;
}

void add_stroke_row(Overlay& out, const RecipePicture& recipe, const Panel& row, float u) {
    const float middle = (row.low.y + row.high.y) / 2;
    add_dots(out, recipe, {row.low.x, middle - 6 * u}, u);
    const auto words = words_of_band(recipe);
    const float left = row.low.x + (dot_wide * static_cast<float>(recipe.times) + 4) * u;
    const float right = std::min(left + width_of(words, words_em(u)) + 2, row.high.x);
    add_text_in(out, {{left, row.low.y}, {right, row.high.y + 1}}, words, words_em(u), paints.white,
                render::Align::left);
    if (row.high.x - right >= min_band * u)
        add_force_band(out, recipe, {{right + 8 * u, middle - 4 * u}, {row.high.x - 8 * u, middle + 4 * u}},
                       u);
}

}  // namespace thaum::game::inline hud
