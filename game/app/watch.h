// game/app/watch.h: a replay shown in a window.
#pragma once
#include <filesystem>

#include "game/match/playback.h"

namespace thaum::app {

struct WatchPlan {
    Tick start = 0;               ///< first tick that is shown
    double speed = 1;             ///< ratio of the replay's pace to real time, at first
    std::filesystem::path out{};  ///< folder for the picture if there is no display
};

/// Shows the log in a window with a bar of its time, until the viewer leaves. Without a display, saves one picture of
/// the moment and its state in the folder, and prints a line about them. Returns an exit code.
int watch(game::Playback playback, const WatchPlan& plan);

}  // namespace thaum::app
