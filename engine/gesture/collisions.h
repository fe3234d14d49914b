// gesture/collisions.h: which gestures would be taken for one another, known at recording time.
//
// Variations of each gesture (variations.h) are read among all. Two gestures collide if strokes of one would be
// mistaken: more than one in fifty is accepted as the other, or more than one in twenty is nearer to the other than to
// its own. The second case is of copies: a recogniser is sure of neither then, so it accepts few strokes of both. It is
// also the steadier measure, since it does not depend on the strokes that set the thresholds.
#pragma once
#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "core/error.h"
#include "gesture/recogniser.h"

namespace thaum::gesture {

inline constexpr double most_taken = 0.02;   ///< largest share of variations that are accepted as the other
inline constexpr double most_nearer = 0.05;  ///< largest share of variations that are nearer to the other

/// How variations of one gesture are read beside another one, as shares of all.
struct Mistaken {
    double taken{};   ///< accepted as the other
    double nearer{};  ///< nearer to the other than to any other gesture, accepted or not

    bool often() const { return taken > most_taken || nearer > most_nearer; }
};

struct Pair {
    std::uint32_t a{}, b{};   ///< a < b
    Mistaken a_as_b, b_as_a;  ///< strokes of one that are read as the other
    /// Least distance of a template of one to the other gesture, in usual distances of the wider gesture. It orders
    /// pairs that are never mistaken, and is no reason to collide.
    double separation{};

    bool collides() const { return a_as_b.often() || b_as_a.often(); }
    double nearer() const { return std::max(a_as_b.nearer, b_as_a.nearer); }
};

/// How a stroke is read in play. Empty: by Recogniser::recognise.
using ReadStroke = std::function<Recognition(const Recogniser&, Points, RecogniserSpace&)>;

/// All pairs, those first whose strokes are mistaken the most often, then the closest.
Expected<std::vector<Pair>> compare_gestures(std::span<const Gesture> gestures,
                                             const RecogniserSettings& settings = {},
                                             const ReadStroke& read = {});

}  // namespace thaum::gesture
