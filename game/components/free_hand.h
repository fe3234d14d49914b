// game/components/free_hand.h: the last seconds of a hand that may cast without a button, and what was almost cast.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

/// Room for 4 s of gameplay ticks.
inline constexpr std::size_t free_points = 500;

/// Why a motion that is like a gesture cast nothing.
enum class Miss : std::uint32_t {
    none,
    unclear,    ///< not sure enough
    too_fast,   ///< the gesture was over too soon, or not clear and fast
    too_small,  ///< the gesture had no size
    too_soon,   ///< a spell was cast just before
};

/// A part of the motion that ends where the hand came to rest, as it was read.
struct FreeWindow {
    double score{};  ///< distance from the recorded strokes, with what else counts; the less, the better
    double probability{};     ///< probability of the reading, as for a stroke with Trace held
    double needed{};          ///< probability from which on it casts
    double force{};           ///< mean force (N)
    std::uint32_t gesture{};  ///< number of the gesture; no_gesture: nothing was read
    Miss miss{};              ///< why it cannot cast
    THAUM_FIELDS(FreeWindow, score, probability, needed, force, gesture, miss);
};

/// The motion of a wizard who casts freely (game/casting/free_casting.h). Only wizards of players with that option have
/// one.
struct FreeHand {
    Tick newest{};   ///< tick of play of the newest point
    Tick cast_at{};  ///< tick of play of the last spell that was cast without a button; 0: none
    std::array<fvec3, free_points> points{};  ///< ring of places (m), as in DrawnPoint
    std::uint32_t first{};                    ///< place of the oldest point in the ring
    std::uint32_t count{};
    vec3 path{};              ///< place of the hand of a mouse, the sum of its motion (m)
    vec3 rest_place{};        ///< place near which the hand has been since it rests (m)
    std::uint32_t rested{};   ///< points for which it has been there
    std::uint32_t moving{};   ///< newest points since the last long rest, of which a gesture may consist
    std::uint32_t windows{};  ///< windows that were read since the hand rests
    std::uint32_t spare{};
    FreeWindow best{};  ///< best of the windows that may cast
    FreeWindow odd{};   ///< best of those that are too small or too fast
    THAUM_COMPONENT(FreeHand, newest, cast_at, points, first, count, path, rest_place, rested, moving,
                    windows, spare, best, odd);
};

/// The last motion that almost cast a spell without a button, for the picture. Wizards with a FreeHand have one.
struct NearMiss {
    Tick at{};                ///< tick of play at which the hand rested after it; 0: none yet
    double probability{};     ///< 0 to 1
    std::uint32_t gesture{};  ///< number of the gesture that it was like
    Miss reason{};
    THAUM_COMPONENT(NearMiss, at, probability, gesture, reason);
};

}  // namespace thaum::game
