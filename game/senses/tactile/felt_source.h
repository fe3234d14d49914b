// game/senses/tactile/felt_source.h: what the hand feels: the forces that act on it now, and the strongest of them in a word.
#pragma once
#include <array>
#include <string_view>

#include "ecs/world.h"
#include "game/components/hand_state.h"

namespace thaum::game {

/// Sources of force on the hand.
enum class ForceSource : std::uint8_t { recoil, spring, steady, wall, current, bowl, surface, flow, crystal };
inline constexpr std::size_t force_sources = 9;

/// Force of each source on the hand, before the limits of safety (N, device frame; the brew's: ladle frame).
using HandForces = std::array<vec3, force_sources>;
HandForces forces_on(const HandState& hand_state);
/// With the forces of the orb's flow or of a crystal on the hand of a wizard who works there.
HandForces forces_on(const ecs::World& world, ecs::Entity wizard);

/// A source of force on the hand.
struct FeltSource {
    std::string_view
        name;          ///< for people: "Recoil", "Spring", "Weight", "Wall", "Current", "Surface", "Flow",
                       ///< "Crystal"; empty: none
    double newtons{};  ///< its force before the limits of safety (N)
};

/// Returns the strongest source. `steady_name` names the steady force of the wand in hand, such as "Weight".
FeltSource strongest_source(const HandForces& forces, std::string_view steady_name);

}  // namespace thaum::game
