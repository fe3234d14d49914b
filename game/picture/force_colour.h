// game/picture/force_colour.h: the colour of a force in pictures.
#pragma once
#include "core/maths.h"

namespace thaum::game::inline picture {

/// Colour of a force by its share of the strongest force: green, yellow, red.
fvec3 force_colour(double share);

}  // namespace thaum::game::inline picture
