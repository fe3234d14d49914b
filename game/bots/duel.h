// game/bots/duel.h: a match of two bots. Tests, benchmarks and the off-screen duel use it as the standard
// scene.
#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "game/bots/bot.h"

namespace thaum::game::inline bots {

struct BotDuel {
    std::unique_ptr<Simulation> match;
    Bots bots;

    /// Input of both bots for the next tick, as samples of their devices.
    input::InputFrame next_frame();
    /// Plays `count` ticks.
    void run(Tick count);
};

/// Creates a duel. `names`: bots by name or level (bot_named). The error names a bot that
/// does not exist, or a fault in its file.
Expected<BotDuel> make_bot_duel(const std::filesystem::path& assets, std::shared_ptr<const MatchData> data,
                                std::array<std::string, players> names, std::uint64_t seed);

}  // namespace thaum::game::inline bots
