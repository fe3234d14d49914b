// game/context/strikes.h: hits on crystals by shots, bursts and loose things. A hit is recorded when it
// happens. The crystal loses voxels later in the same tick (game/stations/crystal/chips.h), so that the code
// of wands does not depend on voxels.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline context {

/// Records that a player's shot has struck a body, if that body is a crystal. `place` is on the body's
/// surface. The shot flew in the direction `way` (world). Reads Crystal.
void strike(MatchContext& context, physics::Key struck, vec3 place, vec3 way, std::uint32_t player);

/// Records hits on all crystals that a burst (a missile's explosion) reaches. `size` is the radius of the
/// missile (m). Reads Crystal.
void strike_by_burst(MatchContext& context, vec3 place, double size, std::uint32_t player);

/// Records the blow of a loose thing on a crystal, unless the blow was too weak or another one chipped the
/// crystal just before. Reads Crystal.
void strike_by_thing(MatchContext& context, ecs::Entity crystal, const physics::Contact& contact,
                     std::uint32_t player, Tick tick);

}  // namespace thaum::game::inline context
