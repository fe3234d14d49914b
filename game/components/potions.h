// game/components/potions.h: what the potions of the cauldron do to the wizards who drank them. A match
// without a cauldron has none of these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/wizard.h"

namespace thaum::game::inline components {

inline constexpr std::uint32_t no_potion = 0xFFFF'FFFF;
inline constexpr std::size_t max_potions = 8;
inline constexpr std::size_t max_recipe_ingredients = 3;

/// Potions that act on a wizard. Health holds the state of the potions that harden or poison. WandBelt holds
/// that of the potion that poisons the next lob (a missile thrown in an arc).
struct Potions {
    /// Time at which each potion stops acting, by its number (ticks of play)
    std::array<Tick, max_potions> until{};
    /// 1: the wizard holds Azoth, one of two things that win a round if held together (the Great Work).
    std::uint32_t work_half{};
    std::uint32_t spare{};
    THAUM_COMPONENT(Potions, until, work_half, spare);
    bool operator==(const Potions&) const = default;
};

/// Order in which each player must add the ingredients of recipes whose order is random. It is drawn from the
/// seed once a match. order[player][i] is the place of the i-th ingredient in the recipe's list. A recipe
/// with fewer ingredients skips the places that its list lacks.
struct DrawnOrders {
    std::array<std::array<std::uint32_t, max_recipe_ingredients>, players> order{};
    THAUM_COMPONENT(DrawnOrders, order);
};

}  // namespace thaum::game::inline components
