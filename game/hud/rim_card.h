// game/hud/rim_card.h: the card of a wizard at the cauldron, the orb or a crystal (station_card.h). At the
// cauldron the card guides the player through a recipe:
//
//     +-------+  Haste: hold [Right mouse] and draw: circle       the next step
//     | ghost |  Ember and salt, mixed 57 %, boils over in 9 s   the brew
//     |       |  Haste 12 s                                      potions that act on the wizard
//     +-------+  o o .  gently  [==|====      ]                  strokes done, and the band of their force
//                [=====|=====|     ]                             mixing, moment for the next step; time left
#pragma once
#include <span>
#include <string>

#include "game/hud/layout.h"
#include "game/picture/picture.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Bars at the bottom of a card (a panel at a station). `mixed`: how well the brew is mixed, 0 to 1. `fresh`:
/// share of the time until the brew boils over that is left, 0 to 1.
struct BrewGauge {
    float mixed{}, fresh{};
    float goal{};  ///< value of `mixed` from which on the brew counts as well mixed
    /// Range of `mixed` in which the next step of a recipe may come; std::nullopt: no such step is due, or it
    /// may come at any value.
    std::optional<fvec2> window{};
    fvec4 paint{};  ///< colour of the brew's owner
};

/// The contents of a card, the panel about the work at cauldron, orb or crystal. Empty texts are not shown.
struct RimCard {
    std::string step, brew, potions;
    BrewGauge gauge;
    const RecipePicture* stroke = nullptr;  ///< recipe whose next step is a stroke; null: none
    /// Curve to plot instead of the ghost (faint shape) of a stroke: heights at equal distances, as shares of
    /// the full height; empty: no curve.
    std::span<const float> curve{};
};

/// A card whose parts are fitted to a box.
struct FittedCard {
    FittedWords step, brew, potions;
    float unit{};  ///< length of a unit on the card (px)
    bool ghost{};  ///< true: there is room for the ghost (faint shape) of the next stroke, or for the curve
    bool gauge_in_row{};  ///< true: the gauge is beside the force scale, not below that
    bool whole = true;    ///< true: no text of the card is left out
    fvec2 size{};         ///< size of the card (px); zero: the box is too small for any card
};

/// Whether a player is at the cauldron, so that the card, which has the next step of the recipe, is shown.
inline bool at_cauldron(const PlayerPicture& p) { return p.stations.stirs || p.stations.at_rim; }

RimCard rim_card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player);

/// The potions that act on a wizard, with the remaining time: "Haste 12 s".
std::string words_of_potions(const PlayerPicture& p);

/// Fits a card to a box of the size `room` (px). `u`: length of a HUD unit (px).
FittedCard fit_card(const RimCard& card, fvec2 room, float u);

/// Whether a card is more readable than another, both fitted.
bool fits_better(const FittedCard& one, const FittedCard& other);

/// Whether a fitted card shows everything, in text of a readable size.
bool says_all(const FittedCard& fitted);

/// Whether a box has room for one readable line.
bool holds_line(const Panel& box);

/// Adds a card with its top left corner at `low` (px). `seconds`: time that moves the dot along the shape of
/// the next stroke (s).
void add_rim_card(render::Overlay& out, const RimCard& card, const FittedCard& fitted, fvec2 low,
                  double seconds);

}  // namespace thaum::game::inline hud
