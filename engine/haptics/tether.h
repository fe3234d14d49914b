// haptics/tether.h: spring and damper from the tip to a point, with notches (detents) along a line.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"
#include "haptics/tip.h"

namespace thaum::haptics {

inline constexpr std::size_t max_detents = 3;

/// Notches along a line. Each draws the tip to its middle. They are the negative gradient of a potential, so
/// they create no energy.
struct Detents {
    vec3 axis{};  ///< direction of the notches' line, which goes through the anchor (unit, device frame)
    /// Middle of each notch along the axis from the anchor (m).
    std::array<double, max_detents> places{};
    double depth{};  ///< largest force of a notch (N); 0: no notches
    double width{};  ///< width of each notch, > 0, at most the distance between notches (m)
};

/// A spring and damper from the tip to a point, for example a held thing or a slingshot. A passive source if
/// the point stands still. If the point belongs to a thing of the world, that thing gets the opposite force.
struct Tether {
    vec3 anchor{};           ///< point to which the tip is tied (m, device frame)
    vec3 anchor_velocity{};  ///< velocity of the anchor (m/s)
    double stiffness{};      ///< stiffness of the spring (N/m); 0: no tether
    double damping{};        ///< damping between tip and anchor (N s/m)
    Detents detents{};
    std::uint64_t number{};  ///< changes when the tether appears, ends or jumps, which the safety stage fades
};

/// Force of the tether (a spring and damper) on the tip (N), given the tip's velocity (m/s).
vec3 tether_force(const Tether& tether, vec3 tip, vec3 velocity);

/// Force of the detents (notches) along their axis (N), `along` metres from the anchor.
double detent_force(const Detents& detents, double along);

/// A tether (spring and damper from the tip to a point) and its force in one tick.
struct TetherForce {
    Tether tether{};  ///< the tether; its anchor is moved on from the time of the haptic model to the present
    vec3 force{};     ///< force on the hand (N)
    bool switched{};  ///< the tether appeared, ended or jumped
};

/// Computes the force of a tether (spring and damper) in a haptic model that is `age` ticks old.
TetherForce feel_tether(ServoState& state, const Tether& tether, std::uint32_t age, const Tip& tip);

}  // namespace thaum::haptics
