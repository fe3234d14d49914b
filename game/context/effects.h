// game/context/effects.h: how effects (data/effect.h) begin and end: potions, spells, power-ups, the orb and
// crystals give their lists to a wizard here.
#pragma once
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline context {

/// How a wizard gets a list of effects.
struct EffectStart {
    Tick tick{};         ///< number of the present tick of play
    vec3 place{};        ///< where the wizard gets them (m, world); for events
    double strength{1};  ///< more than 1: by a harsh (forceful) stroke
};

/// Gives a wizard all effects of a list. The calling system must have declared effect_reads() and the list's
/// effect_writes().
void begin_effects(MatchContext& context, ecs::Entity wizard, const EffectList& list,
                   const EffectStart& start);

/// What the wizard would gain by the list now (HP, energy and focus together). Reads effect_reads() and the
/// list's effect_writes().
double gain_of(MatchContext& context, ecs::Entity wizard, const EffectList& list, const EffectStart& start);

/// Takes all effects from a wizard who dies. Reads effect_reads(), writes effect_writes() of all lists.
void lose_effects(MatchContext& context, ecs::Entity wizard, Tick tick);

/// Components that every effect may read.
ecs::Mask effect_reads(const ecs::World& world);
/// Components and resources that the effects of some lists write. `list`: a list, or MatchData::effects.
ecs::Mask effect_writes(const ecs::World& world, const EffectList& list);

/// Leaves a wizard only a share of the weight in this physics tick. Writes resource::Physics.
void leave_weight(MatchContext& context, ecs::Entity wizard, const Body& body, double share);

/// Adds the system that ends effects, lets them act and hurts by poison, every gameplay tick, and the systems
/// that effects have of their own.
void add_effect_systems(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline context
