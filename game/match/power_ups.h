// game/match/power_ups.h: wizards pick up power-ups by walking over them.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

void add_power_up_system(MatchContext& context, ecs::Schedule& schedule);

/// Health or energy that a power-up would give to a wizard now.
struct Gift {
    double health{};  ///< health to add (HP)
    double energy{};  ///< energy to add to `slot`
    std::uint32_t slot{};
    double amount() const { return health + energy; }
};
Gift gift_of(const MatchData& data, PowerUpKind kind, const Health& health, const WandBelt& belt);

/// Smallest gift (HP or energy). A power-up that would give less stays where it is.
inline constexpr double least_gift = 1;

}  // namespace thaum::game
