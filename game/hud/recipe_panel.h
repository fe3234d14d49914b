// game/hud/recipe_panel.h: parts of the card at the cauldron (rim_card.h): the next step of the recipe in
// words, the ghost (faint shape) of the next stroke, how often that stroke was drawn, and the allowed range
// of its force.
#pragma once
#include <string>

#include "game/data/control_names.h"
#include "game/hud/panel.h"
#include "game/picture/picture.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// The next step of the recipe in words: "Haste: stir until ember is mixed 20 %". Empty if there is none. If
/// there are several possible steps, three spaces separate them.
std::string words_of_step(const PlayerPicture& player, const ControlNames& controls);

/// Adds the ghost of the next stroke: its shape with a mark at its start, and a dot that runs along it.
/// `half`: half of the shape's size (px); `seconds`: time that moves the dot (s); `u`: length of a HUD unit
/// (px).
void add_ghost(render::Overlay& out, const RecipePicture& recipe, fvec2 centre, float half, double seconds,
               float u);

/// Height of the row about the next stroke, and its minimum width (px).
float stroke_row_high(float u);
float stroke_row_wide(const RecipePicture& recipe, float u);
/// Adds the row about the next stroke: a dot for each required stroke, the required force in words, and the
/// force scale with the current force.
void add_stroke_row(render::Overlay& out, const RecipePicture& recipe, const Panel& row, float u);

}  // namespace thaum::game::inline hud
