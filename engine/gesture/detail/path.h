// gesture/detail/path.h: the length of the path that a stroke draws.
#pragma once
#include <cstddef>

#include "gesture/gesture.h"

namespace thaum::gesture {

/// Sum of the distances between neighbouring points (unit of the positions).
inline double path_length(Points stroke) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) length += glm::distance(stroke[i - 1].at, stroke[i].at);
    return length;
}

}  // namespace thaum::gesture
