// game/components/free_hand.h: the last seconds of a hand that may cast without a button.
#pragma once
#include "game/components/casting.h"

namespace thaum::game {

/// Room for 3 s of gameplay ticks.
inline constexpr std::size_t free_points = 375;

/// The motion of a wizard who casts freely (game/casting/free_casting.h). Only wizards of players with that option have
/// one.
struct FreeHand {
    Tick newest{};   ///< tick of play of the newest point
    Tick cast_at{};  ///< tick of play of the last spell that was cast without a button; 0: none
    std::array<DrawnPoint, free_points> points{};  ///< ring
    std::uint32_t first{};                         ///< place of the oldest point in the ring
    std::uint32_t count{};
    vec3 path{};  ///< place of the hand of a mouse, the sum of its motion (m)
    static constexpr std::string_view name = "FreeHand";
    static constexpr auto fields() {
        using F = FreeHand;
        return std::tuple(field("newest", &F::newest), field("cast_at", &F::cast_at),
                          field("points", &F::points), field("first", &F::first), field("count", &F::count),
                          field("path", &F::path));
    }
};

}  // namespace thaum::game
