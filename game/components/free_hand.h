// game/components/free_hand.h: the last seconds of motion of a hand whose player may cast spells without a
// button, and gestures that were almost cast.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

/// Number of points that a FreeHand holds: one for each gameplay tick of 4 s.
inline constexpr std::size_t free_points = 500;

/// Why a motion of the hand that resembles a gesture cast no spell.
enum class Miss : std::uint32_t {
    none,
    unclear,    ///< the probability of the gesture was too low
    too_fast,   ///< the gesture took too little time, or the reading was uncertain and the hand fast
    too_small,  ///< the gesture was too small
    too_soon,   ///< a spell was cast just before
};

/// A part of the hand's motion that ends where the hand came to rest, with the gesture read from it.
struct FreeWindow {
    double score{};  ///< how unlike a gesture the motion is: distance from the recorded strokes plus
                     ///< penalties; smaller is better
    /// Probability that the gesture was meant, if half of all motions mean no gesture (0 to 1)
    double probability{};
    double needed{};          ///< probability that the gesture needs in order to cast its spell, 0 to 1
    double force{};           ///< mean force of the motion (N)
    std::uint32_t gesture{};  ///< number of the gesture read from this part of the motion (window);
                              ///< no_gesture: none was
    Miss miss{};              ///< why this part of the motion (window) cannot cast a spell
    THAUM_FIELDS(FreeWindow, score, probability, needed, force, gesture, miss);
};

/// The motion of a wizard who may cast spells without a button (game/casting/free_casting.h). Only wizards of
/// players with that option have this component.
struct FreeHand {
    Tick newest{};   ///< tick of play of the newest point
    Tick cast_at{};  ///< tick of play of the last spell that was cast without a button; 0: none
    std::array<fvec3, free_points> points{};  ///< ring buffer of positions, with the axes of DrawnPoint (m)
    std::uint32_t first{};                    ///< index of the oldest point in the ring buffer
    std::uint32_t count{};
    vec3 path{};             ///< position of a mouse player's hand, the sum of its motion (m)
    vec3 rest_place{};       ///< position near which the hand has rested (m)
    std::uint32_t rested{};  ///< number of points for which the hand has rested near rest_place
    /// Number of points since the last long rest. A gesture is looked for among these points.
    std::uint32_t moving{};
    std::uint32_t windows{};  ///< number of windows (parts of the motion) read since the hand came to rest
    std::uint32_t spare{};
    /// Best of the parts of the motion that are large and slow enough for a gesture; its reading may be
    /// unclear.
    FreeWindow best{};
    FreeWindow odd{};  ///< best of the parts of the motion that are too small or too fast for a gesture
    THAUM_COMPONENT(FreeHand, newest, cast_at, points, first, count, path, rest_place, rested, moving,
                    windows, spare, best, odd);
};

/// The last motion that almost cast a spell without a button, which the screen tells the player. Wizards with
/// a FreeHand have this component.
struct NearMiss {
    Tick at{};  ///< tick of play at which the hand rested after the motion; 0: there was no such motion yet
    double probability{};     ///< probability that the gesture was meant, 0 to 1
    std::uint32_t gesture{};  ///< number of the gesture that the motion resembled
    Miss reason{};
    THAUM_COMPONENT(NearMiss, at, probability, gesture, reason);
};

}  // namespace thaum::game::inline components
