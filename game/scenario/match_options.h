// game/scenario/match_options.h: settings of a match that a script asks for.
#pragma once
#include "game/data/match_data.h"

namespace thaum::game::inline scenario {

struct MatchOptions {
    DataChoice data;
    std::uint64_t seed = 1;
    /// Bot that plays each wizard, by name or level; empty: the script plays it.
    std::array<std::string, players> bot{};
    using Percents = std::array<std::optional<std::uint32_t>, players>;
    /// Largest force for each player, as a share of the device's (%); null: set by the rules.
    Percents force{};
    Percents weight{};  ///< share of a carried thing's weight that the player feels (%); null: 100 %
    Percents blows{};   ///< share of the blows on a carried thing that the player feels (%); null: 100 %
    /// Shares of a stirred brew's forces, in the order of haptics::fluid_modes (%); null: 100 %.
    std::array<std::array<std::optional<std::uint32_t>, input::fluid_faders>, players> modes{};
    std::array<bool, players> casts_freely{};   ///< true if the player casts without a button
    std::array<bool, players> arm{};            ///< true if the player holds a simulated arm of a real device
    std::vector<input::ProfileData> profile{};  ///< recorded gestures of the players
};

}  // namespace thaum::game::inline scenario
