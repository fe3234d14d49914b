#include "game/hud/rim_card.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/hud/overlay.h"
#include "game/hud/recipe_panel.h"

namespace thaum::game::inline hud {
namespace {

using render::LineItem;
using render::Overlay;
using render::RectItem;

// Sizes in units of the card. The card's unit is smaller than a HUD unit if the card's text needs that.
constexpr float card_pad = 4, card_gap = 2;
constexpr float ghost_side = 52;
constexpr float gauge_high = 11, gauge_wide = 150, min_gauge = 70;
constexpr float step_size = 15, brew_size = 13;  // text sizes (units of the card)
constexpr float readable = 12;                   // text size below which text should not shrink (px)

// ---- Words ------------------------------------------------------------------------------------------------

std::string whole_seconds(double seconds) { return text(std::lround(std::ceil(seconds)), " s"); }

/// Whether the brew has ingredients of a recipe. If so, text and gauge call "mixed" the share of the brew
/// that the newest ingredient has reached, because that decides when the recipe's next step is due. Otherwise
/// they show the evenness of the mixture. The share is kept even after the recipe has failed, because a
/// change to the evenness would look as if the brew had separated.
bool has_recipe(const RecipePicture& recipe) {
    return recipe.step == RecipeStep::ingredient || recipe.step == RecipeStep::stroke ||
           recipe.step == RecipeStep::spoilt;
}

/// Text about a pure brew: what a player must know before the first ingredient.
std::string words_of_pure_brew(const CauldronPicture& cauldron, const RecipePicture& recipe) {
    if (recipe.step != RecipeStep::choose || cauldron.whole_time_s <= 0) return "Pure brew";
    return text("Pure brew: all within ", whole_seconds(cauldron.whole_time_s),
                ", or it boils over and hurts");
}

/// The state of the brew in words: ingredients, mixing, owner, effects and time left. Example: "Ember and
/// salt, mixed 57 %, yours, slows, boils over in 12 s".
std::string words_of_brew(const CauldronPicture& cauldron, const RecipePicture& recipe,
                          std::uint32_t player) {
    std::string words;
    for (const auto name : cauldron.contents) {
        if (!name.empty()) words += text(words.empty() ? "" : " and ", name);
    }
    if (words.empty() && !cauldron.potion.empty()) {
        words = text("The brew of ", cauldron.potion);
        if (cauldron.slows) words += ", slows";
        if (cauldron.lifts) words += ", lifts";
        return words;
    }
    if (words.empty()) return words_of_pure_brew(cauldron, recipe);
    words = text(capitalised(words), ", mixed ",
                 static_cast<int>(100 * (has_recipe(recipe) ? recipe.reached : cauldron.mixed)), " %");
    if (cauldron.owner < players) words += cauldron.owner == player ? ", yours" : ", your foe's";
    if (cauldron.slows) words += ", slows";
    if (cauldron.lifts) words += ", lifts";
    if (cauldron.boon_for == player) words += ", heals you";
    if (cauldron.boon_in_s > 0 && cauldron.owner == player)
        words += text(", heals in ", whole_seconds(cauldron.boon_in_s));
    if (recipe.step == RecipeStep::spoilt && cauldron.owner == player && cauldron.boon_open)
        words += text(", even ", static_cast<int>(100 * cauldron.mixed), " % (heals you from ",
                      std::lround(100 * cauldron.well_mixed), " %)");
    if (cauldron.spoils_in_s > 0) words += text(", boils over in ", whole_seconds(cauldron.spoils_in_s));
    return words;
}

BrewGauge gauge_of(const CauldronPicture& cauldron, const RecipePicture& recipe) {
    const bool owned = cauldron.owner < players;
    const auto paint = owned ? opaque(team_colours(cauldron.owner).glow) : paints.white;
    const auto fresh = static_cast<float>(std::clamp(cauldron.fresh, 0.0, 1.0));
    if (has_recipe(recipe)) {
        const bool waits = recipe.step != RecipeStep::spoilt && !recipe.begun;
        return {.mixed = static_cast<float>(recipe.reached),
                .fresh = fresh,
                .window = waits ? std::optional<fvec2>(vec2(recipe.least, recipe.most)) : std::nullopt,
                .paint = paint};
    }
    return {.mixed = static_cast<float>(std::clamp(cauldron.mixed, 0.0, 1.0)),
            .fresh = fresh,
            .goal = static_cast<float>(std::clamp(cauldron.well_mixed, 0.0, 1.0)),
            .paint = paint};
}

// ---- Fitting ----------------------------------------------------------------------------------------------

float height_of(const FittedWords& words, float u) {
    return words.lines.empty() ? 0 : words.height() + card_gap * u;
}

float widest_line(const FittedWords& words) {
    float wide = 0;
    for (const auto& line : words.lines) wide = std::max(wide, width_of(line, words.size));
    return wide;
}

/// Which of the optional parts a card has. The text of the next step, the gauge and the dots are always
/// shown.
struct Parts {
    bool ghost = true, potions = true, brew = true;
};

/// Breaks and sizes a card's texts about the brew and the potions so that they fit, on one line if possible.
void fit_state(const RimCard& card, const Parts& parts, float em, fvec2 room, FittedCard& out) {
    const auto both = text(card.brew, "   ", card.potions);
    const bool said = parts.brew && parts.potions && !card.brew.empty() && !card.potions.empty();
    if (said && width_of(both, em) <= room.x) {
        out.brew = fit(both, em, room);
        return;
    }
    if (parts.brew) out.brew = fit(card.brew, em, room);
    if (parts.potions) out.potions = fit(card.potions, em, room);
}

/// The card fitted with text of the size `em` (px) to a box of the width `wide` (px).
FittedCard sized_card(const RimCard& card, const Parts& parts, float em, float wide) {
    constexpr float any_height = 1e5F;  // more than the height of any text (px)
    FittedCard out;
    const float u = out.unit = em / step_size;
    out.ghost = parts.ghost && (card.stroke != nullptr || !card.curve.empty());
    out.whole = parts.potions && parts.brew;
    const float before = out.ghost ? (ghost_side + card_pad) * u : 0;
    const fvec2 room(wide - before - 2 * card_pad * u, any_height);
    out.step = fit(card.step, em, room);
    // Text about the brew is a little smaller, as long as it stays readable.
    fit_state(card, parts, std::floor(std::max(std::min(em, readable), brew_size * u)), room, out);
    float least = std::min(room.x, gauge_wide * u), feet = gauge_high * u;
    if (card.stroke != nullptr) {
        const float row = stroke_row_wide(*card.stroke, u) + min_gauge * u;
        out.gauge_in_row = room.x >= row;
        feet = stroke_row_high(u) + (out.gauge_in_row ? 0 : card_gap * u + feet);
        if (out.gauge_in_row) least = row;
    }
    const float words = height_of(out.step, u) + height_of(out.brew, u) + height_of(out.potions, u);
    const float widest =
        std::max({widest_line(out.step), widest_line(out.brew), widest_line(out.potions), least});
    out.size = {std::min(wide, widest + before + 2 * card_pad * u),
                std::max(words + feet, out.ghost ? ghost_side * u : 0) + 2 * card_pad * u};
    return out;
}

}  // namespace

RimCard rim_card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player) {
    const auto& p = picture.wizards[player];
    RimCard card;
    card.gauge = gauge_of(picture.cauldron, p.stations.recipe);
    const bool draws = p.stations.recipe.step == RecipeStep::stroke && p.stations.recipe.ghost_points > 1;
    if (draws && p.stations.stirs) card.stroke = &p.stations.recipe;
    if (!settings.captions[player]) return card;
    card.step = words_of_step(p, settings.controls[player]);
    card.brew = words_of_brew(picture.cauldron, p.stations.recipe, player);
    if (p.stations.refilled) card.brew += ", refills your wands";
    card.potions = words_of_potions(p);
    return card;
}

std::string words_of_potions(const PlayerPicture& p) {
    std::string words;
    const auto add = [&](const std::string& more) { words += text(words.empty() ? "" : "   ", more); };
    for (std::uint32_t i = 0; i < p.vitals.givers; ++i)
        add(text(capitalised(p.vitals.giver_names.at(i)), " ", whole_seconds(p.vitals.giver_left_s.at(i))));
    if (p.stations.work_half && p.stations.work.lens)
        add("both halves of the Great Work");
    else if (p.stations.work_half)
        add("half of the Great Work");
    else if (p.stations.work.lens)
        add("the Lens");
    if (p.vitals.poisoned_s > 0) add(text("poisoned ", whole_seconds(p.vitals.poisoned_s)));
    return words;
}

FittedCard fit_card(const RimCard& card, fvec2 room, float u) {
    struct Try {
        Parts parts;
        float least{};  ///< text size below which parts are left out (px)
    };
    constexpr std::array tries{Try{{}, readable}, Try{{.ghost = false}, readable},
                               Try{{.ghost = false, .potions = false}, 8},
                               Try{{.ghost = false, .potions = false, .brew = false}, 4}};
    if (room.x < 4 * card_pad * u) return {};
    for (const auto& one : tries) {
        for (float em = std::floor(step_size * u); em >= one.least; --em) {
            auto fitted = sized_card(card, one.parts, em, room.x);
            if (fitted.size.y <= room.y && fitted.step.size >= em) return fitted;
        }
    }
    return {};
}

bool fits_better(const FittedCard& one, const FittedCard& other) {
    if (one.size.y <= 0 || other.size.y <= 0) return one.size.y > 0;
    if (one.whole != other.whole) return one.whole;
    if (one.ghost != other.ghost) return one.ghost;
    return one.step.size >= other.step.size;
}

bool says_all(const FittedCard& fitted) {
    return fitted.size.y > 0 && fitted.whole && fitted.step.size >= readable;
}

bool holds_line(const Panel& box) {
    return box.high.x > box.low.x && box.high.y - box.low.y >= FittedWords::line_spacing * readable;
}

namespace {

/// Adds the two bars of a gauge. The bar of the time turns amber in its last quarter.
void add_gauge(Overlay& out, const BrewGauge& gauge, fvec2 corner, float wide, float u) {
    const auto bar = [&](float from, float high, float share, fvec4 paint) {
        const fvec2 low(corner.x, corner.y + from * u);
        out.items.emplace_back(RectItem{low, low + fvec2(wide, high * u), paints.track, high * u / 3});
        if (share > 0)
            out.items.emplace_back(RectItem{low, low + fvec2(share * wide, high * u), paint, high * u / 3});
    };
    bar(1, 5, gauge.mixed, gauge.paint);
    const auto mark = [&](float share) {
        const float x = corner.x + share * wide;
        out.items.emplace_back(
            LineItem{{x, corner.y}, {x, corner.y + 7 * u}, std::max(1.5F, 1.5F * u), paints.white});
    };
    if (gauge.goal > 0) mark(gauge.goal);
    if (gauge.window) {
        // A line above the bar, between two marks, shows when the recipe's next step may come.
        mark(gauge.window->x);
        mark(gauge.window->y);
        out.items.emplace_back(LineItem{{corner.x + gauge.window->x * wide, corner.y},
                                        {corner.x + gauge.window->y * wide, corner.y},
                                        std::max(2.0F, 2 * u),
                                        paints.amber});
    }
    if (gauge.fresh > 0) bar(7, 3, gauge.fresh, gauge.fresh < 0.25F ? paints.amber : paints.soft);
}

/// Plots a curve through heights at equal distances.
void add_curve(Overlay& out, std::span<const float> heights, const Panel& box, float u) {
    out.items.emplace_back(RectItem{box.low, box.high, paints.track, 3 * u});
    const fvec2 low = box.low + fvec2(3 * u), size = box.high - box.low - fvec2(6 * u);
    const auto at = [&](std::size_t i) {
        const float x = static_cast<float>(i) / static_cast<float>(heights.size() - 1);
        return low + size * fvec2(x, 1 - std::clamp(heights[i], 0.0F, 1.0F));
    };
    for (std::size_t i = 0; i + 1 < heights.size(); ++i)
        out.items.emplace_back(LineItem{at(i), at(i + 1), std::max(1.5F, 2 * u), paints.amber});
}

/// Adds lines of text downwards from a corner. Returns the height of all lines.
float add_lines(Overlay& out, const FittedWords& words, fvec2 corner, fvec4 paint, float u) {
    for (std::size_t i = 0; i < words.lines.size(); ++i)
        add_text(out, words.lines[i], corner + fvec2(0, static_cast<float>(i) * words.line_height()),
                 words.size, paint, render::Align::left);
    return height_of(words, u);
}

}  // namespace

void add_rim_card(Overlay& out, const RimCard& card, const FittedCard& fitted, fvec2 low, double seconds) {
    if (fitted.size.y <= 0) return;
    const float u = fitted.unit;
    out.items.emplace_back(RectItem{low, low + fitted.size, paints.plate, card_pad * u});
    fvec2 corner = low + fvec2(card_pad * u);
    if (fitted.ghost) {
        const float half = ghost_side * u / 2;
        if (card.stroke != nullptr)
            add_ghost(out, *card.stroke, corner + fvec2(half), half - 4 * u, seconds, u);
        else
            add_curve(out, card.curve, {corner, corner + fvec2(2 * half)}, u);
        corner.x += (ghost_side + card_pad) * u;
    }
    float wide = low.x + fitted.size.x - card_pad * u - corner.x;
    corner.y += add_lines(out, fitted.step, corner, paints.white, u);
    corner.y += add_lines(out, fitted.brew, corner, paints.white, u);
    corner.y += add_lines(out, fitted.potions, corner, paints.soft, u);
    if (card.stroke != nullptr) {
        const float high = stroke_row_high(u);
        const float row =
            fitted.gauge_in_row ? (wide + stroke_row_wide(*card.stroke, u) - min_gauge * u) / 2 : wide;
        add_stroke_row(out, *card.stroke, {corner, corner + fvec2(row, high)}, u);
        corner +=
            fitted.gauge_in_row ? fvec2(row, (high - gauge_high * u) / 2) : fvec2(0, high + card_gap * u);
        wide -= fitted.gauge_in_row ? row : 0;
    }
    add_gauge(out, card.gauge, corner, wide, u);
}

}  // namespace thaum::game::inline hud
