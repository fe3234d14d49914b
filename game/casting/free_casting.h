// game/casting/free_casting.h: casting without a button, for players who chose it (DeviceSpec::casts_freely).
//
//     each tick          -> counts of mouse and stick, which also turn the view, move the place of a hand
//     each gameplay tick -> that place, or that of an arm's hand, goes into the ring of FreeHand and to a spotter
//     spotter            -> candidates: the last seconds may have been a gesture
//     the hand rests     -> the best candidate that has just ended casts its spell, as a stroke does
//
// A hand that shoots, stirs, traces or moves by the clutch casts nothing this way. Nor does a hand that goes on after the
// gesture, as in aiming, or as in a star, of which a part is a V. Two spells are a while apart.
//
// The spotter and its candidates are no part of the state. At every keyframe they are made anew from the ring, in the
// match as well as in a replay, so both go on with the same bits.
#pragma once
#include <array>
#include <memory>

#include "game/components/free_hand.h"
#include "game/context/match_context.h"
#include "gesture/spotter.h"

namespace thaum::game {

class FreeCasting {
public:
    /// Makes the spotter of a player anew from all points that FreeHand keeps. Allocates only the first time.
    void rebuild(const MatchContext& context, std::uint32_t player, const FreeHand& hand);
    /// Gives the newest point of the hand to the spotter. Returns the gesture that has ended with a rest.
    std::optional<gesture::Candidate> feed(const CastingRules& rules, std::uint32_t player,
                                           const FreeHand& hand);

private:
    struct Watch {
        std::unique_ptr<gesture::Spotter> spotter;
        std::optional<gesture::Candidate> best;  ///< best candidate since the hand last rested
    };
    std::optional<gesture::Candidate> take(const CastingRules& rules, const FreeHand& hand,
                                           std::uint32_t number, Watch& watch) const;

    std::array<Watch, players> watches_;
};

/// Whether a player's device lets the player cast without a button.
bool casts_freely(const MatchContext& context, std::uint32_t player);

/// Rebuilds the spotters of all wizards with a FreeHand. For keyframes.
void rebuild_free_casting(const MatchContext& context, FreeCasting& free);

/// Adds the systems. Does nothing if no player casts freely.
void add_free_casting_systems(MatchContext& context, FreeCasting& free, ecs::Schedule& schedule);

}  // namespace thaum::game
