// gesture/detail/twins.h: twins are gestures of one shape whose strokes differ in mean force.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/maths.h"

namespace thaum::gesture {

/// Elastic distance (elastic.h) up to which two gestures count as one shape (are twins) if the mean force of
/// one is twice that of the other. The limit grows with the logarithm of the ratio of the forces, up to
/// max_twin_distance: the clearer the difference in force, the less alike the shapes need be.
inline constexpr double twin_distance = 0.07, max_twin_distance = 0.15;
/// Limits like twin_distance and max_twin_distance, for a pair of gestures that no third one resembles: every
/// other gesture is at least `clear_of_others` times as far from them as they are from each other. Both
/// limits are larger, because strokes of such a pair that are drawn with little care may differ more and
/// still be of one shape.
inline constexpr double clear_twin_distance = 0.12, max_clear_twin_distance = 0.25, clear_of_others = 1.6;

/// Whether two gestures are so near to each other in shape, and so different in force, that force should tell
/// them apart. `force` and `other` are the mean forces of their strokes. `third` is the distance to the
/// nearest third gesture; 0: there is none.
inline bool differ_in_force(double distance, double force, double other, double third = 0) {
    if (!(std::min(force, other) > 0)) return false;
    const double doublings = std::abs(det::log(force / other)) / det::log(2);
    if (distance <= std::min(twin_distance * doublings, max_twin_distance)) return true;
    return distance * clear_of_others <= third &&
           distance <= std::min(clear_twin_distance * doublings, max_clear_twin_distance);
}

/// How unusual a stroke's mean force is for a gesture whose strokes have the mean force `usual`: half the
/// square of the difference of the logarithms of both forces, in units of force_scatter, the usual deviation.
inline double force_oddness(double force, double usual) {
    constexpr double force_scatter = 0.25;
    constexpr double min_force = 1e-3;  // smallest force that counts (share of the usual force)
    const double ratio = std::max(force / usual, min_force);
    const double off = det::log(ratio) / force_scatter;
    return off * off / 2;
}

/// Adds each of two gestures to the other's list of twins (gestures of its shape with another force), unless
/// it is there already.
inline void add_twins(std::vector<std::vector<std::uint32_t>>& twins, std::uint32_t a, std::uint32_t b) {
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        if (std::find(twins[from].begin(), twins[from].end(), to) == twins[from].end())
            twins[from].push_back(to);
    };
    add(a, b);
    add(b, a);
}

}  // namespace thaum::gesture
