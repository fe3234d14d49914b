// game/match/bodies.h: keeps World and physics consistent: adds and removes bodies, runs Bullet, turns blows
// of loose things into harm to wizards, and copies the new motions back into the World.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Installs hooks: adding a Body to an entity with Motion adds that body to the physics; removing the Body
/// component removes the body there.
void add_body_hooks(MatchContext& context);

/// Adds the systems that run Bullet ("physics"), turn blows of things into harm ("blows") and copy the new
/// motions into the World ("places"), in this order.
void add_body_systems(MatchContext& context, ecs::Schedule& schedule);

/// Harm by a blow with an impulse of `impulse` N s (HP).
double harm_of_blow(const WizardRules& rules, double impulse);

/// Copies position and velocity of every moving body from the physics into Motion.
void copy_places(MatchContext& context);

/// Replaces the physics by a new one with exactly the bodies of the World. Their order depends only on the
/// World, so a restored match continues with the same bits.
void rebuild_physics(MatchContext& context);

}  // namespace thaum::game::inline match
