// game/match/power_ups.h: wizards pick up power-ups by walking over them.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

void add_power_up_system(MatchContext& context, ecs::Schedule& schedule);

/// Health or energy that a power-up would give to a wizard now.
struct Gift {
    double health{};  ///< health that the wizard would gain (HP)
    double energy{};  ///< energy that the wand in `slot` would gain
    std::uint32_t slot{};
    double amount() const { return health + energy; }
};
Gift gift_of(const MatchData& data, PowerUpKind kind, const Health& health, const WandBelt& belt);

/// Minimum gain (HP or energy). A power-up that would give less is not picked up.
inline constexpr double min_gift = 1;

}  // namespace thaum::game::inline match
