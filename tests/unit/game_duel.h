// tests/unit/game_duel.h: a match of two bots for tests.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>

#include "game/bots/duel.h"
#include "game/match/record.h"

namespace thaum::game::test {

inline std::filesystem::path assets() { return std::filesystem::path(THAUM_SOURCE_DIR) / "assets"; }

inline std::shared_ptr<const MatchData> duel_data(std::vector<std::string> overrides = {}) {
    DataChoice choice;
    choice.overrides = std::move(overrides);
    auto data = load_match_data(assets(), choice);
    EXPECT_TRUE(data.has_value()) << (data ? "" : data.error().message);
    return std::make_shared<const MatchData>(std::move(*data));
}

/// Setup of a match of two scripted hands.
inline MatchSetup two_hands() {
    return {.seed = 1,
            .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                        {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}};
}

inline const LoadedWand& wand_of(const MatchData& data, std::string_view name) {
    return *std::find_if(data.wands.begin(), data.wands.end(),
                         [&](const LoadedWand& wand) { return wand.kind->name == name; });
}

inline BotDuel make_duel(std::uint64_t seed) {
    auto duel = make_bot_duel(assets(), duel_data(), {1, 1}, seed);
    EXPECT_TRUE(duel.has_value()) << (duel ? "" : duel.error().message);
    return std::move(*duel);
}

}  // namespace thaum::game::test
