// game/stations/cauldron/brewing.h: rules of the brew in the match (MANUAL.md, "The cauldron").
// They decide who owns the brew, how it acts on wizards near it, and when it spoils. They also place the
// ingredients and track who carries one.
#pragma once
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline stations {

/// Creates the niches, in which ingredients lie ready, at the places that the arena names.
void spawn_niches(MatchContext& context);

/// Share of the full walking speed that a wizard has at a position; below 1 near a thick brew.
double pace_at(const MatchData& data, const ecs::World& world, vec3 place);

/// Adds the brewing systems. In every gameplay tick they handle pick-up and drop of ingredients, ownership,
/// and energy for stirring with the flow. They also handle the boon (healing by a well-mixed brew) and
/// boiling over. In every tick they reduce the weight of wizards near a light brew.
void add_brewing_systems(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule);

/// Adds the system that returns a carried ingredient to a niche (a place where ingredients lie ready). It
/// does so when the wizard presses Throw and no wand holds a thing. It must run before the wands: they let go
/// of their thing in the tick of the press, and after that no wand would seem to hold one.
void add_put_away_system(MatchContext& context, ecs::Schedule& schedule);

/// Whether the brew is light enough to lift wizards near it.
bool is_light(const AuraRules& aura, const Cauldron& cauldron);
/// Whether the brew is thick enough to slow wizards near it.
bool is_thick(const AuraRules& aura, const Cauldron& cauldron);

/// Whether stirring with this ladle refills the wands of its wizard now, because the ladle moves with the
/// flow.
bool is_refilling(const AuraRules& aura, const ecs::World& world, const BrewWork* work, const Ladle& ladle,
                  Tick tick);

/// Work of a ladle on the brew in the last 1.5 s (J).
double recent_work(const Ladle& ladle);

}  // namespace thaum::game::inline stations
