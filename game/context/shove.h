// game/context/shove.h: pushes of wizards and loose things by what players do.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

/// Gives a body an impulse (N s, world) at a point of it (m, world). What a loose thing then hits counts for the player.
/// A wizard loses the grip of the feet for a moment, or else the ground would stop a push within 0.2 m. Writes Stance,
/// Prop and resource::Physics, reads Wizard.
void shove(MatchContext& context, ecs::Entity body, vec3 impulse, vec3 point, std::uint32_t player,
           Tick tick);

}  // namespace thaum::game
