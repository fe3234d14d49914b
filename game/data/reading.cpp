#include "game/data/reading.h"

#include <algorithm>
#include <cmath>

#include "game/data/periods.h"

namespace thaum::game::inline data {
namespace {

using gesture::Points;
using gesture::StrokePoint;

/// Number of turns of a closed gesture, such as a circle, above which a stroke is read turn by turn.
constexpr double several_turns = 1.5;

vec3 place_of(const DrawnPoint& p) { return {p.x, p.y, p.z}; }

/// Calls the function with number, position, time and force of each point of a stroke. Before that, each jump
/// of a position that the device reports seldom is spread over the rest before it (spread_jumps). The force
/// at the jump is then shared among these points.
template <class Take>
void each_point(const DrawnStroke& stroke, Take&& take) {
    const double apart = stroke.every * gameplay_dt;
    std::array<vec3, max_drawn_points> places;
    for (std::uint32_t i = 0; i < stroke.count; ++i) places[i] = place_of(stroke.points[i]);
    spread_jumps(std::span(places).first(stroke.count), apart);
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
        // A jump consists of the points that spread_jumps has moved, and of the point after them, at which
        // the device reported the new position.
        const auto moved = [&](std::uint32_t k) { return places[k] != place_of(stroke.points[k]); };
        std::uint32_t begin = i, end = i;
        while (end + 1 < stroke.count && moved(end)) ++end;
        while (begin > 0 && moved(begin - 1)) --begin;
        const double force = stroke.points[end].force;
        take(i, StrokePoint{i * apart, places[i], end > begin ? force / (end - begin + 1) : force});
    }
}

/// Mean force along a path whose points are added one by one.
class ForceMean {
public:
    void add(const StrokePoint& p) {
        const double step = begun_ ? glm::distance(before_.at, p.at) : 0;
        length_ += step;
        sum_ += step * (before_.force + p.force) / 2;
        before_ = p;
        begun_ = true;
    }
    double force() const { return length_ > 0 ? sum_ / length_ : 0; }

private:
    StrokePoint before_{};
    double length_ = 0, sum_ = 0;
    bool begun_ = false;
};

double mean_force_along(Points stroke) {
    ForceMean mean;
    for (const auto& p : stroke) mean.add(p);
    return mean.force();
}

Points put_points(const DrawnStroke& stroke, ReadingSpace& space) {
    each_point(stroke, [&](std::uint32_t i, const StrokePoint& p) { space.stroke[i] = p; });
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

/// Clockwise angle about the middle from one point to the next (rad), -pi to pi.
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

/// Reading of a stroke with about `turns` turns. Accepted only if every turn is the same gesture.
gesture::Recognition read_turns(const gesture::Recogniser& recogniser, Points stroke, double turns,
                                gesture::RecogniserSpace& space) {
    const vec3 middle = middle_of(stroke);
    const double whole = std::round(std::abs(turns));
    const double each = 2 * pi * std::abs(turns) / whole;
    gesture::Recognition worst{.even_probability = 1, .accepted = true};
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
        if (one.even_probability <= worst.even_probability) worst = one;
        ++done;
        first = i;
    }
    return worst;
}

}  // namespace

void spread_jumps(std::span<vec3> places, double apart) {
    // Minimum length of a jump of the reported position; the steps of a slow hand are shorter (m)
    constexpr double min_jump = 0.0015;
    constexpr double longest_rest = 0.064;  // longest rest of a position that the next jump includes (s)
    std::size_t rest = 0;  // index of the first point of the rest, in which the device reports no motion
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i] == places[rest]) continue;
        const auto steps = static_cast<double>(i - rest);
        const vec3 jump = places[i] - places[rest];
        const bool spreads = steps * apart < longest_rest && glm::length(jump) >= min_jump;
        for (std::size_t k = rest + 1; spreads && k < i; ++k)
            places[k] = places[rest] + jump * (static_cast<double>(k - rest) / steps);
        rest = i;
    }
}

std::vector<StrokePoint> points_of(const DrawnStroke& stroke) {
    std::vector<StrokePoint> points(stroke.count);
    each_point(stroke, [&](std::uint32_t i, const StrokePoint& p) { points[i] = p; });
    return points;
}

double mean_force_of(const DrawnStroke& stroke) {
    ForceMean mean;
    each_point(stroke, [&](std::uint32_t, const StrokePoint& p) { mean.add(p); });
    return mean.force();
}

Slip slip_of(const CastingRules& rules, const DrawnStroke& trace) {
    // Arc length above which the hand did more than press the button (m)
    constexpr double min_move = 0.0015;
    double length = 0;
    for (std::uint32_t i = 1; i < trace.count; ++i) {
        length += glm::distance(place_of(trace.points[i - 1]), place_of(trace.points[i]));
    }
    const Tick lasts = Tick{trace.count} * trace.every * gameplay_period;
    if (length >= rules.smallest) return lasts < rules.shortest ? Slip::too_quick : Slip::none;
    return lasts < rules.shortest || length < min_move ? Slip::tap : Slip::too_small;
}

bool is_too_fast(const CastingRules& rules, double force) { return force >= 2 * rules.harsh_from; }

gesture::Recognition recognise_drawn(const gesture::Recogniser& recogniser, Points stroke,
                                     gesture::RecogniserSpace& space) {
    auto found = recogniser.recognise(stroke, space);
    const double turns = turns_of(stroke);
    if (std::abs(turns) >= several_turns) {
        const auto turn = read_turns(recogniser, stroke, turns, space);
        const bool surer = !found.accepted || turn.even_probability > found.even_probability;
        if (turn.accepted && surer) found = turn;
    }
    return found;
}

Reading read_drawn(const GestureSet& gestures, const DrawnStroke& trace, ReadingSpace& space) {
    const auto stroke = put_points(trace, space);
    const auto found = recognise_drawn(gestures.recogniser(), stroke, space.recogniser);
    Reading reading{.stroke = {.force = mean_force_along(stroke)}, .nearest = found.gesture};
    // An unrecognised stroke may well be no gesture at all. Its probability takes that into account, and is
    // not shown to players.
    reading.stroke.probability = found.accepted ? found.probability : found.even_probability;
    if (!found.accepted) return reading;
    reading.stroke.gesture = found.gesture;
    if (gestures.gestures()[found.gesture].options.closed) reading.stroke.turns = turns_of(stroke);
    return reading;
}

int whole_percent(double probability) {
    const auto whole = static_cast<int>(std::lround(100 * probability));
    return probability < 1 && whole == 100 ? 99 : whole;
}

}  // namespace thaum::game::inline data
