// unit/gesture_shapes.h: strokes with a known shape for the tests of gestures.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "core/maths.h"
#include "gesture/elastic.h"
#include "gesture/gesture.h"
#include "gesture/variations.h"

namespace thaum::gesture {

using Course = std::vector<StrokePoint>;

/// The elastic distance (by dynamic time warping) of two shapes, as elastic.h computes it for one template,
/// but in plain loops.
template <std::size_t points>
float elastic_distance(const float* a, const float* b, std::size_t channels) {
    constexpr float far = 1e30F;  // more than any sum of costs
    std::array<float, points + 2> rows[2];
    rows[0].fill(far);
    rows[1].fill(far);
    rows[0][0] = 0;
    for (std::size_t i = 1; i <= points; ++i) {
        auto& row = rows[i % 2];
        const auto& above = rows[(i + 1) % 2];
        const std::size_t low = i > warp_band ? i - warp_band : 1, high = std::min(points, i + warp_band);
        row[low - 1] = far;
        row[high + 1] = far;
        for (std::size_t j = low; j <= high; ++j) {
            float s = 0;
            for (std::size_t c = 0; c < channels; ++c) {
                const float d = a[(i - 1) * channels + c] - b[(j - 1) * channels + c];
                s += d * d;
            }
            row[j] = s / (1 + robustness * s) + std::min(above[j - 1], std::min(above[j], row[j - 1]));
        }
        rows[0][0] = far;
    }
    return rows[points % 2][points] / static_cast<float>(points);
}

inline float elastic_distance(const Shape& a, const Shape& b) {
    return elastic_distance<shape_points>(a.values.data(), b.values.data(), a.channels);
}

/// The curve over u from 0 to 1, drawn in one second with a constant force.
inline Course drawn(const std::function<vec3(double)>& curve, std::size_t points = 100, double force = 0) {
    Course result;
    for (std::size_t i = 0; i < points; ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(points - 1);
        result.push_back({u, curve(u), force});
    }
    return result;
}

/// A circle in the x-y plane that starts at the given angle (rad); `turns` below zero goes clockwise.
inline Course circle(double start = 0, double turns = 1, std::size_t points = 100) {
    return drawn(
        [=](double u) {
            return vec3(det::cos(start + 2 * pi * turns * u), det::sin(start + 2 * pi * turns * u), 0);
        },
        points);
}

inline Course vee(std::size_t points = 100) {
    return drawn([](double u) { return vec3(u, std::abs(2 * u - 1), 0); }, points);
}

inline Course ess(std::size_t points = 100) {
    return drawn([](double u) { return vec3(det::sin(2 * pi * u), 1 - 2 * u, 0); }, points);
}

inline Course dash(std::size_t points = 100) {
    return drawn([](double u) { return vec3(u, u, 0); }, points);
}

inline Gesture gesture_of(std::string name, std::vector<Course> strokes, GestureOptions options = {}) {
    return {.name = std::move(name), .options = options, .strokes = std::move(strokes)};
}

/// The gestures of paper 000: circle, V and S.
inline std::vector<Gesture> three_gestures() {
    return {gesture_of("circle", {circle()}), gesture_of("vee", {vee()}), gesture_of("ess", {ess()})};
}

/// The stroke moved, scaled, and drawn at another speed.
inline Course moved(Course stroke, vec3 by, double scale, double speed = 1) {
    for (auto& p : stroke) {
        p.at = scale * p.at + by;
        p.t /= speed;
    }
    return stroke;
}

/// A careful user: variations of strokes two thirds as large as those with which the recogniser's thresholds
/// are set.
inline constexpr VariationSettings careful{
    .tilt = 0.1, .stretch = 0.12, .bend = 0.035, .hurry = 0.25, .ends = 0.025};

}  // namespace thaum::gesture
