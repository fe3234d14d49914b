// haptics/settling.h: how far the proxy goes in one tick, so that a still hand feels a still force.
//
//     proxy of the last tick, balance of spring and primitives --> settle --> proxy of this tick
//
// Modes read their field at the proxy of the last tick. On the ridge of a field both sides push towards it. There the
// balance throws the proxy across in every tick, with the whole strength, and no two ticks agree. The place on the ridge
// at which all forces cancel lies between. A proxy that goes only part of the way finds it:
//
//   - A proxy that has to turn back goes half as far as before, and farther again as soon as it goes straight on.
//   - While the tip stays where it is, the way of a tick shrinks steadily, whatever the field and the modes. So at a
//     fixed reading the force changes by at most `least_pace` a tick after about 270 ticks.
//   - A tip that moves always lets the proxy go twice as far as itself, so that a moving hand feels a prompt force.
//
// A proxy that goes only part of the way to the balance loses energy: the energy of spring and primitives is convex and
// least at the balance. So passive primitives stay passive.
#pragma once
#include <cstdint>

#include "core/maths.h"

namespace thaum::haptics {

/// Largest change of the spring's force in a tick, at first and at rest (N).
inline constexpr double most_pace = 10, least_pace = 2e-4;

/// Way of the tip that counts as rest (m): the flicker of the coarsest encoder.
inline constexpr double still_range = 1e-4;

/// State of a proxy that settles; all zero: it begins. No padding.
struct Settling {
    vec3 tip{};                ///< place of the tip in the last tick (m)
    vec3 rest{};               ///< place from which the tip has not gone farther than `still_range` (m)
    vec3 step{};               ///< motion of the proxy in the last tick (m)
    double pace{};             ///< largest change of the force in a tick (N); 0: begins
    double bound{};            ///< bound of the pace, which falls while the tip rests (N)
    std::uint64_t straight{};  ///< ticks since the proxy last turned back
};
static_assert(sizeof(Settling) == 3 * sizeof(vec3) + 3 * sizeof(double), "no padding");

/// Where a proxy comes from and where it should go.
struct ProxyWay {
    vec3 from{};            ///< proxy of the last tick (m)
    vec3 balance{};         ///< place at which spring and primitives are in balance (m)
    vec3 tip{};             ///< place of the tip (m)
    double stiffness{};     ///< stiffness of the spring (N/m)
    double field_motion{};  ///< motion of the fields behind the primitives in this tick (m)
};

/// Returns the proxy of this tick (m): the balance itself, or a place on the way to it.
vec3 settle(Settling& state, const ProxyWay& way) noexcept;

}  // namespace thaum::haptics
