// game/app/offscreen_duel.h: a duel of two bots that nobody watches: picture, log and result in a folder.
#pragma once
#include <array>
#include <filesystem>

#include "game/match/data.h"

namespace thaum::app {

struct OffscreenDuel {
    std::filesystem::path assets{};
    std::filesystem::path out = "out";  ///< duel.png, duel.thaumlog, duel.txt; old ones are replaced
    std::filesystem::path log{};        ///< instead of out/duel.thaumlog; must not exist yet
    game::DataChoice data{};
    std::uint64_t seed = 1;
    std::array<int, game::players> levels{1, 1};
    double seconds = 60;  ///< or until the round is over
};

/// Plays faster than real time. Returns an exit code; without OpenGL there is no picture, and one line says why.
int play_offscreen_duel(const OffscreenDuel& duel);

}  // namespace thaum::app
