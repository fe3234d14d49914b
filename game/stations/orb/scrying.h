// game/stations/orb/scrying.h: wizards who scry (MANUAL.md, "The orb"): when they begin and end, what it
// costs, the active haptic modes, and the orb's reward.
//
//     Stir held at the orb -> AtStation, Scrying; focus (which spells cost, too) decreases, none comes back
//     key of a wand        -> its mode is switched on or off; next and previous wand change the newest mode
//     Trace held           -> the hand draws the strength curve of the newest mode, and feels no mode
//     probe near the core  -> after the hold time the orb shows the orders of ingredients that were drawn for
//                             the player's recipes, once a life (core: the axis of the flow's first vortex)
#pragma once
#include "game/components/orb.h"
#include "game/context/match_context.h"

namespace thaum::game::inline stations {

/// Whether a wizard can scry (search the orb), given the position of the body's middle.
bool within_reach_of_orb(const MatchData& data, const Orb& orb, vec3 body);

/// Adds the system that starts and ends scrying and chooses modes, every gameplay tick. It runs before the
/// haptics. Does nothing without an orb.
void add_scrying_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the system that moves the probes (the tips that hands move in the orb) and gives the orb's reward,
/// every tick. It runs after the haptics. Does nothing without an orb.
void add_orb_probe_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
