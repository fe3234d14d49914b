// tests/unit/game_duel.h: a match of two bots for tests.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>

#include "game/bots/duel.h"
#include "game/match/record.h"

namespace thaum::game::test {

inline std::filesystem::path assets() { return std::filesystem::path(THAUM_SOURCE_DIR) / "assets"; }

inline std::shared_ptr<const MatchData> duel_data(std::vector<std::string> overrides = {}) {
    return std::make_shared<const MatchData>(
        load_match_data(assets(), {.overrides = std::move(overrides)}).value());
}

/// Setup of a match of two players whose input a script gives.
inline MatchSetup two_hands() {
    return {.seed = 1,
            .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                        {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}};
}

inline const LoadedWand& wand_of(const MatchData& data, std::string_view name) {
    return *std::find_if(data.wands.begin(), data.wands.end(),
                         [&](const LoadedWand& wand) { return wand.name == name; });
}

/// Number of events of one kind in a match.
inline std::size_t count_of(const Simulation& match, EventKind kind) {
    std::uint64_t from = 0;
    std::size_t count = 0;
    match.events().each_new(from, [&](const Event& event) { count += event.kind == kind ? 1 : 0; });
    return count;
}
inline Event last_of(const Simulation& match, EventKind kind) {
    std::uint64_t from = 0;
    Event last;
    match.events().each_new(from, [&](const Event& event) {
        if (event.kind == kind) last = event;
    });
    return last;
}

inline BotDuel make_duel(std::uint64_t seed) {
    return make_bot_duel(assets(), duel_data(), {"level_1", "level_1"}, seed).value();
}

}  // namespace thaum::game::test
