// game/hud/recipe_panel.h: parts of the card at the cauldron (rim_card.h): the next step in words, the ghost of that
// stroke, how often it was drawn, and the band of its force.
#pragma once
#include <string>

#include "game/data/control_names.h"
#include "game/hud/panel.h"
#include "game/picture/picture.h"
#include "render/scene.h"

namespace thaum::game {

/// The next step in words: "Haste: stir until ember is mixed 20 %". Empty if there is nothing to say. Several choices have
/// three spaces between them.
std::string words_of_step(const PlayerPicture& player, const ControlNames& controls);

/// Adds the shape of the next stroke with its start, and a dot that runs along it. `half`: half of its size (px);
/// `seconds`: clock of the dot; `u`: a unit (px).
void add_ghost(render::Overlay& out, const RecipePicture& recipe, fvec2 centre, float half, double seconds,
               float u);

/// Height of the row of a stroke, and its least width (px).
float stroke_row_high(float u);
float stroke_row_wide(const RecipePicture& recipe, float u);
/// Adds a row: a dot for each stroke that is wanted, the wanted force in words, and its band with the present force.
void add_stroke_row(render::Overlay& out, const RecipePicture& recipe, const Panel& row, float u);

}  // namespace thaum::game
