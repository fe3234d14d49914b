// game/stations/orb/scrying.h: wizards who scry (MANUAL.md, "The orb"): who begins and ends, what it costs, which modes they wear, and
// when the orb tells.
//
//     Stir held at the orb -> AtStation, Scrying; focus goes down, and none comes back
//     key of a wand        -> its mode is put on or off; next and previous wand change the last one
//     Trace held           -> the hand draws the curve of the mode that was put on last, and feels no mode
//     probe near the core  -> after the hold time the orb tells the wizard's own order, once in a life
#pragma once
#include "game/components/orb.h"
#include "game/context/match_context.h"

namespace thaum::game {

/// Whether a wizard with the body's middle at this place can scry.
bool within_reach_of_orb(const MatchData& data, const Orb& orb, vec3 body);

/// Adds the system that starts and ends scrying and chooses modes, every gameplay tick, before the haptics. Does nothing
/// without an orb.
void add_scrying_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the system that moves the probes, every tick, after the haptics. It knows when the orb tells. Does nothing
/// without an orb.
void add_orb_probe_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game
