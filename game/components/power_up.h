// game/components/power_up.h: power-ups that wizards pick up in the arena.
#pragma once
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

enum class PowerUpKind : std::uint32_t { vial, heart, spark };
inline constexpr std::array<std::string_view, 3> power_up_names{"vial", "heart", "spark"};

/// Power-up on the ground. A wizard who walks over it picks it up. Its position is in Motion.
struct PowerUp {
    Tick back_at{};  ///< when the power-up is available again (ticks of play)
    PowerUpKind kind{};
    std::uint32_t number{};  ///< index of the power-up in the arena file
    THAUM_COMPONENT(PowerUp, back_at, kind, number);
};

}  // namespace thaum::game::inline components
