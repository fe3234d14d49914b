// game/data/registration.h: functions that a kind of wand or spell registers (data/wand.h, data/spell.h).
#pragma once
#include <memory>

#include "core/config.h"
#include "ecs/world.h"

namespace thaum::game::inline data {

/// Declares to the World the components that a kind of wand or spell needs, in this order.
template <class... Components>
void declare_all(ecs::World& world) {
    (world.declare<Components>(), ...);
}

/// Makes the rules of a kind of wand or spell from the root table of its data file.
template <class Rules, class OfKind>
std::shared_ptr<const Rules> read_rules(const ConfigTable& root) {
    return std::make_shared<OfKind>(root);
}

}  // namespace thaum::game::inline data
