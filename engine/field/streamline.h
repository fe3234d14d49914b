// field/streamline.h: lines that follow a vector field, such as the paths of a steady flow.
//
// A line is traced by its length s: dx/ds = v / |v|, with the Runge-Kutta scheme of order 4. Each step is
// done twice, as a whole and in two halves, and the result of the halves is kept. A fifteenth of the
// difference estimates its error and sets the length of the next step (Press et al. 2007, "Numerical
// recipes", section 17.2). With steps of the length h, the error of a line is proportional to h^4.
//
// Each point has a direction across the line for drawing ribbons. It turns about the line as the flowing
// matter does, by half of the curl's component along the line.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "field/field.h"

namespace thaum::field {

/// Settings for tracing a streamline.
struct StreamlineSettings {
    double length = 1;        ///< length at which the line ends (m)
    bool upstream = false;    ///< true: follows the field backwards
    double tolerance = 1e-6;  ///< greatest error of a step (m); 0: every step has the longest allowed length
    /// Limits of the step length, > 0 (m); a step of the shortest length is kept whatever its error.
    double longest_step = 0.02, shortest_step = 1e-5;
    double min_speed = 1e-9;  ///< speed of the field below which a line ends (m/s)
    int max_points = 4096;
    /// A line ends where it leaves this box (m).
    vec3 low{-std::numeric_limits<double>::infinity()}, high{std::numeric_limits<double>::infinity()};
};

/// One point of a streamline.
struct StreamPoint {
    vec3 place{};    ///< position of the point (m)
    vec3 along{};    ///< direction of the line (unit)
    vec3 across{};   ///< direction across the line (unit), perpendicular to `along`
    double speed{};  ///< length of the field's vector (m/s)
    double way{};    ///< length of the line from its first point to this one (m)
};

/// Why a line ends: its length is reached, the field is 0 or not finite (`still`), the line leaves the box,
/// or it has the largest allowed number of points.
enum class StreamEnd : std::uint8_t { length, still, outside, points };

/// Traces a line from `seed` into `out`, whose memory is kept between calls. The first point is the seed.
/// There are no points if the field is still at the seed or if the seed is outside the box.
StreamEnd trace(const VectorField& field, vec3 seed, const StreamlineSettings& settings,
                std::vector<StreamPoint>& out);

}  // namespace thaum::field
