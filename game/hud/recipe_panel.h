// game/hud/recipe_panel.h: helps a wizard at the cauldron through a recipe: the next step in words, the ghost of the next
// stroke, how often it was drawn, and the band of its force.
#pragma once
#include <string>

#include "game/hud/picture.h"
#include "game/hud/prompts.h"
#include "render/scene.h"

namespace thaum::game {

/// The next step in words: "Haste: stir until ember is mixed 20 %". Empty if there is nothing to say. Several choices have
/// three spaces between them.
std::string words_of_step(const PlayerPicture& player, const ControlNames& controls);

/// Height of the panel (units); 0: it is not shown.
float recipe_panel_high(const RecipePicture& recipe);

/// Adds ghost, dots and force band in the middle of a box, with the top at `top`. `seconds`: clock of the ghost's moving
/// dot; `u`: a unit (px).
void add_recipe_panel(render::Overlay& out, const RecipePicture& recipe, const Panel& box, float top,
                      double seconds, float u);

}  // namespace thaum::game
