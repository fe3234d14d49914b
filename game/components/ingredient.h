// game/components/ingredient.h: ingredient numbers, the order of ingredients in assets/cauldron.toml.
#pragma once
#include <cstdint>

namespace thaum::game::inline components {

inline constexpr std::uint32_t no_ingredient = 0xFFFF'FFFF;

}  // namespace thaum::game::inline components
