// game/picture/stroke_pieces.h: the pieces in which a stroke is drawn.
#pragma once
#include <cstddef>

#include "core/maths.h"

namespace thaum::game {

/// Calls `take(from, to)` with the numbers of two points for each piece of a stroke's picture: for every step of the hand,
/// or, of a stroke of more than `most` steps, for pieces of about equal length. So a rest takes no pieces from the motion.
/// `at(i)` is the place of a point, a vector.
template <class At, class Take>
void each_piece(std::size_t count, std::size_t most, At&& at, Take&& take) {
    const auto step = [&](std::size_t i) { return static_cast<double>(glm::distance(at(i - 1), at(i))); };
    double length = 0, gone = 0;
    for (std::size_t i = 1; i < count; ++i) length += step(i);
    const double least = count > most + 1 ? length / static_cast<double>(most) : 0;
    for (std::size_t i = 1, from = 0; i < count; ++i) {
        gone += step(i);
        if (gone < least && i + 1 < count) continue;
        take(from, i);
        from = i;
        gone = 0;
    }
}

}  // namespace thaum::game
