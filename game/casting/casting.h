// game/casting/casting.h: strokes that wizards draw in the match, and the spells that these cast.
//
//     Trace goes down -> the wizard has a DrawnStroke, a viscous force acts on the hand
//     while it is held -> a point of the stroke in every gameplay tick
//     Trace goes up    -> the stroke is read (casting/reading.h); its gesture's spell is cast
//
// A press of a wand's key while Trace is held is a key chord. It takes the stroke's place: the spell of that
// slot is cast, harsh if fire is held too. So everything can be cast by keys alone.
#pragma once
#include "game/components/casting.h"
#include "game/components/stroke_reading.h"
#include "game/context/match_context.h"
#include "game/data/reading.h"

namespace thaum::game::inline casting {

/// Lets a wizard begin a stroke. Does nothing if a stroke has begun already or the match has no gestures.
/// Reads HandState, writes DrawnStroke.
void begin_stroke(MatchContext& context, ecs::Entity wizard);

/// The wizard who casts, and the time (ticks of play).
struct Caster {
    ecs::Entity wizard;
    std::uint32_t player{};
    Tick tick{};
};

/// Stores the reading of a stroke, and casts the spell of its gesture. A wizard who stirs casts no spell.
void act_on(MatchContext& context, const Caster& caster, const Reading& reading, const GestureSet& gestures);

/// Components and resources that a system must declare as read or written if it calls act_on.
struct CastingAccess {
    ecs::Mask reads, writes;
};
CastingAccess access_of_casting(const MatchContext& context);

/// Adds the system that updates strokes and casts spells in every gameplay tick. Does nothing if the match
/// has no gestures.
void add_casting_systems(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline casting
