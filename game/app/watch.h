// game/app/watch.h: looking at a replay.
#pragma once
#include <filesystem>

#include "game/match/playback.h"

namespace thaum::app {

/// Plays the rest of the log in a window, `speed` times as fast as it was; Esc leaves. Without a display: one picture of the moment and its state in
/// `out`, and a line that says so. Returns an exit code.
int watch(game::Playback playback, double speed, const std::filesystem::path& out);

}  // namespace thaum::app
