// gesture/collisions.h: finds gestures that would be mistaken for one another, already when they are
// recorded.
//
// Variations of each gesture (synthetic strokes, variations.h) are recognised among all gestures. Two
// gestures collide if too many strokes of one would be mistaken for the other: more than one in fifty is
// accepted as the other, or more than one in twenty is nearer to the other than to its own, accepted or not.
// The second case covers gestures that are copies of each other: a recogniser is then sure of neither and
// accepts few strokes of both. The share of the second case also varies less from one set of variations to
// the next, since it does not depend on the strokes that set the thresholds of acceptance.
#pragma once
#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "core/error.h"
#include "gesture/recogniser.h"

namespace thaum::gesture {

/// Largest share of a gesture's variations (synthetic strokes) that may be accepted as the other gesture.
inline constexpr double max_taken = 0.02;
/// Largest share of a gesture's variations (synthetic strokes) that may be nearer to the other gesture than
/// to their own.
inline constexpr double max_nearer = 0.05;

/// How often variations (synthetic strokes) of one gesture are taken for another one, as shares of all of
/// them.
struct Mistaken {
    /// Share of the gesture's variations (synthetic strokes) that are accepted as the other gesture.
    double taken{};
    /// Share of the gesture's variations (synthetic strokes) that are nearest to the other gesture instead of
    /// their own, accepted or not.
    double nearer{};

    /// Whether too many variations are accepted as the other gesture (`max_taken`) or are nearer to it
    /// (`max_nearer`).
    bool often() const { return taken > max_taken || nearer > max_nearer; }
};

/// Two gestures, and how often each is mistaken for the other.
struct Pair {
    std::uint32_t a{}, b{};   ///< numbers of the two gestures, a < b
    Mistaken a_as_b, b_as_a;  ///< strokes of a that are recognised as b, and of b as a
    /// Distance between the two gestures: the least from a template of one to the other, divided by the usual
    /// distance between strokes of the same gesture (the larger of both gestures' usual distances). It only
    /// gives an order to pairs that are never mistaken, and has no part in collides().
    double separation{};

    /// Whether one of the two gestures is mistaken for the other too often.
    bool collides() const { return a_as_b.often() || b_as_a.often(); }
    /// Share of the variations (synthetic strokes) of one gesture that are nearer to the other gesture: that
    /// of a or that of b, whichever is larger.
    double nearer() const { return std::max(a_as_b.nearer, b_as_a.nearer); }
};

/// A function with which variations (synthetic strokes) are recognised, so that they are read as strokes are
/// in the game. Empty: Recogniser::recognise.
using ReadStroke = std::function<Recognition(const Recogniser&, Points, RecogniserSpace&)>;

/// All pairs of gestures. Pairs whose strokes are mistaken most often come first, then those whose gestures
/// have the smallest distance from each other (Pair::separation).
Expected<std::vector<Pair>> compare_gestures(std::span<const Gesture> gestures,
                                             const RecogniserSettings& settings = {},
                                             const ReadStroke& read = {});

}  // namespace thaum::gesture
