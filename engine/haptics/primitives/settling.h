// haptics/primitives/settling.h: how far the proxy goes in one tick, so that a still hand feels a still force
// and a hand that creeps or trembles feels no chatter.
//
//     proxy of the last tick, balance of spring and primitives --> settle --> proxy of this tick
//
// Modes read their field at the proxy of the last tick. On both sides of a ridge of the field, they push
// towards the ridge. There the balance throws the proxy across the ridge in every tick, with the whole
// strength, although all forces cancel at a place on the ridge. In the core of a vortex the balance throws
// the proxy round the axis instead. A proxy that goes only part of the way to the balance comes to rest in
// both cases:
//
//   - A proxy that has to turn back goes half as far as before, and farther again as soon as it goes straight
//     on. If the balance moves farther than the motion of proxy and tip explains, a smaller turn is enough to
//     halve the step: such a proxy circles the place of rest.
//   - The largest step of a tick shrinks steadily, whatever the field and the modes. So while hand and fields
//     rest, the force changes by at most `min_pace` a tick after about 240 ticks.
//   - A change of the force is explained up to what the hand's motion adds by stretching spring and damper,
//     and what a field's motion would add by stretching the spring. Beyond that the force changes by at most
//     `max_pace` a tick, and at a steady speed by at most five times the explained change. So a moving hand
//     feels a prompt force, and a wall that lets go, or takes hold, does so over some ticks.
//
// The limits apply to the force, not to the proxy's way, because with a damper the same way changes the force
// several times as much as with the spring alone. When a wall stops the proxy, the damper's force changes by
// more than the limits. The hand then feels that part of the force a little later (Settling::lag).
//
// A proxy that goes only part of the way to the balance loses energy: the energy of spring and primitives is
// convex and least at the balance. So passive primitives stay passive.
#pragma once
#include <cstdint>

#include "core/maths.h"
#include "haptics/primitives/balance.h"

namespace thaum::haptics {

/// Largest change of the spring's force in a tick beyond what the hand's motion explains (N): in the first
/// tick of a proxy, while the tip moves, and at rest.
inline constexpr double first_pace = 10, max_pace = 0.09, min_pace = 9e-5;

/// Ticks after which a new proxy changes the force by no more than `max_pace` a tick.
inline constexpr std::uint32_t first_ticks = 14;

/// Range within which a moving tip counts as at rest (m): the flicker of the coarsest encoder.
inline constexpr double still_range = 1e-4;

/// State of a proxy, from which its motion in a tick is limited. All zero means that the proxy is new. No
/// padding.
struct Settling {
    vec3 tip{};  ///< place of the tip in the last tick (m)
    /// Place that follows the tip only beyond `still_range`; a tip that flickers within this range counts as
    /// at rest (m).
    vec3 rest{};
    vec3 step{};               ///< motion of the proxy in the last tick (m)
    vec3 balance{};            ///< place at which spring and primitives were in balance in the last tick (m)
    double pace{};             ///< largest change of the force in a tick (N); 0: the proxy is new
    double bound{};            ///< upper bound of `pace`, which falls in time and rises with motion (N)
    std::uint64_t straight{};  ///< number of ticks since the proxy last turned
    vec3 force{};              ///< force of spring and damper in the last tick (N)
    vec3 lag{};                ///< force that the hand feels in addition to `force`, since it lags behind (N)
    vec3 pull{};               ///< pull on the proxy by the hand's place and velocity in the last tick (N)
};
static_assert(sizeof(Settling) == 7 * sizeof(vec3) + 3 * sizeof(double), "no padding");

/// The proxy of the last tick, and the balance to which spring and primitives draw it.
struct ProxyWay {
    vec3 from{};            ///< place of the proxy in the last tick (m)
    vec3 balance{};         ///< place at which spring and primitives are in balance (m)
    vec3 tip{};             ///< place of the tip (m)
    Spring spring{};        ///< spring between tip and proxy, with its damper
    double stiffness{};     ///< stiffness of the spring without its damper (N/m)
    double field_motion{};  ///< motion in this tick of the fields from which the primitives are made (m)
};

/// Returns the proxy of this tick (m): the balance itself, or a place on the way to it. The hand feels the
/// force of spring and damper, plus Settling::lag.
vec3 settle(Settling& state, const ProxyWay& way) noexcept;

}  // namespace thaum::haptics
