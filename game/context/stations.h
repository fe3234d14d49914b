// game/context/stations.h: wizards at work at a station.
#pragma once
#include "game/components/station.h"
#include "game/context/match_context.h"

namespace thaum::game {

/// Whether a wizard works at a station. Reads AtStation.
bool at_station(const ecs::World& world, ecs::Entity wizard);

/// Whether a wizard with the body's middle at this place is within `reach` of a station's middle on the ground (m), and
/// about as high.
bool is_near_station(const WizardRules& rules, vec3 body, vec3 middle, double reach);

/// The component of a wizard who begins to work at a place (m, world).
AtStation station_at(vec3 body, vec3 middle, StationKind kind, std::uint32_t number = 0);

/// Ends a wizard's work at a station. Must not be called inside a view.
void leave_station(ecs::World& world, ecs::Entity wizard);

/// Adds the system that turns the eyes of wizards to their stations, every tick.
void add_station_gaze_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game
