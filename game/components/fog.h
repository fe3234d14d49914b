// game/components/fog.h: clouds that hide what is in them and behind them.
#pragma once
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

/// A ball of fog. The position of its middle is in Motion.
struct Fog {
    double radius{};         ///< radius of the cloud (m)
    double sight{};          ///< length of a way through the cloud from which on nothing is seen (m)
    Tick began{};            ///< tick of play in which the cloud appeared
    Tick until{};            ///< tick of play in which the cloud vanishes
    std::uint32_t player{};  ///< player who cast it
    std::uint32_t spare{};
    static constexpr std::string_view name = "Fog";
    static constexpr auto fields() {
        return std::tuple(field("radius", &Fog::radius), field("sight", &Fog::sight),
                          field("began", &Fog::began), field("until", &Fog::until),
                          field("player", &Fog::player), field("spare", &Fog::spare));
    }
};

}  // namespace thaum::game
