// game/context/strikes.h: hits on crystals by shots, bursts and loose things. A hit is noted when it happens. The crystal
// is chipped later in the same tick (game/stations/crystal/chips.h), so that wands need not know of voxels.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

/// Notes that a player's shot has struck a body, if it is a crystal. `place` is on the body's surface. The shot flew in the
/// direction `way` (world). Reads Crystal.
void strike(MatchContext& context, physics::Key struck, vec3 place, vec3 way, std::uint32_t player);

/// Notes the crystals that a burst reaches. `size` is the radius of the missile (m). Reads Crystal.
void strike_by_burst(MatchContext& context, vec3 place, double size, std::uint32_t player);

/// Notes a blow by a loose thing on a crystal, unless it was too weak or the crystal was chipped a moment ago. Reads
/// Crystal.
void strike_by_thing(MatchContext& context, ecs::Entity crystal, const physics::Contact& contact,
                     std::uint32_t player, Tick tick);

}  // namespace thaum::game
