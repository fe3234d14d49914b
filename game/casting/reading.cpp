#include "game/casting/reading.h"

#include <algorithm>
#include <cmath>

#include "game/context/match_context.h"

namespace thaum::game {
namespace {

using gesture::Points;
using gesture::StrokePoint;

/// Turns from which on a stroke is read turn by turn.
constexpr double several_turns = 1.5;

vec3 place_of(const DrawnPoint& p) { return {p.x, p.y, p.z}; }

StrokePoint point_of(const DrawnStroke& stroke, std::uint32_t i) {
    const auto& p = stroke.points[i];
    return {i * (stroke.every * gameplay_dt), place_of(p), p.force};
}

Points put_points(const DrawnStroke& stroke, ReadingSpace& space) {
    for (std::uint32_t i = 0; i < stroke.count; ++i) space.stroke[i] = point_of(stroke, i);
    return Points(space.stroke).first(stroke.count);
}

vec3 middle_of(Points stroke) {
    double length = 0;
    vec3 sum{};
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const double step = glm::distance(stroke[i - 1].at, stroke[i].at);
        length += step;
        sum += step * (stroke[i - 1].at + stroke[i].at) / 2.0;
    }
    return length > 0 ? sum / length : vec3(0);
}

/// Clockwise angle round the middle from one point to the next (rad), -pi to pi.
double turn_between(vec3 middle, vec3 from, vec3 to) {
    const vec3 a = from - middle, b = to - middle;
    const double across = a.x * b.y - a.y * b.x, along = a.x * b.x + a.y * b.y;
    return across == 0 && along == 0 ? 0 : -det::atan2(across, along);
}

double turns_of(Points stroke) {
    const vec3 middle = middle_of(stroke);
    double angle = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i)
        angle += turn_between(middle, stroke[i - 1].at, stroke[i].at);
    return angle / (2 * pi);
}

/// Reading of all turns of a stroke with about `turns` of them. Nothing is meant unless all turns are one gesture.
gesture::Recognition read_turns(const gesture::Recogniser& recogniser, Points stroke, double turns,
                                gesture::RecogniserSpace& space) {
    const vec3 middle = middle_of(stroke);
    const double whole = std::round(std::abs(turns));
    const double each = 2 * pi * std::abs(turns) / whole;
    gesture::Recognition worst{.probability = 1, .accepted = true};
    double angle = 0;
    std::size_t first = 0, done = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        angle += turn_between(middle, stroke[i - 1].at, stroke[i].at);
        const bool last = i + 1 == stroke.size();
        const bool turn_is_done =
            static_cast<double>(done + 1) < whole && std::abs(angle) >= each * static_cast<double>(done + 1);
        if (!last && !turn_is_done) continue;
        const auto one = recogniser.recognise(stroke.subspan(first, i - first + 1), space);
        if (!one.accepted || (done > 0 && one.gesture != worst.gesture)) return {};
        if (one.probability <= worst.probability) worst = one;
        ++done;
        first = i;
    }
    return worst;
}

}  // namespace

std::vector<StrokePoint> points_of(const DrawnStroke& stroke) {
    std::vector<StrokePoint> points(stroke.count);
    for (std::uint32_t i = 0; i < stroke.count; ++i) points[i] = point_of(stroke, i);
    return points;
}

double mean_force_of(const DrawnStroke& stroke) {
    double length = 0, sum = 0;
    for (std::uint32_t i = 1; i < stroke.count; ++i) {
        const auto &a = stroke.points[i - 1], &b = stroke.points[i];
        const double step = glm::distance(place_of(a), place_of(b));
        length += step;
        sum += step * (static_cast<double>(a.force) + static_cast<double>(b.force)) / 2;
    }
    return length > 0 ? sum / length : 0;
}

Slip slip_of(const CastingRules& rules, const DrawnStroke& trace) {
    constexpr double least_move = 0.0015;  // m; a hand that only presses the button moves less
    double length = 0;
    for (std::uint32_t i = 1; i < trace.count; ++i) {
        length += glm::distance(place_of(trace.points[i - 1]), place_of(trace.points[i]));
    }
    const Tick lasts = Tick{trace.count} * trace.every * gameplay_period;
    if (length >= rules.smallest) return lasts < rules.shortest ? Slip::too_quick : Slip::none;
    return lasts < rules.shortest || length < least_move ? Slip::tap : Slip::too_small;
}

bool is_too_fast(const CastingRules& rules, double force) { return force >= 2 * rules.harsh_from; }

Reading read_drawn(const GestureSet& gestures, const DrawnStroke& trace, ReadingSpace& space) {
    const auto& recogniser = gestures.recogniser();
    const auto stroke = put_points(trace, space);
    auto found = recogniser.recognise(stroke, space.recogniser);
    const double turns = turns_of(stroke);
    if (std::abs(turns) >= several_turns) {
        const auto turn = read_turns(recogniser, stroke, turns, space.recogniser);
        if (turn.accepted && (!found.accepted || turn.probability > found.probability)) found = turn;
    }
    Reading reading{.stroke = {.force = mean_force_of(trace)}, .nearest = found.gesture};
    reading.stroke.probability = found.probability;
    if (!found.accepted) return reading;
    reading.stroke.gesture = found.gesture;
    if (gestures.gestures()[found.gesture].options.closed) reading.stroke.turns = turns;
    return reading;
}

}  // namespace thaum::game
