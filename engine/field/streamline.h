// field/streamline.h: lines that follow a vector field, such as the paths of a steady flow.
//
// A line is traced by its length s: dx/ds = v / |v|, with the Runge-Kutta scheme of order 4. Each step is done
// twice, whole and in two halves; a fifteenth of the difference estimates the error of the halves, which are
// kept, and sets the length of the next step (Press et al. 2007, "Numerical recipes", section 17.2). A line
// whose steps are h long therefore has an error of h^4.
//
// Each point has a direction across the line for drawing ribbons. It turns with the matter: by half of the
// curl's part along the line.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "field/field.h"

namespace thaum::field {

struct StreamlineSettings {
    double length = 1;        ///< length of the line (m)
    bool upstream = false;    ///< true: against the field
    double tolerance = 1e-6;  ///< greatest error of a step (m); 0: every step has the longest length
    double longest_step = 0.02, shortest_step = 1e-5;  ///< > 0 (m); the shortest is kept whatever its error
    double least_speed = 1e-9;                         ///< a line ends where the field is slower (m/s)
    int most_points = 4096;
    /// A line ends where it leaves this box (m).
    vec3 low{-std::numeric_limits<double>::infinity()}, high{std::numeric_limits<double>::infinity()};
};

struct StreamPoint {
    vec3 place{};    ///< (m)
    vec3 along{};    ///< unit direction of the line
    vec3 across{};   ///< unit, perpendicular to `along`
    double speed{};  ///< length of the field's vector (m/s)
    double way{};    ///< length of the line from the seed (m)
};

/// Reason why a line ends. The field is not finite: `still`.
enum class StreamEnd : std::uint8_t { length, still, outside, points };

/// Traces a line from `seed` into `out`, whose memory is kept between calls. The first point is the seed. No
/// points if the line ends there.
StreamEnd trace(const VectorField& field, vec3 seed, const StreamlineSettings& settings,
                std::vector<StreamPoint>& out);

}  // namespace thaum::field
