// game/app/watch.h: looking at a replay.
#pragma once
#include <filesystem>

#include "game/match/playback.h"

namespace thaum::app {

struct WatchPlan {
    Tick start = 0;               ///< first tick that is shown
    double speed = 1;             ///< ratio of the replay's pace to real time
    std::filesystem::path out{};  ///< folder for the picture, without a display
};

/// Plays the rest of the log in a window; Esc leaves. Without a display it leaves one picture of the moment and its
/// state in the folder, and says so in a line. Returns an exit code.
int watch(game::Playback playback, const WatchPlan& plan);

}  // namespace thaum::app
