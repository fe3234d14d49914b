// game/components/potions.h: what the potions of the cauldron do to the wizards who drank them. A match without a
// cauldron has none of these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/wizard.h"

namespace thaum::game {

inline constexpr std::uint32_t no_potion = 0xFFFF'FFFF;
inline constexpr std::size_t most_potions = 8;
inline constexpr std::size_t most_recipe_ingredients = 3;

/// Potions that act on a wizard. Harm and poison are in Health, a laced lob is in WandBelt.
struct Potions {
    std::array<Tick, most_potions> until{};  ///< tick of play before which each potion acts, by its number
    /// 1: the wizard holds Azoth, which is half of the Great Work.
    std::uint32_t work_half{};
    std::uint32_t spare{};
    THAUM_COMPONENT(Potions, until, work_half, spare);
    bool operator==(const Potions&) const = default;
};

/// Order in which each player must drop the ingredients of a recipe with a drawn order. Drawn from the seed once a
/// match. order[player][i] is the place in the recipe's list of the ingredient that comes i-th. A recipe with fewer
/// ingredients leaves out the places that it lacks.
struct DrawnOrders {
    std::array<std::array<std::uint32_t, most_recipe_ingredients>, players> order{};
    THAUM_COMPONENT(DrawnOrders, order);
};

}  // namespace thaum::game
