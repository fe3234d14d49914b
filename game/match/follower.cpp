#include "game/match/follower.h"

namespace thaum::game {

bool MatchFollower::goes_on(const Simulation& match) const {
    constexpr Tick longest_gap = 64;  // a longer one is a jump (ticks)
    return begun_ && match.now() >= tick_ && match.now() - tick_ <= longest_gap &&
           match.events().count() >= events_seen_;
}

void MatchFollower::look(const Simulation& match) {
    begun_ = true;
    tick_ = match.now();
}

}  // namespace thaum::game
