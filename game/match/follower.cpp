#include "game/match/follower.h"

namespace thaum::game::inline match {

bool MatchFollower::goes_on(const Simulation& match) const {
    // Longest interval between two looks at the match; a longer one counts as a jump of its clock (ticks)
    constexpr Tick longest_gap = 64;
    return begun_ && match.now() >= tick_ && match.now() - tick_ <= longest_gap &&
           match.events().count() >= events_seen_;
}

void MatchFollower::look(const Simulation& match) {
    begun_ = true;
    tick_ = match.now();
}

}  // namespace thaum::game::inline match
