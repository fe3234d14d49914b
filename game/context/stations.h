// game/context/stations.h: wizards at work at a station: the cauldron, the orb or a crystal.
#pragma once
#include "game/components/station.h"
#include "game/context/match_context.h"

namespace thaum::game::inline context {

/// Whether a wizard works at a station (cauldron, orb or crystal). Reads AtStation.
bool at_station(const ecs::World& world, ecs::Entity wizard);

/// Whether a wizard is within `reach` of a station's middle (m, along the ground) and at about the same
/// height. `body`: middle of the wizard's body.
bool is_near_station(const WizardRules& rules, vec3 body, vec3 middle, double reach);

/// The component AtStation of a wizard who begins to work, with body and station at these places (m, world).
AtStation station_at(vec3 body, vec3 middle, StationKind kind, std::uint32_t number = 0);

/// Ends a wizard's work at a station (cauldron, orb or crystal). Must not be called while iterating over a
/// view of the World, because it removes a component.
void leave_station(ecs::World& world, ecs::Entity wizard);

/// Adds the system that, in every tick, turns the view of wizards who work at a station towards that station.
void add_station_gaze_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline context
