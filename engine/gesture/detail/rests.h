// gesture/detail/rests.h: leaves out the time for which the hand rests before, within and after a stroke.
//
// A hand that rests trembles, so its points do not coincide. A rest is a run of points that lasts longer than
// `longest_halt` and stays within 2 % of the stroke's extent of one place; a single point outside is noise.
// The time that a slow stroke spends in a corner is shorter. Of a rest before the stroke, only the last point
// is kept; of a rest after the stroke, only the first point; of a rest within the stroke, both ends, moved to
// `longest_halt` apart. So a stroke with rests has nearly the points that it would have without them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/maths.h"

namespace thaum::gesture {

/// Longest time near one place that still belongs to the stroke (s). A longer one is a rest of the hand.
inline constexpr double longest_halt = 0.2;
/// Distance from the middle of a run of points within which they count as a rest of the hand, as a share of
/// the largest of the stroke's width, height and depth.
inline constexpr double rest_reach = 0.02;

/// Part of a stroke between two rests, during which the hand moves.
struct MovingPart {
    std::size_t first{}, last{};  ///< indices of the part's first and last point
    double earlier{};             ///< removed duration of the rests before the part (s)
};

/// The parts of a stroke between its rests. If there are more rests than fit in `items`, the remaining ones
/// stay in the last part.
struct MovingParts {
    static constexpr std::size_t most = 32;
    std::array<MovingPart, most> items{};
    std::size_t count{};

    std::size_t points() const {
        std::size_t sum = 0;
        for (std::size_t k = 0; k < count; ++k) sum += items[k].last - items[k].first + 1;
        return sum;
    }
};

/// A run of points that stay near one place.
template <class Vec>
struct Run {
    std::size_t first{}, last{};  ///< indices of the run's first and last point
    Vec middle{};                 ///< middle of the run's points
};

/// Finds rests in a stroke. Stroke must have `size()`, the number of its points, `place(i)`, their positions
/// as vectors, and `t(i)`, their times (s). `may_rest(i)` is a cheap test whether a rest may begin at a
/// point, so that most points need no search: it may be true without a rest, but if it is false there is
/// none.
template <class Stroke>
class RunFinder {
public:
    using Vec = decltype(std::declval<Stroke>().place(0));
    using Real = typename Vec::value_type;
    using Rest = Run<Vec>;

    RunFinder(const Stroke& stroke, double extent)
        : stroke_(stroke), square_(static_cast<Real>(rest_reach * rest_reach * extent * extent)) {}

    /// The next rest at or after the point `from`, joined with the rests that follow it at the same place.
    std::optional<Rest> next_rest(std::size_t from) const {
        std::optional<Rest> rest;
        while (from < stroke_.size()) {
            if (!rest && !stroke_.may_rest(from)) {
                ++from;
                continue;
            }
            const auto run = run_from(from);
            from = run.last + 1;
            const bool rests = seconds(run.first, run.last) > longest_halt;
            if (rest && (rests ? !is_same(*rest, run) : seconds(rest->last, run.last) > longest_halt)) break;
            if (rest && rests) rest->last = run.last;
            if (!rest && rests) rest = run;
        }
        return rest;
    }

    /// Shortens a rest by the approach to its place and by the departure from it, and extends it by all
    /// neighbouring points (from `begin` on) in which the hand only trembles. Extending is needed because a
    /// run that began in the approach may have ended too early, at a point of tremor far from its middle.
    Rest without_motion(Rest rest, std::size_t begin) const {
        // Distance from the middle of the rest below which a point counts as tremor instead of motion, as a
        // multiple of the root mean square distance of its points. Points that differ only by rounding are no
        // motion either.
        constexpr auto tremor_reach = static_cast<Real>(2.5), rounding = static_cast<Real>(1e-9);
        const auto points = static_cast<Real>(rest.last - rest.first + 1);
        Vec sum(0);
        for (std::size_t i = rest.first; i <= rest.last; ++i)
            sum += stroke_.place(i) - stroke_.place(rest.first);
        rest.middle = stroke_.place(rest.first) + sum / points;
        Real squares = 0;
        for (std::size_t i = rest.first; i <= rest.last; ++i) squares += square_from(rest.middle, i);
        const Real near = tremor_reach * tremor_reach * squares / points + rounding * square_;
        while (rest.first < rest.last && square_from(rest.middle, rest.first) > near) ++rest.first;
        while (rest.first < rest.last && square_from(rest.middle, rest.last) > near) --rest.last;
        const auto trembles = [&](std::size_t i) { return square_from(rest.middle, i) <= near; };
        // A single point farther away, between points that tremble, may be noise, so the rest goes on beyond
        // it.
        const std::size_t end = stroke_.size();
        while (rest.first > begin &&
               (trembles(rest.first - 1) || (rest.first > begin + 1 && trembles(rest.first - 2))))
            --rest.first;
        while (rest.last + 1 < end &&
               (trembles(rest.last + 1) || (rest.last + 2 < end && trembles(rest.last + 2))))
            ++rest.last;
        return rest;
    }

    double seconds(std::size_t first, std::size_t last) const { return stroke_.t(last) - stroke_.t(first); }

private:
    Rest run_from(std::size_t first) const {
        constexpr int points_of_middle = 16;  // most points of a run whose mean counts as its middle
        Rest run{first, first, stroke_.place(first)};
        for (int count = 1; run.last + 1 < stroke_.size();) {
            const std::size_t next = run.last + 1;
            if (square_from(run.middle, next) < square_) {
                run.last = next;
                if (count == points_of_middle) continue;
                run.middle += (stroke_.place(next) - run.middle) / static_cast<Real>(++count);
            } else if (next + 1 == stroke_.size() || square_from(run.middle, next + 1) < square_) {
                run.last = next;  // one point too far from the middle, amid near ones, is noise
            } else {
                break;
            }
        }
        return run;
    }

    /// True if the rest `next` begins soon after `rest` and near its place, so that both count as one rest.
    bool is_same(const Rest& rest, const Rest& next) const {
        const Vec way = rest.middle - next.middle;
        return seconds(rest.last, next.first) < longest_halt && glm::dot(way, way) < 4 * square_;
    }

    Real square_from(Vec middle, std::size_t i) const {
        const Vec way = stroke_.place(i) - middle;
        return glm::dot(way, way);
    }

    const Stroke& stroke_;
    Real square_;  ///< square of the distance from the middle within which the hand rests
};

/// The moving parts of a stroke; one part with all points if the stroke has no rest, or consists of rests
/// only.
template <class Stroke>
MovingParts moving_parts(const Stroke& stroke, double extent) {
    const std::size_t last = stroke.size() - 1;
    MovingParts parts{.items = {}, .count = 1};
    parts.items[0].last = last;
    if (!(extent > 0) || !std::isfinite(extent)) return parts;
    const RunFinder<Stroke> runs(stroke, extent);
    for (std::size_t from = 0; from < last && parts.count < MovingParts::most;) {
        const auto found = runs.next_rest(from);
        if (!found || (found->first == 0 && found->last == last)) break;
        auto& part = parts.items[parts.count - 1];
        const auto rest = runs.without_motion(*found, part.first);
        from = std::max(found->last, rest.last) + 1;
        if (found->first == 0 || rest.first == 0) {
            part.first = rest.last;
            continue;
        }
        part.last = rest.first;
        if (found->last == last || rest.last == last) break;
        const double left_out = std::max(runs.seconds(rest.first, rest.last) - longest_halt, 0.0);
        parts.items[parts.count++] = {rest.last, last, part.earlier + left_out};
    }
    return parts;
}

}  // namespace thaum::gesture
