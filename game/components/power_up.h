// game/components/power_up.h: what lies in the court to be picked up.
#pragma once
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

enum class PowerUpKind : std::uint32_t { vial, heart, spark };
inline constexpr std::array<std::string_view, 3> power_up_names{"vial", "heart", "spark"};

/// Its place is in Motion: on the ground, where it is picked up by who walks over it.
struct PowerUp {
    Tick back_at{};  ///< there from that tick of play on
    PowerUpKind kind{};
    std::uint32_t number{};  ///< as it stands in the arena's file
    static constexpr std::string_view name = "PowerUp";
    static constexpr auto fields() {
        return std::tuple(field("back_at", &PowerUp::back_at), field("kind", &PowerUp::kind),
                          field("number", &PowerUp::number));
    }
};

}  // namespace thaum::game
