// game/picture/stroke_pieces.h: splits a stroke into the pieces in which it is drawn.
#pragma once
#include <cstddef>

#include "core/maths.h"

namespace thaum::game::inline picture {

/// Calls `take(from, to)` with the numbers of two points for each piece of a stroke. A piece is one step of
/// the hand or, if there are more than `most` steps, a part of the path; all parts have about the same
/// length, so that a hand at rest uses up none of them. `at(i)` is the position of a point, a vector.
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

}  // namespace thaum::game::inline picture
