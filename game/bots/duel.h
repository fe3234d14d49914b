// game/bots/duel.h: the standard scene: a match of two bots. Tests, benchmarks and the off-screen duel use this one.
#pragma once
#include <array>
#include <filesystem>

#include "game/bots/bot.h"

namespace thaum::game {

struct BotDuel {
    std::unique_ptr<Simulation> match;
    Bots bots;

    /// What both bots do in the next tick.
    input::InputFrame next_frame();
    /// Plays that many ticks.
    void run(Tick count);
};

/// The error is one line: a level that does not exist, or its file.
Expected<BotDuel> make_bot_duel(const std::filesystem::path& assets, std::shared_ptr<const MatchData> data,
                                std::array<int, players> levels, std::uint64_t seed);

}  // namespace thaum::game
