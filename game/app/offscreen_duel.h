// game/app/offscreen_duel.h: a duel of two bots without a window: picture, log and result in a folder.
#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "game/data/match_data.h"

namespace thaum::game::inline app {

struct OffscreenDuel {
    std::filesystem::path assets{};
    /// Folder for duel.png, duel.thaumlog and duel.txt. Existing files are replaced.
    std::filesystem::path out = "out";
    std::filesystem::path log{};  ///< path of the log, if not in `out`; the file must not exist yet
    DataChoice data{};
    std::uint64_t seed = 1;
    std::array<std::string, players> bots{"1", "1"};  ///< bots by name or level (bots/bot_file.h)
    /// longest simulated time (s). The duel ends earlier when the match is over. The log then holds half a
    /// second more (log_after_end), so that a replay shows how the match ends.
    double seconds = 60;
};

/// Plays the duel faster than real time and writes its files. Returns an exit code. Without OpenGL there is
/// no picture, and a printed line says why.
int play_offscreen_duel(const OffscreenDuel& duel);

}  // namespace thaum::game::inline app
