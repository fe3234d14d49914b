// game/components/fog.h: clouds that hide what is in them and behind them.
#pragma once
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

/// A ball of fog. The position of its middle is in Motion.
struct Fog {
    double radius{};         ///< radius of the cloud (m)
    double sight{};          ///< length of a line of sight through the cloud beyond which nothing is seen (m)
    Tick began{};            ///< tick of play in which the cloud appeared
    Tick until{};            ///< tick of play in which the cloud vanishes
    std::uint32_t player{};  ///< player who cast the fog spell
    std::uint32_t spare{};
    THAUM_COMPONENT(Fog, radius, sight, began, until, player, spare);
};

}  // namespace thaum::game::inline components
