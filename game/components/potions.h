// game/components/potions.h: what wizards hold and know of the potions of the cauldron. A match without a
// cauldron has none of these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/wizard.h"

namespace thaum::game::inline components {

inline constexpr std::uint32_t no_potion = 0xFFFF'FFFF;
inline constexpr std::size_t max_potions = 8;
inline constexpr std::size_t max_recipe_ingredients = 3;

/// One of the two things that win a round if held together (the Great Work); the other one is the Lens.
struct WorkHalf {
    std::uint32_t held{};  ///< 1: the wizard holds it, until death
    std::uint32_t spare{};
    THAUM_COMPONENT(WorkHalf, held, spare);
};

/// Order in which each player must add the ingredients of recipes whose order is random. It is drawn from the
/// seed once a match. order[player][i] is the place of the i-th ingredient in the recipe's list. A recipe
/// with fewer ingredients skips the places that its list lacks.
struct DrawnOrders {
    std::array<std::array<std::uint32_t, max_recipe_ingredients>, players> order{};
    THAUM_COMPONENT(DrawnOrders, order);
};

}  // namespace thaum::game::inline components
