// game/senses/tactile/felt_source.h: the forces that act on the hand now, and the name of the strongest.
#pragma once
#include <array>
#include <string_view>

#include "ecs/world.h"
#include "game/components/hand_state.h"

namespace thaum::game::inline senses {

/// Sources of force on the hand.
enum class ForceSource : std::uint8_t { recoil, spring, steady, wall, current, bowl, surface, flow, crystal };
inline constexpr std::size_t force_sources = 9;

/// Force of each source on the hand before safety limits (N, device frame; the brew's: ladle frame).
using HandForces = std::array<vec3, force_sources>;
HandForces forces_on(const HandState& hand_state);
/// The forces on a wizard's hand, including those of the orb's flow or of a crystal at which the wizard
/// works.
HandForces forces_on(const ecs::World& world, ecs::Entity wizard);

/// A source of force on the hand.
struct FeltSource {
    /// Display name: "Recoil", "Spring", "Weight", "Wall", "Current", "Surface", "Flow", "Crystal"; empty:
    /// none.
    std::string_view name;
    double newtons{};  ///< force of this source before safety limits (N)
};

/// Returns the strongest source. `steady_name` names the steady force of the wand in hand, such as "Weight".
FeltSource strongest_source(const HandForces& forces, std::string_view steady_name);

}  // namespace thaum::game::inline senses
