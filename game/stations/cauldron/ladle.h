// game/stations/cauldron/ladle.h: the ladle of a player who holds Stir at the cauldron's rim. The player's
// hand moves the ladle by the haptic probe, the point at which it feels forces; the wizard stands still.
//
//     hand, device frame --(metres_per_metre, turned to the middle)--> ladle, world --> strokes in the brew
//     brew's drag on the ladle --(newtons_per_newton)--> hand
//
// The brew always gets the full push of the ladle. A force setting below 100 % weakens only the force on the
// hand.
#pragma once
#include "game/components/hand_state.h"
#include "game/context/stations.h"
#include "game/context/surfaces.h"
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline stations {

/// Pose of the device frame of a hand that stirs (world). `yaw`: direction in which the wizard faces the
/// station (rad).
HandFrame ladle_frame(const CauldronRules& rules, const Cauldron& cauldron, double yaw);

/// Prepares the fluid model of the stirring hand for one tick of play. Samples the flow around the ladle
/// again when needed, and records that in Ladle.
void feel_brew(const MatchContext& context, const BrewWork& work, ecs::Entity wizard, Ladle& ladle, Tick tick,
               haptics::FluidTouch& fluid);

/// Whether a wizard can stir, given the position of the body's middle.
bool within_reach(const MatchData& data, const Cauldron& cauldron, vec3 body);

/// Adds the system that starts and ends stirring, every gameplay tick. It runs before the haptics.
void add_stir_system(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule);
/// Adds the system that moves the ladles and pushes the brew, every tick. It runs after the haptics.
void add_ladle_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
