// haptics/primitives/settling.h: how far the proxy goes in one tick, so that a still hand feels a still force
// and a hand that creeps or trembles feels no chatter.
//
//     proxy of the last tick, balance of spring and primitives --> settle --> proxy of this tick
//
// Modes read their field at the proxy of the last tick. On the ridge of a field both sides push towards it.
// There the balance throws the proxy across in every tick, with the whole strength, and no two ticks agree.
// The place on the ridge at which all forces cancel lies between. In the core of a vortex the balance throws
// the proxy round the axis instead. A proxy that goes only part of the way comes to rest in both:
//
//   - A proxy that has to turn back goes half as far as before, and farther again as soon as it goes straight
//     on. If the balance moves farther than proxy and tip explain, a smaller turn is enough: such a proxy
//     circles the place of rest.
//   - The way of a tick shrinks steadily, whatever the field and the modes. So at a fixed reading the force
//     changes by at most `min_pace` a tick after about 240 ticks.
//   - The hand explains as much change as its place and velocity stretch spring and damper, and a field as
//     much as its way stretches the spring. Beyond that the force changes by at most `max_pace` a tick, and
//     at a steady speed by at most five times what the hand explains. So a moving hand feels a prompt force,
//     and a wall that lets go, or takes hold, takes some ticks for that.
//
// The limits are those of the force, not of the proxy's way: a damper makes of a way of the proxy several
// times the force that the spring makes of it. The damper of a proxy that a wall stops needs more than that.
// The hand then feels that part of the force a little later.
//
// A proxy that goes only part of the way to the balance loses energy: the energy of spring and primitives is
// convex and least at the balance. So passive primitives stay passive.
#pragma once
#include <cstdint>

#include "core/maths.h"
#include "haptics/primitives/balance.h"

namespace thaum::haptics {

/// Largest change of the spring's force in a tick besides that by the hand's motion (N): when the proxy
/// begins, while the tip moves, and at rest.
inline constexpr double first_pace = 10, max_pace = 0.09, min_pace = 9e-5;

/// Ticks after which a proxy that began changes the force by no more than `max_pace`.
inline constexpr std::uint32_t first_ticks = 14;

/// Way of the tip that counts as rest (m): the flicker of the coarsest encoder.
inline constexpr double still_range = 1e-4;

/// State of a proxy that settles. All zero is a proxy that begins. No padding.
struct Settling {
    vec3 tip{};                ///< place of the tip in the last tick (m)
    vec3 rest{};               ///< place that follows the tip at a distance of at most `still_range` (m)
    vec3 step{};               ///< motion of the proxy in the last tick (m)
    vec3 balance{};            ///< balance of the last tick (m)
    double pace{};             ///< largest change of the force in a tick (N); 0: the proxy begins
    double bound{};            ///< bound of the pace, which falls in time and rises with motion (N)
    std::uint64_t straight{};  ///< ticks since the proxy last turned back
    vec3 force{};              ///< force of spring and damper in the last tick (N)
    vec3 lag{};                ///< what the hand felt beyond that force (N)
    vec3 pull{};               ///< pull of the hand at the proxy in the last tick, but for a constant (N)
};
static_assert(sizeof(Settling) == 7 * sizeof(vec3) + 3 * sizeof(double), "no padding");

/// The proxy of the last tick, and what draws it away from there.
struct ProxyWay {
    vec3 from{};            ///< proxy of the last tick (m)
    vec3 balance{};         ///< place at which spring and primitives are in balance (m)
    vec3 tip{};             ///< place of the tip (m)
    Spring spring{};        ///< spring between tip and proxy, with its damper
    double stiffness{};     ///< stiffness of the spring without its damper (N/m)
    double field_motion{};  ///< motion of the fields behind the primitives in this tick (m)
};

/// Returns the proxy of this tick (m): the balance itself, or a place on the way to it. The hand feels the
/// force of spring and damper, plus the lag of the state.
vec3 settle(Settling& state, const ProxyWay& way) noexcept;

}  // namespace thaum::haptics
