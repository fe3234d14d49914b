#include "gesture/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t compared_points = 48;
// Size below which an unrecognised stroke counts as too small (m).
constexpr double min_size = 0.03;
// Root mean square distance from the gesture up to which a stroke has its shape (share of the size).
constexpr double same_shape = 0.08;
// Largest gap between start and end of a closed gesture (share of the size).
constexpr double widest_gap = 0.25;
// Angle between stroke and gesture from which on the player is told about it (rad).
constexpr double told_tilt = 12 * pi / 180;
// Distance of a point of the stroke from the gesture from which on the player is told about it, and distance
// from the gesture's middle that still counts as its middle (shares of the size).
constexpr double told_deviation = 0.16, central = 0.12;
constexpr std::size_t max_lines_of_advice = 3;

using Outline = std::array<vec3, compared_points>;

/// Puts points at equal distances along the stroke into `out`; returns false if the stroke has no two
/// different places.
bool resample(Points stroke, Outline& out) {
    std::vector<double> length(stroke.size());
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const vec3 step = stroke[i].at - stroke[i - 1].at;
        length[i] = length[i - 1] + std::hypot(step.x, step.y);
    }
    if (stroke.size() < 2 || !(length.back() > 0) || !std::isfinite(length.back())) return false;
    std::size_t k = 1;
    for (std::size_t i = 0; i < compared_points; ++i) {
        const double wanted = length.back() * static_cast<double>(i) / (compared_points - 1);
        while (k + 1 < stroke.size() && length[k] < wanted) ++k;
        const double way = length[k] - length[k - 1];
        const double share = way > 0 ? std::clamp((wanted - length[k - 1]) / way, 0.0, 1.0) : 0;
        out[i] = glm::mix(stroke[k - 1].at, stroke[k].at, share);
        out[i].z = 0;
    }
    return true;
}

double size_of_box(const Outline& outline) {
    vec3 low = outline[0], high = low;
    for (const vec3 p : outline) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return std::max(high.x - low.x, high.y - low.y);
}

/// Moves the centroid of the points to the origin and scales them so that their root mean square distance
/// from it is 1.
void normalise(Outline& outline) {
    vec3 middle(0);
    for (const vec3 p : outline) middle += p / static_cast<double>(compared_points);
    double sum = 0;
    for (vec3& p : outline) {
        p -= middle;
        sum += glm::dot(p, p) / static_cast<double>(compared_points);
    }
    for (vec3& p : outline) p /= std::sqrt(std::max(sum, 1e-30));
}

/// How the outline of a drawn stroke fits best on that of a gesture: by which turn, from which starting point
/// and in which direction, and how far their points then still are apart.
struct Fit {
    double sum = 1e300;  ///< sum of the squared distances between points of the two outlines
    double angle{};      ///< angle by which the drawn outline is turned against the other (rad)
    std::size_t shift{};
    bool reversed{};
};

const vec3& point(const Outline& outline, std::size_t i, const Fit& fit) {
    // In a closed outline the last point equals the first, so it is left out of the cycle.
    const std::size_t at = fit.shift == 0 ? i : (i + fit.shift) % (compared_points - 1);
    return outline[fit.reversed ? compared_points - 1 - at : at];
}

void try_fit(const Outline& drawn, const Outline& wanted, Fit fit, Fit& best) {
    double along = 0, across = 0;
    for (std::size_t i = 0; i < compared_points; ++i) {
        const vec3 a = point(wanted, i, fit), b = drawn[i];
        along += a.x * b.x + a.y * b.y;
        across += a.x * b.y - a.y * b.x;
    }
    fit.angle = det::atan2(across, along);
    fit.sum = 2.0 * compared_points - 2 * std::sqrt(along * along + across * across);
    if (fit.sum < best.sum) best = fit;
}

/// The best fit of a drawn stroke on a gesture, over both directions of drawing and, for closed gestures, all
/// starting points. A fit with a turn beyond a right angle counts only if there is no other, because a stroke
/// turned so far mostly is another gesture. This does not hold for gestures that may be turned by any angle.
Fit fit_outlines(const Outline& drawn, const Outline& wanted, const GestureOptions& options) {
    Fit best, turned;
    const std::size_t shifts = options.closed ? compared_points - 1 : 1;
    for (const bool reversed : {false, true}) {
        for (std::size_t s = 0; s < shifts; ++s) {
            Fit fit;
            try_fit(drawn, wanted, {.shift = s, .reversed = reversed}, fit);
            auto& kept = options.rotation < 3 && std::abs(fit.angle) > pi / 2 ? turned : best;
            if (fit.sum < kept.sum) kept = fit;
        }
    }
    return best.sum < 1e300 ? best : turned;
}

bool is_turned_too_far(const Comparison& c, const GestureOptions& o) {
    return o.rotation < 3 && std::abs(c.tilt) > std::max(told_tilt, o.rotation);
}

}  // namespace

Comparison compare(Points stroke, const Gesture& gesture) {
    Comparison c;
    Outline drawn;
    if (!resample(stroke, drawn)) return c;
    c.size = size_of_box(drawn);
    if (!(c.size > 0)) return c;
    c.gap = glm::distance(drawn.front(), drawn.back()) / c.size;
    normalise(drawn);
    double least = 1e300;
    for (const auto& recorded : gesture.strokes) {
        Outline wanted;
        if (!resample(recorded, wanted)) continue;
        const double size_of_recorded = size_of_box(wanted);
        normalise(wanted);
        const auto fit = fit_outlines(drawn, wanted, gesture.options);
        if (fit.sum >= least) continue;
        least = fit.sum;
        const double size = size_of_box(wanted);
        c.scale = c.size / size_of_recorded;
        c.tilt = fit.angle;
        c.backwards = fit.reversed && gesture.options.direction_sensitive;
        c.deviation = std::sqrt(std::max(fit.sum, 0.0) / compared_points) / size;
        c.worst = 0;
        for (std::size_t i = 0; i < compared_points; ++i) {
            const vec3 meant = point(wanted, i, fit);
            const double off = glm::distance(rotation({0, 0, 1}, -fit.angle) * drawn[i], meant) / size;
            if (off <= c.worst) continue;
            c.worst = off;
            c.worst_place = meant / size;
        }
    }
    return c;
}

std::string place_words(vec3 from_middle) {
    const auto is_far = [&](double along, double other) {
        return std::abs(along) > central && std::abs(along) > 0.4 * std::abs(other);
    };
    std::string words;
    if (is_far(from_middle.y, from_middle.x)) words = from_middle.y > 0 ? "upper" : "lower";
    if (is_far(from_middle.x, from_middle.y))
        words += text(words.empty() ? "" : " ", from_middle.x > 0 ? "right" : "left");
    if (words == "upper") return "top";
    if (words == "lower") return "bottom";
    return words.empty() ? "middle" : words;
}

bool is_turned_copy(const Comparison& c, const Gesture& gesture) {
    return c.size > 0 && c.deviation < same_shape && (c.backwards || is_turned_too_far(c, gesture.options));
}

std::vector<std::string> advice_on(const Comparison& c, const Gesture& gesture, double force, bool read) {
    std::vector<std::string> lines;
    const auto& o = gesture.options;
    if (!read && (c.size < min_size || c.scale < o.min_scale))
        lines.push_back(text("draw it larger: it has ", fixed(100 * c.size, 1), " cm"));
    if (!read && c.scale > o.max_scale)
        lines.push_back(text("draw it smaller: it has ", fixed(100 * c.size, 1), " cm"));
    if (c.backwards) lines.emplace_back("draw it from the other end");
    if (is_turned_too_far(c, o))
        lines.push_back(text("turn it ", fixed(std::abs(c.tilt) * 180 / pi, 0), " degrees to the ",
                             c.tilt > 0 ? "right" : "left"));
    if (o.closed && c.gap > widest_gap) lines.emplace_back("end where you began");
    if (c.worst > told_deviation)
        lines.push_back(text("the ", place_words(c.worst_place), " is the farthest off"));
    if (o.harsh_above > 0 && force >= o.gentle_below && force < o.harsh_above)
        lines.emplace_back("slower for gentle, faster for harsh");
    if (lines.size() > max_lines_of_advice) lines.resize(max_lines_of_advice);
    return lines;
}

}  // namespace thaum::gesture
