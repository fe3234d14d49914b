// game/app/feel.h: playing the recorded forces of a log on a real force-feedback arm.
#pragma once
#include <string>

#include "game/match/playback.h"

namespace thaum::game::inline app {

struct FeelPlan {
    std::string device;        ///< name or number of the arm in the list of `thaum doctor`
    std::uint32_t player = 0;  ///< player whose recorded forces are played
};

/// Plays the forces of plan.player's hand from the playback's tick to the log's end, in real time and without
/// pauses. A key, Ctrl-C or a fault ends it early. The force cap comes from this machine's settings, not from
/// the log. Returns an exit code.
int feel(Playback playback, const FeelPlan& plan);

}  // namespace thaum::game::inline app
