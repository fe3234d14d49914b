// game/components/station.h: a wizard at work at a station: the cauldron, the orb or a crystal.
#pragma once
#include "core/maths.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

enum class StationKind : std::uint32_t { cauldron, orb, crystal };

/// A wizard who holds the Stir button at a station (cauldron, orb or crystal). The wizard stands still, the
/// hand moves a ladle, a probe or a tool, and the view turns to the station. The component Ladle, Scrying or
/// Chisel has the state of that work.
struct AtStation {
    vec3 middle{};  ///< point to which the view turns (m, world)
    /// Yaw of the -z axis of the hand's frame: the direction from the wizard to `middle` when the work began
    /// (rad).
    double yaw{};
    StationKind kind{};
    std::uint32_t number{};  ///< number of the station among those of its kind, such as the crystals
    THAUM_COMPONENT(AtStation, middle, yaw, kind, number);
};

}  // namespace thaum::game::inline components
