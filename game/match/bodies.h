// game/match/bodies.h: keeps World and physics in step: adds and removes bodies, runs Bullet, counts blows of
// loose things against wizards, and copies the new motions back into the World.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

/// Installs hooks: adding a Body (to an entity with Motion) puts it into the physics; removing the Body takes
/// it out.
void add_body_hooks(MatchContext& context);

/// Adds the systems "physics", "blows" and "places", in this order.
void add_body_systems(MatchContext& context, ecs::Schedule& schedule);

/// Harm (HP) by a blow of that impulse (N s).
double harm_of_blow(const WizardRules& rules, double impulse);

/// Copies position and velocity of every moving body from the physics into Motion.
void copy_places(MatchContext& context);

/// Replaces the physics by one that holds exactly the bodies of the World, in canonical order.
void rebuild_physics(MatchContext& context);

}  // namespace thaum::game
