#include "game/casting/free_reading.h"

#include <algorithm>

#include "game/context/match_context.h"

namespace thaum::game::inline casting {
namespace {

using gesture::StrokePoint;

/// Number of points at rest after which the end of the windows (parts of the motion that are tried as a
/// gesture) is fixed. Later motion does not belong to the gesture.
constexpr std::uint32_t points_to_end = 4;
/// A window is a part of the motion that is tried as a gesture. Number of windows read per gameplay tick, arc
/// length of the shortest window (m), and ratio of each window's length to the next shorter one.
constexpr std::uint32_t windows_per_tick = 9;
constexpr double first_length = 0.02, window_ratio = 1.05;
/// Number of points just before a window (the part that is tried as a gesture) that give the speed before the
/// gesture (0.1 s).
constexpr std::size_t points_before = 12;
// A window (part of the motion) gets a score, as in gesture/spotter.cpp. It is the logarithm of the window's
// distance from the recorded gesture, plus two terms with these weights: the logarithm of (speed before the
// window / speed in it), and the squared logarithm of (duration / usual duration).
constexpr double pace_weight = 0.14, duration_weight = 0.1;
// Limits of the ratio of the hand's speed before a window (part of the motion) to the speed in it. Lower
// ratios come from a hand at rest, higher ones from a hand in fast motion.
constexpr double min_pace = 0.1, max_pace = 3;
/// Radius within which a hand counts as stopped, as a share of the gesture's size. Tremor stays within it.
constexpr double stop_way = 0.03;

/// The motion that may contain a gesture. Its points lie in memory that is used again for each reading.
struct FreeMotion {
    std::span<const StrokePoint> points;
    std::array<double, free_points> way{};  ///< arc length from each point to the last one (m)
};

fvec3 place_of(const FreeHand& hand, std::uint32_t number) {
    return hand.points[(hand.first + number) % free_points];
}

/// Position smoothed over three points. Without smoothing, the single counts of a mouse would look like turns
/// of the path, and a figure drawn by a program would show no slowing down at its corners.
vec3 smooth_place(std::span<const vec3> places, std::size_t number) {
    const vec3 before = places[number > 0 ? number - 1 : number];
    const vec3 after = places[number + 1 < places.size() ? number + 1 : number];
    return 0.25 * (before + 2.0 * places[number] + after);
}

FreeMotion motion_of(const CastingRules& rules, const FreeHand& hand, ReadingSpace& space) {
    const auto rested = hand.rested - std::min(hand.rested, points_to_end);
    const auto last = hand.count - 1 - std::min(rested, hand.count - 1);
    const auto first = hand.count - std::min(hand.count, std::max(hand.moving, rested + 1));
    FreeMotion motion;
    const std::size_t count = last - first + 1;
    std::array<vec3, free_points> all;
    const auto places = std::span(all).first(count);
    for (auto i = first; i <= last; ++i) places[i - first] = vec3(place_of(hand, i));
    spread_jumps(places, gameplay_dt);
    auto& points = space.stroke;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 at = smooth_place(places, i);
        const double way = i > 0 ? glm::distance(at, points[i - 1].at) : 0;
        points[i] = {static_cast<double>(i) * gameplay_dt, at, rules.viscosity * way / gameplay_dt};
    }
    motion.points = std::span(points).first(count);
    for (std::size_t i = count - 1; i-- > 0;)
        motion.way[i] = motion.way[i + 1] + glm::distance(points[i].at, points[i + 1].at);
    return motion;
}

/// Index of the first point of a window (part of the motion up to its end); 0 if the window is longer than
/// the motion. Windows with higher numbers are longer.
std::size_t begin_of(const FreeMotion& motion, std::uint32_t window) {
    const double length = first_length * det::pow(window_ratio, window);
    const auto ways = std::span(motion.way).first(motion.points.size());
    const auto longer = std::partition_point(ways.begin(), ways.end(), [&](double w) { return w >= length; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(longer - ways.begin() - 1, 0));
}

/// Width or height of a stroke, whichever is larger (m).
double size_of(gesture::Points stroke) {
    vec3 least = stroke[0].at, most = least;
    for (const auto& p : stroke) {
        least = glm::min(least, p.at);
        most = glm::max(most, p.at);
    }
    return std::max({most.x - least.x, most.y - least.y, most.z - least.z});
}

/// Speed of the hand just before the window (part of the motion) that begins at this point, relative to the
/// speed in the window.
double pace_before(const FreeMotion& motion, std::size_t begin, double lasts) {
    const std::size_t before = begin - std::min(begin, points_before);
    if (before == begin) return 0;
    const double way = motion.way[before] - motion.way[begin];
    const double time = static_cast<double>(begin - before) * gameplay_dt;
    return way * lasts / (time * motion.way[begin]);
}

/// Longest time for which the hand stops within a stroke of this size (s). Stops in the first and last tenth
/// of the stroke do not count, since a hand is slow there.
double longest_stop(gesture::Points stroke, double size) {
    const std::size_t end = stroke.size() / 10;
    std::size_t longest = 0;
    for (std::size_t first = end, last = end; last + end < stroke.size(); ++last) {
        while (glm::distance(stroke[first].at, stroke[last].at) > stop_way * size) ++first;
        if (first > end) longest = std::max(longest, last - first);
    }
    return static_cast<double>(longest) * gameplay_dt;
}

/// Whether the hand stops within a stroke for so long that the stroke is rather two movements, such as one to
/// a place and one back.
bool is_broken(const CastingRules& rules, gesture::Points stroke, double size, double lasts) {
    const double stop = longest_stop(stroke, size);
    return stop >= rules.free_stop && stop >= rules.free_stop_share * lasts;
}

/// Probability that a gesture needs in order to cast its spell. Less suffices if the hand was slow before the
/// gesture, but not for a small closed gesture. That may start anywhere, so a stray loop has many chances to
/// match one.
double needed_for(const CastingRules& rules, const gesture::GestureOptions& options, double pace,
                  double way) {
    const bool is_loop = options.closed && way < rules.free_loop;
    const bool suffices = pace < rules.free_quiet_pace && !is_loop;
    return suffices ? rules.free_quiet_probability : rules.free_least_probability;
}

void read_window(const CastingRules& rules, const GestureSet& gestures, const FreeMotion& motion,
                 std::size_t begin, ReadingSpace& space, FreeHand& hand) {
    const auto& recogniser = gestures.motion_recogniser();
    const auto stroke = motion.points.subspan(begin);
    const auto found = recogniser.recognise_part(stroke, space.recogniser);
    if (found.gesture == gesture::Recognition::none) return;
    const double lasts = std::max(found.end - found.start, gameplay_dt);
    const double pace = pace_before(motion, begin, lasts);
    const double usual = static_cast<double>(recogniser.usual_seconds(found.gesture));
    const double duration = usual > 0 ? det::log(lasts / usual) : 0;
    FreeWindow window{
        .probability = found.even_probability,
        .needed = needed_for(rules, gestures.gestures()[found.gesture].options, pace, motion.way[begin]),
        .force = found.mean_force,
        .gesture = found.gesture};
    window.score = found.evidence.distance - found.evidence.usual +
                   pace_weight * det::log(std::clamp(pace, min_pace, max_pace)) +
                   duration_weight * duration * duration;
    const double size = size_of(stroke);
    if (size < rules.free_smallest) window.miss = Miss::too_small;
    if (lasts < rules.free_shortest) window.miss = Miss::too_fast;
    auto& best = window.miss == Miss::none ? hand.best : hand.odd;
    const bool is_unclear = !found.accepted || pace > rules.free_most_pace;
    if (is_unclear || is_broken(rules, stroke, size, lasts)) window.miss = Miss::unclear;
    if (best.gesture == no_gesture || window.score < best.score) best = window;
}

}  // namespace

void forget_motion(FreeHand& hand) { hand.count = hand.moving = hand.rested = 0; }

void add_place(const CastingRules& rules, vec3 place, Tick tick, FreeHand& hand) {
    if (hand.count == free_points) {
        hand.first = (hand.first + 1) % free_points;
        --hand.count;
    }
    hand.points[(hand.first + hand.count) % free_points] = fvec3(place);
    ++hand.count;
    hand.newest = tick;
    const bool moved = hand.count == 1 || glm::distance(place, hand.rest_place) > rules.free_rest_way;
    if (moved) hand.rest_place = place;
    hand.rested = moved ? 0 : hand.rested + 1;
    hand.moving = std::min(hand.moving + 1, hand.count);
    if (hand.rested * gameplay_period >= rules.free_pause) hand.moving = 1;
}

bool read_windows(const CastingRules& rules, const GestureSet& gestures, ReadingSpace& space,
                  FreeHand& hand) {
    const auto whole_rest = std::max<Tick>(rules.free_rest / gameplay_period, points_to_end);
    if (hand.rested < points_to_end || hand.rested > whole_rest) return false;
    if (hand.rested == points_to_end) {
        hand.windows = 0;
        hand.best = hand.odd = {.gesture = no_gesture};
    }
    const auto motion = motion_of(rules, hand, space);
    std::uint32_t read = 0;
    while (read < windows_per_tick) {
        const auto begin = begin_of(motion, hand.windows);
        const bool same = hand.windows > 0 && begin == begin_of(motion, hand.windows - 1);
        // The last window (part of the motion) was already the whole motion, so longer ones would be the
        // same.
        if (same && begin == 0) break;
        ++hand.windows;
        if (same) continue;
        read_window(rules, gestures, motion, begin, space, hand);
        ++read;
    }
    return hand.rested == whole_rest;
}

}  // namespace thaum::game::inline casting
