// game/cauldron/ladle.h: who holds Stir at the cauldron's rim stirs: the hand's probe is the ladle, and the wizard stands still.
//
//     hand, device frame --(metres_per_metre, turned to the middle)--> ladle, world --> strokes in the brew
//     brew's drag on the ladle --(newtons_per_newton)--> hand
//
// The brew gets what the ladle does, whatever of it the hand is told: a gentle player stirs as hard.
#pragma once
#include "game/cauldron/cauldron.h"
#include "game/components/grip.h"
#include "game/match/surfaces.h"

namespace thaum::game {

/// Where a stirring hand's device frame lies in the world.
HandFrame ladle_frame(const CauldronRules& rules, const Cauldron& cauldron, const Ladle& ladle);

/// What the hand of who stirs feels of the brew at a tick of play: writes the model's part and, where the flow is read anew, the Ladle.
void feel_brew(Stage& stage, const Grip& grip, std::uint32_t player, Ladle& ladle, Tick tick,
               haptics::FluidTouch& touch);

/// Whether a wizard whose body's middle is there may stir.
bool within_reach(const MatchData& data, const Cauldron& cauldron, vec3 body);

/// Every gameplay tick, before hands are felt: who begins and who ends.
void add_stir_system(Stage& stage, ecs::Schedule& schedule);
/// Every tick, after hands were felt: where ladles are, what they do to the brew; the eyes turn to it.
void add_ladle_system(Stage& stage, ecs::Schedule& schedule);

}  // namespace thaum::game
