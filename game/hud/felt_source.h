// game/hud/felt_source.h: what the hand feels, in a word: the strongest of the forces that act on it now.
#pragma once
#include <string_view>

#include "game/components/hand_state.h"

namespace thaum::game {

/// A source of force on the hand.
struct FeltSource {
    std::string_view
        name;  ///< for people: "Recoil", "Spring", "Weight", "Wall", "Current", "Surface"; empty: none
    double newtons{};  ///< its force before the limits of safety (N)
};

/// Returns the strongest source. `steady_name` names the steady force of the wand in hand, such as "Weight".
FeltSource strongest_source(const HandState& hand_state, std::string_view steady_name);

}  // namespace thaum::game
