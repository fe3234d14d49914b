// game/match/power_ups.h: who walks over a power-up picks it up.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

void add_power_up_system(Stage& stage, ecs::Schedule& schedule);

/// What a power-up would give to a wizard now.
struct Gift {
    double health{};  ///< HP
    double energy{};  ///< into the wand of that slot
    std::uint32_t slot{};
    double amount() const { return health + energy; }
};
Gift gift_of(const MatchData& data, PowerUpKind kind, const Health& health, const WandBelt& belt);

/// Less than that is nothing: it stays where it is, HP or energy.
inline constexpr double least_gift = 1;

}  // namespace thaum::game
