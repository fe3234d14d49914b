#include "gesture/trials/dot.h"

#include <algorithm>

namespace thaum::gesture {
namespace {

double distance(const StrokePoint& a, const StrokePoint& b) { return glm::length(b.at - a.at); }

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double part) {
    return {a.t + part * (b.t - a.t), a.at + part * (b.at - a.at), a.force + part * (b.force - a.force)};
}

}  // namespace

std::array<StrokePoint, dot_points> equally_spaced(Points stroke) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) length += distance(stroke[i - 1], stroke[i]);
    std::array<StrokePoint, dot_points> result;
    result.fill(stroke[0]);
    double begin = 0;  // arc length up to stroke[j]
    std::size_t j = 0;
    for (std::size_t i = 1; i < dot_points && stroke.size() > 1; ++i) {
        const double wanted = length * static_cast<double>(i) / (dot_points - 1);
        double step = distance(stroke[j], stroke[j + 1]);
        while (j + 2 < stroke.size() && begin + step < wanted) {
            begin += step;
            ++j;
            step = distance(stroke[j], stroke[j + 1]);
        }
        const double part = step > 0 ? std::clamp((wanted - begin) / step, 0.0, 1.0) : 0;
        result[i] = between(stroke[j], stroke[j + 1], part);
    }
    return result;
}

bool make_vector(Points stroke, Channels channels, StrokeVector& vector) {
    if (stroke.empty()) return false;
    auto points = equally_spaced(stroke);
    vec3 low = points[0].at, high = low, mean(0);
    for (auto& p : points) {
        if (!channels.depth) p.at.z = 0;
        low = glm::min(low, p.at);
        high = glm::max(high, p.at);
        mean += p.at / static_cast<double>(dot_points);
    }
    const vec3 extent = high - low;
    const double size = std::max({extent.x, extent.y, channels.depth ? extent.z : 0.0});
    if (!(size > 0) || !std::isfinite(size)) return false;
    double squares = 0;
    for (std::size_t i = 0; i < dot_points; ++i) {
        const vec3 at = (points[i].at - mean) / size;
        const std::array<double, 4> values{at.x, at.y, channels.depth ? at.z : 0.0,
                                           channels.force ? points[i].force : 0.0};
        for (std::size_t c = 0; c < 4; ++c) {
            vector[4 * i + c] = values[c];
            squares += values[c] * values[c];
        }
    }
    if (!(squares > 0) || !std::isfinite(squares)) return false;
    const double by = 1 / std::sqrt(squares);
    for (double& v : vector) v *= by;
    return true;
}

double dot_product(const StrokeVector& a, const StrokeVector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace thaum::gesture
