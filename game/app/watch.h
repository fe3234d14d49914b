// game/app/watch.h: a replay shown in a window.
#pragma once
#include <filesystem>

#include "game/match/playback.h"

namespace thaum::game::inline app {

struct WatchPlan {
    Tick start = 0;               ///< first tick that is shown
    double speed = 1;             ///< initial speed of the replay relative to real time
    std::filesystem::path out{};  ///< folder for the picture that is saved if there is no display
};

/// Shows the replay in a window with a time bar, until the viewer closes it. Without a display, saves one
/// picture of the moment and its state in the folder, and prints a line about them. Returns an exit code.
int watch(Playback playback, const WatchPlan& plan);

}  // namespace thaum::game::inline app
