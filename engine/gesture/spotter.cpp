#include "gesture/spotter.h"

#include <algorithm>
#include <cmath>

namespace thaum::gesture {
namespace {

constexpr double points_of_shortest = 40;  // number of points of the shortest window (a part of the motion
                                           // that is compared with templates)
// Number of scans while the hand moves by the length of the shortest window. A scan compares the parts of the
// motion (windows) of all lengths that end at the present point with the templates.
constexpr double ends_of_shortest = 14;
/// Largest overlap of two reported gestures, as a share of the shorter one.
constexpr double max_overlap = 0.15;
// Strokes of some gestures scatter more than those of others, so the score (the smaller, the surer) takes
// into account the usual distance between strokes of a gesture. With this usual distance the score is neither
// raised nor lowered.
constexpr double plain_usual = 0.06;
// Least dot product of a window (part of the motion) with a template for which both are compared further, by
// elastic distance; as a share of the template's product with itself.
constexpr float min_match = 0.5F;
constexpr std::size_t kept_points = max_points / 2;
// Largest score (the smaller, the surer) of a window (part of the motion) that gets a close look, the search
// for a stroke's exact ends.
constexpr float max_looked_at = 0.25F;
// While windows (parts of the motion) are being compared, one tick out of this many is used for a close look
// (search for a stroke's exact ends), if one is due.
constexpr std::uint32_t look_every = 4;

// Besides the distance, two factors of the score separate gestures from other motion: rest before and after
// the stroke, and its duration. On strokes of users who drew no template, the logarithm of the distance
// counts about 15 times as much as the logarithm of the motion before and after, and 10 times as much as the
// squared logarithm of the duration.
//
// Time before and after a stroke for which the score takes motion into account (s).
constexpr float time_before = 0.3F, time_after = 0.2F;
constexpr double rest_power =
    0.07;  // exponent of the speeds before and after the stroke, each divided by the stroke's own speed
constexpr double duration_weight = 0.1;
// Limits of the speeds before and after a stroke, divided by the stroke's own: for a hand at rest, and for a
// hand that moves fast.
constexpr float min_motion = 0.1F, max_motion = 3;
// Shortest duration by which a path is divided to give a speed, so that nothing is divided by zero (s).
constexpr float shortest_time = 0.05F;

/// Overlap of two spans of time, as a share of the shorter one.
double overlap(double start_a, double end_a, double start_b, double end_b) {
    const double shorter = std::min(end_a - start_a, end_b - start_b);
    const double both = std::min(end_a, end_b) - std::max(start_a, start_b);
    return shorter > 0 ? both / shorter : 0;
}

}  // namespace

// ---- choice among candidates -----------------------------------------------------------------------------

std::optional<Candidate> CandidateChoice::report() {
    start_ = waiting_->start;
    end_ = waiting_->end;
    const auto result = waiting_;
    waiting_.reset();
    return result;
}

std::optional<Candidate> CandidateChoice::add(const Candidate& c, double now) {
    if (!(c.score <= max_score_)) return std::nullopt;
    if (overlap(c.start, c.end, start_, end_) > max_overlap) return std::nullopt;
    std::optional<Candidate> reported;
    if (waiting_ && overlap(c.start, c.end, waiting_->start, waiting_->end) > max_overlap) {
        if (!(c.score < waiting_->score)) return std::nullopt;
    } else if (waiting_) {
        reported = report();
        if (overlap(c.start, c.end, start_, end_) > max_overlap) return reported;
    }
    waiting_ = c;
    due_ = now + wait_;
    return reported;
}

std::optional<Candidate> CandidateChoice::at(double now) {
    if (!waiting_ || now < due_) return std::nullopt;
    return report();
}

// ---- the spotter -----------------------------------------------------------------------------------------

Spotter::Spotter(const Recogniser& recogniser, const SpotterSettings& settings)
    : recogniser_(recogniser),
      settings_(settings),
      choice_(settings.wait, settings.max_score),
      space_(std::make_unique<RecogniserSpace>()),
      spacing_(static_cast<float>(static_cast<double>(recogniser.shortest()) / settings.length_range /
                                  points_of_shortest)),
      end_step_(static_cast<float>(static_cast<double>(recogniser.shortest()) / settings.length_range /
                                   ends_of_shortest)),
      windows_(max_lengths * kinds()),
      held_(recogniser.gestures()),
      seen_(recogniser.gestures(), Candidate{.start = -1e300, .end = -1e300}),
      look_(recogniser) {
    candidates_.reserve(max_gestures);
    for (const float usual : recogniser.calibration().usual)
        factors_.push_back(static_cast<float>(det::pow(plain_usual / static_cast<double>(usual), 1.0 / 3)));
}

void Spotter::restart() {
    choice_ = CandidateChoice(settings_.wait, settings_.max_score);
    points_.count = 0;
    origin_ = {};
    latest_ = {};
    now_ = -1e300;
    last_end_ = next_length_ = 0;
    window_count_ = verified_ = pair_count_ = end_ = 0;
    scanning_ = verifying_ = false;
    candidates_.clear();
    std::fill(held_.begin(), held_.end(), Held{});
    std::fill(seen_.begin(), seen_.end(), Candidate{.start = -1e300, .end = -1e300});
    look_.stop();
    looked_at_ = {};
    dropped_ = ticks_ = 0;
    skipped_ = ends_ = 0;
}

/// Makes room for new points by dropping the older half. Arc lengths and times become relative to the first
/// point that is left.
void Spotter::make_room() {
    const std::size_t first = points_.count - kept_points;
    const float length = points_.length[first], t = points_.t[first];
    const auto keep = [&](auto& column) {
        std::copy(column.begin() + static_cast<std::ptrdiff_t>(first),
                  column.begin() + static_cast<std::ptrdiff_t>(points_.count), column.begin());
    };
    keep(points_.points);
    keep(points_.t);
    keep(points_.length);
    for (std::size_t i = 0; i < kept_points; ++i) {
        points_.length[i] -= length;
        points_.t[i] -= t;
    }
    origin_.t += static_cast<double>(t);
    last_end_ -= length;
    points_.count = kept_points;
    dropped_ += first;
    scanning_ = verifying_ = false;  // the indices of the points in use are no longer valid
    if (look_.is_active() && !held_[looked_at_.what.gesture].waiting) {
        // The candidate whose exact ends are being searched waits again, with its new indices.
        held_[looked_at_.what.gesture] = looked_at_;
        held_[looked_at_.what.gesture].waiting = true;
    }
    look_.stop();
    for (auto& h : held_) h.waiting = h.waiting && h.first >= dropped_;
}

/// Appends the point if the hand has moved by at least one step (spacing_) since the last point.
void Spotter::append(const StrokePoint& p) {
    float length = 0;
    if (points_.count == 0) {
        origin_ = p;
    } else {
        const double step = glm::length(p.at - latest_);
        if (!(step >= static_cast<double>(spacing_))) return;
        length = points_.length[points_.count - 1] + static_cast<float>(step);
    }
    if (points_.count == max_points) {
        make_room();
        length = points_.length[points_.count - 1] + static_cast<float>(glm::length(p.at - latest_));
    }
    const std::size_t k = points_.count++;
    points_.points[k] = {static_cast<float>(p.force), static_cast<float>(p.at.x - origin_.at.x),
                         static_cast<float>(p.at.y - origin_.at.y),
                         static_cast<float>(p.at.z - origin_.at.z)};
    points_.t[k] = static_cast<float>(p.t - origin_.t);
    points_.length[k] = length;
    latest_ = p.at;
    if (length - last_end_ >= end_step_) {
        ++ends_;
        if (scanning_ || verifying_) ++skipped_;
        start_scan();
    }
}

void Spotter::start_scan() {
    end_ = points_.count - 1;
    last_end_ = points_.length[end_];
    next_length_ = recogniser_.shortest() / static_cast<float>(settings_.length_range);
    window_count_ = pair_count_ = verified_ = 0;
    scanning_ = true;
    verifying_ = false;
}

void Spotter::keep(const Pair& pair) {
    if (pair_count_ == max_pairs && !(pair.score > pairs_[max_pairs - 1].score)) return;
    std::size_t at = pair_count_ < max_pairs ? pair_count_++ : max_pairs - 1;
    for (; at > 0 && pair.score > pairs_[at - 1].score; --at) pairs_[at] = pairs_[at - 1];
    pairs_[at] = pair;
}

/// Compares the next longer part of the motion (window) that ends at the present point with the templates,
/// once with depth and once without if templates need both. Ends the scan when windows become too long.
void Spotter::look_at_length() {
    const float from = last_end_ - next_length_;
    const auto* begin = points_.length.data();
    const auto first = static_cast<std::size_t>(std::lower_bound(begin, begin + end_, from) - begin);
    const bool too_long = from < 0 || window_count_ + kinds() > max_lengths * kinds() ||
                          next_length_ > recogniser_.longest() * static_cast<float>(settings_.length_range) ||
                          static_cast<double>(points_.t[end_] - points_.t[first]) > settings_.longest;
    if (too_long) {
        scanning_ = false;
        verifying_ = pair_count_ > 0;
        sort_by_channels();
        return;
    }
    next_length_ *= static_cast<float>(settings_.window_ratio);
    if (recogniser_.needs_solid()) look_at_window(first, true);
    if (recogniser_.needs_flat()) look_at_window(first, false);
}

/// Makes the shape of the part of the motion from `first` to the present end (a window), and finds by dot
/// product the templates that it resembles.
void Spotter::look_at_window(std::size_t first, bool depth) {
    auto& window = windows_[window_count_];
    const Channels channels{depth, recogniser_.counts_force()};
    if (!make_shape(points_, first, end_, channels, window.shape)) return;
    window.first = first;
    window.start = origin_.t + static_cast<double>(points_.t[first]);
    window.end = origin_.t + static_cast<double>(points_.t[end_]);
    // Templates that are means of strokes are left out: a mean is smoother than any of its strokes, and
    // motion that is no gesture is nearer to it.
    const Recogniser::Limits limits{.length_range = static_cast<float>(settings_.length_range),
                                    .means = false};
    recogniser_.choose(window.shape, limits, 4, *space_);
    for (std::size_t k = 0; k < space_->survivor_count_; ++k) {
        const auto& match = space_->survivors_[k];
        const float score = match.score / recogniser_.templates_[match.place].self;
        if (score > min_match) keep({match, static_cast<std::uint32_t>(window_count_), score});
    }
    ++window_count_;
}

/// Sorts the pairs of window (part of the motion) and template: those with depth first. Pairs that are
/// compared together must have the same channels, the numbers that describe a point.
void Spotter::sort_by_channels() {
    std::array<Pair, max_pairs> flat;
    std::size_t solid_count = 0, flat_count = 0;
    for (std::size_t k = 0; k < pair_count_; ++k) {
        const bool depth = windows_[pairs_[k].window].shape.channels == solid_channels;
        (depth ? pairs_[solid_count++] : flat[flat_count++]) = pairs_[k];
    }
    std::copy_n(flat.begin(), flat_count, pairs_.begin() + static_cast<std::ptrdiff_t>(solid_count));
}

/// Computes the elastic distances of the next eight pairs of window (part of the motion) and template.
void Spotter::verify() {
    if (verified_ == 0) std::fill_n(best_.begin(), recogniser_.gestures(), Best{});
    const auto channels_of = [&](std::size_t k) { return windows_[pairs_[k].window].shape.channels; };
    const std::size_t channels = channels_of(verified_), most = std::min(lanes, pair_count_ - verified_);
    std::size_t count = 1;
    while (count < most && channels_of(verified_ + count) == channels) ++count;
    auto& space = *space_;
    std::array<const float*, lanes> templates, strokes;
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto& pair = pairs_[verified_ + std::min(k, count - 1)];
        templates[k] = recogniser_.lane_values(pair.match, k, space);
        strokes[k] = windows_[pair.window].shape.values.data();
    }
    set_lanes(space.eight_, channels, templates);
    set_lanes(space.strokes_, channels, strokes);
    const auto distances = elastic_distances(space.strokes_, space.eight_, channels);
    for (std::size_t k = 0; k < count; ++k) {
        const auto& pair = pairs_[verified_ + k];
        auto& best = best_[recogniser_.templates_[pair.match.place].gesture];
        if (!best.found || distances[k] < best.distance) best = {distances[k], pair.window, true, pair.match};
    }
    verified_ += count;
    if (verified_ == pair_count_) {
        verifying_ = false;
        collect();
    }
}

/// For each gesture, makes a candidate of the window (part of the motion) that resembles it most in this
/// scan. The candidate's runner-up is the nearest other gesture, but not one of the same shape with another
/// force.
void Spotter::collect() {
    for (std::uint32_t g = 0; g < recogniser_.gestures(); ++g) {
        if (!best_[g].found) continue;
        const auto& window = windows_[best_[g].window];
        Candidate c{.gesture = g,
                    .distance = best_[g].distance,
                    .score = factors_[g] * best_[g].distance,
                    .start = window.start,
                    .end = window.end};
        c.mean_force = static_cast<double>(window.shape.force);
        for (std::uint32_t other = 0; other < recogniser_.gestures(); ++other) {
            if (other == g || !best_[other].found) continue;
            if (c.runner_up != Recognition::none && best_[other].distance >= c.runner_up_distance) continue;
            if (recogniser_.are_twins(c.gesture, other)) continue;
            c.runner_up = other;
            c.runner_up_distance = best_[other].distance;
        }
        hold(c, window.first, best_[g].match);
    }
}

/// Keeps a window (part of the motion) for a close look (a search for the stroke's exact ends), if it is the
/// best of the gesture's windows that overlap.
void Spotter::hold(const Candidate& c, std::size_t first, const RecogniserSpace::Survivor& match) {
    if (!(c.score <= max_looked_at)) return;
    auto& held = held_[c.gesture];
    const auto beats = [&](const Candidate& other) {
        return c.score < other.score || overlap(c.start, c.end, other.start, other.end) <= max_overlap;
    };
    if (!beats(seen_[c.gesture])) return;
    if (held.waiting && !beats(held.what)) return;
    // Once the held window (part of the motion) has waited long enough for its close look, only a window with
    // a smaller score, which is a better one, replaces it.
    if (held.waiting && now_ >= held.due && c.score >= held.what.score) return;
    held = {true, c, dropped_ + first, dropped_ + end_, match, now_ + settings_.hold};
}

/// Begins the close look (search for a stroke's exact ends) at the best window (part of the motion) that has
/// waited long enough. Returns false if there is none.
bool Spotter::begin_look() {
    Held* best = nullptr;
    for (auto& h : held_) {
        if (h.waiting && now_ >= h.due && (best == nullptr || h.what.score < best->what.score)) best = &h;
    }
    if (best == nullptr) return false;
    best->waiting = false;
    looked_at_ = *best;
    seen_[best->what.gesture] = best->what;
    look_.begin(static_cast<std::size_t>(best->first - dropped_),
                static_cast<std::size_t>(best->last - dropped_), best->match);
    return true;
}

/// Does one step of the present close look (search for a stroke's exact ends), or of a new one. Returns false
/// if no window (part of the motion) is due for one.
bool Spotter::look_closer() {
    if (!look_.is_active() && !begin_look()) return false;
    if (look_.step(points_)) end_look();
    return true;
}

/// Factor of a candidate's score (the smaller, the surer) for the motion before and after the stroke. It is
/// less than 1 if the hand rested there, as it does beside a gesture more often than within other motion.
double Spotter::quiet_factor(std::size_t first, std::size_t last) const {
    const auto &length = points_.length, &t = points_.t;
    const float speed = (length[last] - length[first]) / std::max(t[last] - t[first], shortest_time);
    const auto last_until = [&](float time) {  // the last point that is not later than `time`
        const auto end = t.begin() + static_cast<std::ptrdiff_t>(points_.count);
        const auto after = static_cast<std::size_t>(std::upper_bound(t.begin(), end, time) - t.begin());
        return after > 0 ? after - 1 : 0;
    };
    const auto share = [&](float way, float time) {
        return static_cast<double>(std::clamp(way / (time * speed), min_motion, max_motion));
    };
    const float way_before = length[first] - length[last_until(t[first] - time_before)];
    const float passed = static_cast<float>(now_ - origin_.t) - t[last];
    const float seconds_after = std::clamp(passed, shortest_time, time_after);
    const float way_after = length[last_until(t[last] + seconds_after)] - length[last];
    return det::pow(share(way_before, time_before) * share(way_after, seconds_after), rest_power);
}

/// Makes a candidate, with its final score, from a close look (search for a stroke's exact ends) that has
/// ended.
void Spotter::end_look() {
    const std::size_t first = look_.first(), last = look_.last();
    auto c = looked_at_.what;
    c.start = origin_.t + static_cast<double>(points_.t[first]);
    c.end = origin_.t + static_cast<double>(points_.t[last]);
    const auto usual = static_cast<double>(recogniser_.usual_seconds(c.gesture));
    const auto shortest = static_cast<double>(shortest_time);
    const double duration = usual > 0 ? det::log(std::max(c.end - c.start, shortest) / usual) : 0;
    c.score = static_cast<float>(static_cast<double>(factors_[c.gesture] * look_.distance()) *
                                 quiet_factor(first, last) * det::exp(duration_weight * duration * duration));
    c.gesture = recogniser_.twin_by_force(c.gesture, c.mean_force);
    candidates_.push_back(c);
}

std::span<const Candidate> Spotter::scan(const StrokePoint& point) {
    candidates_.clear();
    if (!is_finite(point) || point.t < now_) return {};
    now_ = point.t;
    append(point);
    if (verifying_) {
        verify();
    } else if ((scanning_ && ++ticks_ % look_every != 0) || !look_closer()) {
        for (std::size_t i = 0; i < settings_.windows_per_tick && scanning_; i += kinds()) look_at_length();
    }
    return candidates_;
}

std::optional<Spotted> Spotter::feed(const StrokePoint& point) {
    std::optional<Candidate> reported;
    for (const auto& candidate : scan(point)) {
        if (const auto r = choice_.add(candidate, now_)) reported = r;
    }
    if (!reported) reported = choice_.at(now_);
    if (!reported) return std::nullopt;
    return Spotted{
        *reported,
        recogniser_.probability_of(reported->gesture, reported->distance,
                                   reported->runner_up != Recognition::none, reported->runner_up_distance),
        recogniser_.force_class(reported->gesture, reported->mean_force), now_};
}

}  // namespace thaum::gesture
