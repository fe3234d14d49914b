// game/app/feel.h: the forces of a log, felt by an arm in somebody's hand.
#pragma once
#include <string>

#include "game/match/playback.h"

namespace thaum::app {

struct FeelPlan {
    std::string device;        ///< as `thaum doctor` lists it, or "phantom"
    std::uint32_t player = 0;  ///< whose forces
};

/// Plays what that player's hand was told from where the playback is to its end, in real time and without its pauses, until a
/// key, Ctrl-C or a fault ends it. The cap is that of who sits here (settings), not that of the log. Returns an exit code.
int feel(game::Playback playback, const FeelPlan& plan);

}  // namespace thaum::app
