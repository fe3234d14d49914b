#include "gesture/variations.h"

#include <algorithm>

#include "core/maths.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t waves = 3;
// Number of points to which a stroke is thinned out before it is varied, because more are not needed.
constexpr std::size_t thinned_points = 160;

/// A smooth random function on [0, 1]: a sum of sines, the slowest with half a period.
struct Waves {
    std::array<double, waves> height{}, phase{};

    double at(double u) const {
        double sum = 0;
        for (std::size_t k = 0; k < waves; ++k)
            sum += height[k] * det::sin(pi * static_cast<double>(k + 1) * u + phase[k]);
        return sum;
    }
};

Waves random_waves(Random& random, double deviation) {
    Waves w;
    for (std::size_t k = 0; k < waves; ++k) {
        w.height[k] = deviation * normal(random);
        w.phase[k] = random.uniform(0, 2 * pi);
    }
    return w;
}

std::vector<StrokePoint> thinned(Points stroke) {
    const std::size_t stride = (stroke.size() + thinned_points - 1) / thinned_points;
    std::vector<StrokePoint> points;
    for (std::size_t i = 0; i < stroke.size(); i += std::max<std::size_t>(stride, 1))
        points.push_back(stroke[i]);
    return points;
}

std::vector<double> lengths_of(Points points) {
    std::vector<double> length(points.size());
    for (std::size_t i = 1; i < points.size(); ++i)
        length[i] = length[i - 1] + glm::length(points[i].at - points[i - 1].at);
    return length;
}

double size_of(Points points) {
    if (points.empty()) return 0;
    vec3 low = points[0].at, high = low;
    for (const auto& p : points) {
        low = glm::min(low, p.at);
        high = glm::max(high, p.at);
    }
    return glm::length(high - low) / 2;
}

/// The part of a stroke between two shares of its arc length.
std::vector<StrokePoint> part_of(Points points, double from, double to) {
    const auto length = lengths_of(points);
    std::vector<StrokePoint> part;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double u = length.back() > 0 ? length[i] / length.back() : 0;
        if (u >= from && u <= to) part.push_back(points[i]);
    }
    return part;
}

Points stroke_of(const Gesture& gesture, Random& random) {
    return gesture.strokes[random.below(gesture.strokes.size())];
}

/// The beginning of one gesture followed by the end of another.
std::vector<StrokePoint> chain(const Gesture& a, const Gesture& b, Random& random) {
    const double end_of_a = random.uniform(0.3, 0.7), start_of_b = random.uniform(0.3, 0.7);
    auto result = part_of(thinned(stroke_of(a, random)), 0, end_of_a);
    const auto tail = part_of(thinned(stroke_of(b, random)), start_of_b, 1);
    if (result.empty() || tail.empty()) return result.empty() ? tail : result;
    const double by = size_of(tail) > 0 ? size_of(result) / size_of(tail) : 1;
    const auto end = result.back(), begin = tail.front();
    for (const auto& p : tail)
        result.push_back({end.t + (p.t - begin.t), end.at + by * (p.at - begin.at), p.force});
    return result;
}

/// A sequence of smooth turns in the plane of x and y.
std::vector<StrokePoint> wander(double size, Random& random) {
    constexpr int points = 96;
    const double turns = random.uniform(2, 8);
    const auto turn = random_waves(random, turns), speed = random_waves(random, 0.4),
               force = random_waves(random, 0.3);
    const double start = random.uniform(0, 2 * pi), curl = 4 * normal(random);
    std::vector<StrokePoint> result;
    vec3 at(0);
    for (int i = 0; i < points; ++i) {
        const double u = i / static_cast<double>(points);
        result.push_back({2 * u, at, 1 + force.at(u)});
        const double angle = start + curl * u + turn.at(u), step = 4 * size / points * det::exp(speed.at(u));
        at += step * vec3(det::cos(angle), det::sin(angle), 0);
    }
    return result;
}

}  // namespace

double normal(Random& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
}

std::vector<StrokePoint> variation_of(Points stroke, Random& random, const VariationSettings& settings) {
    auto points = thinned(stroke);
    const double cut = settings.ends;
    const double from = std::abs(cut * normal(random));
    const double to = 1 - std::abs(cut * normal(random));
    points = part_of(points, from, to);
    if (points.size() < 2) return thinned(stroke);
    const auto length = lengths_of(points);
    const double bend = settings.bend * size_of(points), tilt = settings.tilt * normal(random);
    const std::array<Waves, 3> bends{random_waves(random, bend), random_waves(random, bend),
                                     random_waves(random, bend)};
    const auto hurry = random_waves(random, settings.hurry), press = random_waves(random, settings.force / 2);
    const double level = det::exp(settings.force * normal(random));
    vec3 stretch(0);
    for (int k = 0; k < 3; ++k) stretch[k] = det::exp(settings.stretch * normal(random));
    const bool flat = std::all_of(points.begin(), points.end(), [](const auto& p) { return p.at.z == 0; });
    const vec3 origin = points[0].at;
    double t = points[0].t, before = t;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto& p = points[i];
        const double u = length.back() > 0 ? length[i] / length.back() : 0;
        t += std::max(0.0, p.t - before) * det::exp(hurry.at(u));
        before = p.t;
        const vec3 at = stretch * (p.at - origin);
        p.at =
            rotation({0, 0, 1}, tilt) * at + vec3(bends[0].at(u), bends[1].at(u), flat ? 0 : bends[2].at(u));
        p.force = level * p.force * det::exp(press.at(u));
        p.t = t;
    }
    return points;
}

std::vector<StrokePoint> scribble(std::span<const Gesture> gestures, Random& random) {
    const std::size_t a = random.below(gestures.size());
    if (gestures.size() > 1 && random.uniform() < 0.5) {
        const std::size_t b = (a + 1 + random.below(gestures.size() - 1)) % gestures.size();
        return chain(gestures[a], gestures[b], random);
    }
    return wander(size_of(stroke_of(gestures[a], random)), random);
}

}  // namespace thaum::gesture
