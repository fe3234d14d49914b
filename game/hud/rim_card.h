// game/hud/rim_card.h: the card of a wizard at the cauldron, the orb or a crystal (station_card.h). At the cauldron it
// helps through a recipe, all of it readable at once:
//
//     +-------+  Haste: hold [Right mouse] and draw: circle      the next step
//     | ghost |  Ember and salt, mixed 57 %, boils over in 9 s   the brew
//     |       |  Haste 12 s                                      potions that act on the wizard
//     +-------+  o o .  gently  [==|====      ]                  strokes done, and the band of their force
//                [=====|=====|     ]                             mixing with the moment for the next step; time left
#pragma once
#include <span>
#include <string>

#include "game/hud/layout.h"
#include "game/picture/picture.h"
#include "render/scene.h"

namespace thaum::game {

/// Bars at the card's foot: how well the brew is mixed, and the time until it boils over (shares).
struct BrewGauge {
    float mixed{}, fresh{};
    float goal{};  ///< share from which the brew is well mixed
    /// Shares between which the next step of a recipe may come; std::nullopt: no recipe waits for its moment.
    std::optional<fvec2> window{};
    fvec4 paint{};  ///< colour of the owner
};

/// What the card says. Empty words are left out.
struct RimCard {
    std::string step, brew, potions;
    BrewGauge gauge;
    const RecipePicture* stroke = nullptr;  ///< recipe of which a stroke comes next; null: none
    /// Plot in place of the ghost: heights as shares at even distances; empty: none.
    std::span<const float> curve{};
};

/// The parts of a card, fitted to a box.
struct FittedCard {
    FittedWords step, brew, potions;
    float unit{};         ///< length of a unit of the card (px)
    bool ghost{};         ///< the ghost, or the curve, has room
    bool gauge_in_row{};  ///< the gauge stands beside the force, not below it
    bool whole = true;    ///< no words are left out
    fvec2 size{};         ///< (px); zero: the box is too small for any card
};

/// Whether a player is at the cauldron, so that a card is shown.
inline bool at_cauldron(const PlayerPicture& p) { return p.stations.stirs || p.stations.at_rim; }

RimCard rim_card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player);

/// The potions that act on a wizard, with the time that is left: "Haste 12 s".
std::string words_of_potions(const PlayerPicture& p);

/// Fits a card to a room (px). `u`: length of a unit (px).
FittedCard fit_card(const RimCard& card, fvec2 room, float u);

/// Whether the first of two fitted cards is the more readable one.
bool fits_better(const FittedCard& one, const FittedCard& other);

/// Whether a fitted card leaves nothing out, in words of a readable size.
bool says_all(const FittedCard& fitted);

/// Whether a box holds a readable line.
bool holds_line(const Panel& box);

/// Adds a card with its top left at `low`. `seconds`: clock of what moves in it.
void add_rim_card(render::Overlay& out, const RimCard& card, const FittedCard& fitted, fvec2 low,
                  double seconds);

}  // namespace thaum::game
