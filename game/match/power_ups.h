// game/match/power_ups.h: wizards pick up power-ups by walking over them, and get their effects.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

void add_power_up_system(MatchContext& context, ecs::Schedule& schedule);

/// Minimum gain (HP, energy and focus together). A power-up that would give less is not picked up, unless one
/// of its effects acts for a time.
inline constexpr double min_gain = 1;

}  // namespace thaum::game::inline match
