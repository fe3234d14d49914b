// game/scenario/detail/part.h: reads components of the players' wizards.
#pragma once
#include "ecs/world.h"
#include "game/scenario/play.h"

namespace thaum::game::inline scenario {

template <class C>
const C& part(const Play& play, std::uint32_t player) {
    return world_of(play).get<C>(wizard_entity(play, player));
}

}  // namespace thaum::game::inline scenario
