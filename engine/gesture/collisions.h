// gesture/collisions.h: which gestures would be taken for one another, known at recording time.
//
// Variations of each gesture (variations.h) are recognised among all. Two gestures collide if more than one variation
// in fifty of one is taken for the other, or if their templates are closer to each other than twice the usual
// distance of a stroke from its own gesture.
#pragma once
#include <span>
#include <vector>

#include "core/error.h"
#include "gesture/recogniser.h"

namespace thaum::gesture {

inline constexpr double most_confused = 0.02;  ///< share of variations
inline constexpr double least_separation = 2;  ///< usual distances

struct Pair {
    std::uint32_t a{}, b{};     ///< a < b
    double a_as_b{}, b_as_a{};  ///< shares of variations that are taken for the other
    /// Least distance of a template of one to the other gesture, in usual distances of the wider gesture.
    double separation{};

    bool collides() const {
        return a_as_b > most_confused || b_as_a > most_confused || separation < least_separation;
    }
};

/// All pairs, the closest first.
Expected<std::vector<Pair>> compare_gestures(std::span<const Gesture> gestures,
                                             const RecogniserSettings& settings = {});

}  // namespace thaum::gesture
