// gesture/stroke.h: strokes in four dimensions, the only input of this folder.
//
// A stroke is a list of points in time. Positions may be in any unit (metres, pixels), because every
// recogniser here normalises size and place. A device without a force writes zeros.
#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/maths.h"

namespace thaum::gesture {

/// A measured point of a stroke.
struct StrokePoint {
    double t{};      ///< time (s)
    vec3 at{};       ///< position (any unit)
    double force{};  ///< force on the hand (any unit, mostly N); 0 where the device has none
};

/// Points of a stroke in the order of time.
using Points = std::span<const StrokePoint>;

/// A stroke with its labels, as data sets and template files hold it.
struct Stroke {
    std::string user;
    std::string gesture;
    std::string sample;  ///< name that distinguishes strokes of one user and gesture
    std::vector<StrokePoint> points;
    std::size_t line{};  ///< line of the stroke's first point in the file (from 1); 0: not from a file
};

/// Parts of a point that a recogniser may use besides x and y.
struct Channels {
    bool depth = true;  ///< true: z may be used
    bool force = true;

    bool operator==(const Channels&) const = default;
};

/// Whether all numbers of a point are finite.
inline bool is_finite(const StrokePoint& p) {
    return std::isfinite(p.t) && thaum::is_finite(p.at) && std::isfinite(p.force);
}

}  // namespace thaum::gesture
