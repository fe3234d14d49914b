// game/context/shove.h: pushes that players' actions give to wizards and loose things.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline context {

/// Gives a body an impulse (N s, world) at one of its points (m, world). Later hits by a loose thing are
/// credited to `player`. The feet of a pushed wizard slip for a moment, because otherwise friction would stop
/// the wizard within 0.2 m. Writes Stance, Prop and resource::Physics, reads Wizard.
void shove(MatchContext& context, ecs::Entity body, vec3 impulse, vec3 point, std::uint32_t player,
           Tick tick);

}  // namespace thaum::game::inline context
