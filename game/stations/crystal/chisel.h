// game/stations/crystal/chisel.h: a wizard who holds Stir at a crystal. The hand feels the crystal's surface, and with fire the
// chosen tool carves where the hand is. The keys that walk sideways turn the crystal, so that every side can be reached.
//
//     begin and end (stir) -> turn (every tick) -> tool and dab (fire, every gameplay tick)
//                          -> feel of the hand (every tick) -> Chisel
//
// The solid that stops bodies and shots does not turn.
// A dab comes before the feel of the same tick, so that hand and picture show what was carved at once.
#pragma once
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/context/surfaces.h"
#include "game/stations/crystal/crystal.h"

namespace thaum::game {

/// Whether a wizard with the body's middle at this place can work at the crystal.
bool within_reach_of_crystal(const MatchData& data, const Crystal& crystal, vec3 body);

/// Pose of a carving hand's device frame (world).
HandFrame chisel_frame(const CrystalRules& rules, const AtStation& station);

/// Sets the primitives of a wizard's haptic model for one tick: those of the crystal. The wizard must have a Chisel.
/// Reads Chisel, AtStation, Crystal and CrystalDensity.
void feel_crystal(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
                  haptics::HapticModel& model);

/// Adds the systems that turn crystals, every tick, and that begin and end the work at crystals, choose tools and carve,
/// every gameplay tick, before the haptics.
void add_carving_systems(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule);
/// Adds the system that moves the tools, every tick, after the haptics.
void add_chisel_system(MatchContext& context, ecs::Schedule& schedule);

/// Takes the Lens from a wizard who dies. Writes Lens, EventLog and resource::Journal, reads Wizard and Motion.
void lose_lens(MatchContext& context, ecs::Entity wizard, Tick tick);

}  // namespace thaum::game
