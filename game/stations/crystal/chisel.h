// game/stations/crystal/chisel.h: carving, by a wizard who holds the Stir button at a crystal. The hand feels
// the crystal's surface, and while fire is held the chosen tool carves at the hand's position. The controls
// for walking sideways turn the crystal, so that every side can be reached.
//
//     begin and end (stir) -> turn (every tick) -> tool and dab (fire, every gameplay tick)
//                          -> feel of the hand (every tick) -> Chisel
//
// The box that stops bodies and shots does not turn. The tool is used (a dab) before the forces of the same
// tick are computed, so that a change is felt and seen at once.
#pragma once
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/context/surfaces.h"
#include "game/stations/crystal/crystal.h"

namespace thaum::game::inline stations {

/// Whether a wizard can work at the crystal, given the position of the body's middle.
bool within_reach_of_crystal(const MatchData& data, const Crystal& crystal, vec3 body);

/// Pose of the device frame of a hand that carves (world).
HandFrame chisel_frame(const CrystalRules& rules, const AtStation& station);

/// Sets the haptic primitives (simple forces) of the crystal in a wizard's haptic model, for one tick. The
/// wizard must have a Chisel. Reads Chisel, AtStation, Crystal and CrystalDensity.
void feel_crystal(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
                  haptics::HapticModel& model);

/// Adds the systems that run before the haptics. In every tick they turn crystals; in every gameplay tick
/// they begin and end work, choose tools and carve.
void add_carving_systems(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule);
/// Adds the system that moves the wizards' tools to their hands, every tick. It runs after the haptics.
void add_chisel_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
