#include "gesture/prefix.h"

#include <algorithm>

#include "core/random.h"
#include "core/text.h"
#include "gesture/detail/path.h"
#include "gesture/detail/speed_force.h"
#include "gesture/detail/twins.h"
#include "gesture/detail/vectors.h"
#include "gesture/recogniser.h"
#include "gesture/variations.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t prefix_starts = 8;              // points at which a closed stroke may begin
constexpr std::size_t verified_prefixes = 2 * lanes;  // beginnings that are compared elastically
/// Smallest elastic distance that counts; smaller ones are raised to it. Strokes of another hand than the one
/// that was recorded come no nearer, so the calibration has no samples below it.
constexpr float min_counted = 0.02F;
constexpr float no_match = 1, very_far_off = 1e30F;
/// Weight of lengths if the recorded strokes do not tell how well lengths agree: the distance added if one
/// length is e times the other. Half or twice the length then adds 0.03, about as much as two strokes of one
/// hand differ. Durations add nothing in this case.
constexpr float length_weight = 0.06F;
/// Largest distance that a difference of lengths, or of durations, adds. Lengths that differ fourfold or more
/// already belong to different gestures.
constexpr float max_for_difference = 0.12F;
/// Constants of the weight with which a difference of lengths (or durations) enters the distance. If the
/// logarithms of the lengths of the strokes recorded for one gesture have the variance v, the weight is
/// agreement_weight / (v + min_variance).
constexpr double agreement_weight = 0.002, min_variance = 0.003;
/// Trust in the weight of lengths (or durations) that holds without recorded strokes: it counts like a weight
/// from recorded strokes with this number of degrees of freedom.
constexpr double prior_freedom = 4;
/// A recorded stroke counts e times less than the nearest one of its gesture if its distance from the stroke
/// so far is larger by this number.
constexpr float hand_scatter = 0.03F;
/// Smallest duration that counts (s); shorter ones, and that of a stroke without times, are raised to it.
constexpr float min_seconds = 0.001F;
/// Converts an elastic distance of two shapes to a mean squared distance of their points, the measure by
/// which beginnings are chosen. The differences of lengths and durations, which are given as elastic
/// distances, are multiplied by it.
constexpr float squares_to_elastic = 4;
constexpr std::size_t synthetic_strokes = 30, scribble_every = 10;
constexpr std::array synthetic_shares{0.25, 0.5, 0.75, 1.0};
/// Largest share of a recorded stroke's length that counts as drawn. A stroke that is longer than the
/// recorded one is no better evidence.
constexpr float max_share = 1;
/// Largest logarithm of the ratio of a stroke's distances from two gestures that counts against the farther
/// gesture.
constexpr double max_margin_against = 2;

float log_length_of(const Shape& shape) {
    return static_cast<float>(det::log(static_cast<double>(shape.length)));
}

float log_seconds_of(const Shape& shape) {
    return static_cast<float>(det::log(static_cast<double>(std::max(shape.seconds, min_seconds))));
}

float cost_of(float difference, float weight) {
    return std::min(weight * difference * difference, max_for_difference);
}

Floats8 costs_of(Floats8 differences, float weight) {
    const Floats8 costs = weight * differences * differences;
    const Floats8 most = max_for_difference + Floats8{};
    return costs < most ? costs : most;
}

/// Variance of the logarithms of lengths (or durations) among the strokes of one gesture, over all gestures.
class Scatter {
public:
    void add(double value) {
        ++count_;
        sum_ += value;
        squares_ += value * value;
    }
    /// Ends a gesture: the values added since the last call are those of its strokes.
    void end_gesture() {
        if (count_ > 1) {
            deviations_ += std::max(squares_ - sum_ * sum_ / count_, 0.0);
            freedom_ += count_ - 1;
        }
        count_ = sum_ = squares_ = 0;
    }
    double variance() const { return deviations_ / std::max(freedom_, 1.0); }
    /// Factor that turns a difference of logarithms of lengths (or durations) into a distance. `prior`: the
    /// factor without any recorded strokes.
    float weight(float prior) const {
        const double known = freedom_ * agreement_weight / (variance() + min_variance);
        const double sum = known + prior_freedom * static_cast<double>(prior);
        return static_cast<float>(sum / (freedom_ + prior_freedom));
    }

private:
    double count_ = 0, sum_ = 0, squares_ = 0, deviations_ = 0, freedom_ = 0;
};

std::vector<StrokePoint> drawn_backwards(Points stroke) {
    std::vector<StrokePoint> back(stroke.rbegin(), stroke.rend());
    for (auto& p : back) p.t = stroke.back().t - p.t;
    return back;
}

/// The closed stroke that begins at the point with the index `first`.
std::vector<StrokePoint> begun_at(Points stroke, std::size_t first) {
    std::vector<StrokePoint> turned(stroke.begin() + static_cast<std::ptrdiff_t>(first), stroke.end());
    const double so_far = stroke.back().t - stroke.front().t;
    for (std::size_t i = 0; i < first; ++i) {
        turned.push_back(stroke[i]);
        turned.back().t += so_far;
    }
    return turned;
}

}  // namespace

Points beginning_of(Points stroke, double share) {
    if (share >= 1) return stroke;
    const double wanted = share * path_length(stroke);
    double length = 0;
    std::size_t last = 1;
    for (; last < stroke.size() && length < wanted; ++last)
        length += glm::distance(stroke[last - 1].at, stroke[last].at);
    return stroke.first(std::min(last, stroke.size()));
}

bool PrefixReader::add_stroke(Points stroke, const GestureOptions& options, PrefixSpace& space) {
    const bool solid = channels_.depth && !options.planar;
    Beginnings b{.gesture = static_cast<std::uint32_t>(names_.size() - 1),
                 .stroke = static_cast<std::uint32_t>(gesture_of_stroke_.size() - 1),
                 .channels = solid ? solid_channels : planar_channels};
    std::array<Shape, lanes> shapes{};
    std::array<const float*, lanes> values{};
    for (std::size_t k = lanes; k-- > 0;) {
        // A beginning with too few points has no shape, and is replaced by the next longer one.
        if (!make_shape(beginning_of(stroke, prefix_shares[k]), {solid, channels_.force}, space.points,
                        shapes[k])) {
            if (k + 1 == lanes) return false;
            shapes[k] = shapes[k + 1];
        }
        values[k] = shapes[k].values.data();
        for (std::size_t i = 0; i < shape_points * b.channels; ++i)
            b.square[k] += values[k][i] * values[k][i];
        b.log_length[k] = log_length_of(shapes[k]);
        b.log_seconds[k] = log_seconds_of(shapes[k]);
        b.force[k] = shapes[k].force;
    }
    set_lanes(b.values, b.channels, values);
    (solid ? needs_solid_ : needs_flat_) = true;
    beginnings_.push_back(b);
    return true;
}

Expected<void> PrefixReader::add(const Gesture& gesture, PrefixSpace& space) {
    if (gesture.strokes.empty()) return fail(text("gesture '", gesture.name, "' has no stroke"));
    names_.push_back(gesture.name);
    for (const auto& stroke : gesture.strokes) {
        gesture_of_stroke_.push_back(static_cast<std::uint32_t>(names_.size() - 1));
        std::vector<std::vector<StrokePoint>> ways{stroke};
        if (!gesture.options.direction_sensitive) ways.push_back(drawn_backwards(stroke));
        for (const auto& way : ways) {
            const std::size_t turns = gesture.options.closed ? std::min(prefix_starts, way.size()) : 1;
            for (std::size_t k = 0; k < turns; ++k) {
                if (!add_stroke(begun_at(way, k * way.size() / turns), gesture.options, space))
                    return fail(text("gesture '", gesture.name, "': a stroke without a shape"));
                beginnings_.back().as_drawn = &way == ways.data() && k == 0;
            }
        }
    }
    if (beginnings_.size() > max_templates)
        return fail(text("more than ", max_templates, " strokes; leave some out"));
    return {};
}

/// Weights of lengths and durations, from how well those of the whole recorded strokes of each gesture agree.
PrefixReader::Weights PrefixReader::weights_of_agreement() const {
    Scatter lengths, seconds;
    for (std::size_t b = 0; b < beginnings_.size(); ++b) {
        const auto& one = beginnings_[b];
        if (one.as_drawn) {
            lengths.add(static_cast<double>(one.log_length[lanes - 1]));
            seconds.add(static_cast<double>(one.log_seconds[lanes - 1]));
        }
        if (b + 1 < beginnings_.size() && beginnings_[b + 1].gesture == one.gesture) continue;
        for (auto* scatter : {&lengths, &seconds}) scatter->end_gesture();
    }
    static const auto no_time = static_cast<float>(det::log(static_cast<double>(min_seconds)));
    const bool has_times = std::any_of(beginnings_.begin(), beginnings_.end(), [](const Beginnings& one) {
        return one.log_seconds[lanes - 1] > no_time;
    });
    return {lengths.weight(length_weight), has_times ? seconds.weight(0) : 0};
}

/// Finds the nearest beginning of each recorded stroke by the dot product of shapes, and sorts the nearest of
/// these beginnings to the front. Returns how many are sorted; these are to be compared elastically.
std::size_t PrefixReader::choose(const Shape& shape, PrefixSpace& space) const {
    const float length = log_length_of(shape), seconds = log_seconds_of(shape);
    std::size_t count = 0;
    for (std::uint32_t b = 0; b < beginnings_.size(); ++b) {
        const auto& one = beginnings_[b];
        if (one.channels != shape.channels) continue;
        Floats8 dot{};
        for (std::size_t i = 0; i < shape_points * one.channels; ++i)
            dot += shape.values[i] * load<Floats8>(&one.values.values[i * lanes]);
        const Floats8 squares =
            (load<Floats8>(one.square.data()) - 2.0F * dot) / static_cast<float>(shape_points);
        const Floats8 differences =
            costs_of(length - load<Floats8>(one.log_length.data()), weights_.length) +
            costs_of(seconds - load<Floats8>(one.log_seconds.data()), weights_.seconds);
        const Floats8 distances = squares + squares_to_elastic * differences;
        PrefixSpace::Candidate nearest{.distance = very_far_off, .place = b};
        for (std::uint32_t k = 0; k < lanes; ++k) {
            if (distances[k] < nearest.distance) nearest = {distances[k], b, k};
        }
        space.candidates[count++] = nearest;
    }
    const auto begin = space.candidates.begin();
    const auto best = static_cast<std::ptrdiff_t>(std::min(verified_prefixes, count));
    std::partial_sort(begin, begin + best, begin + static_cast<std::ptrdiff_t>(count),
                      [](const auto& a, const auto& b) {
                          return a.distance != b.distance ? a.distance < b.distance : a.place < b.place;
                      });
    return static_cast<std::size_t>(best);
}

/// Compares up to eight beginnings of recorded strokes with the shape elastically: those of space.candidates
/// from the index `first` to before `end`.
void PrefixReader::verify(const Shape& shape, std::size_t first, std::size_t end, PrefixSpace& space) const {
    std::array<const float*, lanes> values{};
    const std::size_t count = std::min(lanes, end - first);
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto& c = space.candidates[first + std::min(k, count - 1)];
        const auto& from = beginnings_[c.place].values.values;
        for (std::size_t i = 0; i < shape_points * shape.channels; ++i)
            space.chosen[k][i] = from[i * lanes + c.lane];
        values[k] = space.chosen[k].data();
    }
    set_lanes(space.eight, shape.channels, values);
    const auto distances = elastic_distances(shape, space.eight);
    const float length = log_length_of(shape), seconds = log_seconds_of(shape);
    for (std::size_t k = 0; k < count; ++k) {
        const auto& c = space.candidates[first + k];
        const auto& from = beginnings_[c.place];
        auto& nearest = space.nearest[from.gesture];
        const float distance = distances[k] + cost_of(length - from.log_length[c.lane], weights_.length) +
                               cost_of(seconds - from.log_seconds[c.lane], weights_.seconds);
        auto& of_stroke = space.stroke_distance[from.stroke];
        of_stroke = std::min(of_stroke, distance);
        if (distance < nearest.distance)
            nearest = {distance, length - from.log_length[lanes - 1], from.force[c.lane]};
    }
}

/// The distance of a gesture is that of its nearest recorded stroke. Raises it if its other strokes are
/// farther: a gesture is likelier if all its recorded strokes are near than if only one is.
void PrefixReader::join_strokes(PrefixSpace& space) const {
    std::size_t s = 0;
    for (std::uint32_t g = 0; g < names_.size(); ++g) {
        auto& least = space.nearest[g].distance;
        double near = 0, count = 0;
        for (; s < gesture_of_stroke_.size() && gesture_of_stroke_[s] == g; ++s, ++count) {
            const float distance = space.stroke_distance[s];
            if (distance < no_match) near += det::exp(static_cast<double>((least - distance) / hand_scatter));
        }
        if (near > 0) least += hand_scatter * static_cast<float>(det::log(count / near));
    }
}

bool PrefixReader::are_twins(std::uint32_t a, std::uint32_t b) const {
    return std::find(twins_[a].begin(), twins_[a].end(), b) != twins_[a].end();
}

/// Probability, 0 to 1, that a gesture is meant rather than one of its twins (gestures of its shape with
/// another force), by the mean force of the stroke so far.
double PrefixReader::share_by_force(std::uint32_t gesture, const PrefixSpace& space) const {
    constexpr float tiny = 1e-30F;  // stands for a force of 0, whose logarithm is not finite
    const auto oddness = [&](std::uint32_t g) {
        const float usual = std::max(space.nearest[g].force, tiny);
        return force_oddness(static_cast<double>(space.force), static_cast<double>(usual));
    };
    const double odd = oddness(gesture);
    double sum = 1;
    for (const auto twin : twins_[gesture]) {
        if (space.nearest[twin].distance < no_match) sum += det::exp(std::min(odd - oddness(twin), 40.0));
    }
    return 1 / sum;
}

/// Largest probability that a gesture at this distance can have, given the distances of all others. Of two
/// gestures that are equally near, each has a half. The more gestures there are, the more are near by chance,
/// so every other gesture lowers the probability.
double PrefixReader::share_by_distance(std::uint32_t gesture, float distance,
                                       const PrefixSpace& space) const {
    double sum = 1;
    for (std::uint32_t g = 0; g < space.nearest.size(); ++g) {
        if (g == gesture || !(space.nearest[g].distance < no_match) || are_twins(gesture, g)) continue;
        const auto ratio = static_cast<double>(distance / std::max(space.nearest[g].distance, min_counted));
        const double square = ratio * ratio;
        sum += square * square * ratio;  // the power 5 was chosen on the letters and the game's spells
    }
    return 1 / sum;
}

/// Evidence and probability of a gesture, after a stroke was compared. The gesture need not be the nearest.
LikelyGesture PrefixReader::likelihood_of(std::uint32_t gesture, const PrefixSpace& space) const {
    static const auto min_log_share = static_cast<float>(det::log(prefix_shares[0]));
    const auto& own = space.nearest[gesture];
    float other = no_match;
    for (std::uint32_t g = 0; g < space.nearest.size(); ++g) {
        if (g != gesture && !are_twins(gesture, g)) other = std::min(other, space.nearest[g].distance);
    }
    const float distance = std::max(own.distance, min_counted);
    const double share = det::exp(static_cast<double>(own.log_share));
    LikelyGesture likely{.gesture = gesture};
    likely.evidence = evidence_of(distance, other, std::min(static_cast<float>(share), max_share));
    if (other < distance) {
        const double nearer = det::log(static_cast<double>(std::max(other, min_counted) / distance));
        likely.evidence.margin = std::max(nearer, -max_margin_against);
    }
    if (own.log_share < min_log_share || !(own.distance < no_match)) return likely;
    likely.probability =
        std::min(calibration_.probability(likely.evidence), share_by_distance(gesture, distance, space));
    if (!twins_[gesture].empty()) likely.probability *= share_by_force(gesture, space);
    return likely;
}

LikelyGesture PrefixReader::likeliest(const PrefixSpace& space) const {
    float least = no_match;
    std::uint32_t nearest = LikelyGesture::none;
    for (std::uint32_t g = 0; g < space.nearest.size(); ++g) {
        if (space.nearest[g].distance >= least) continue;
        least = space.nearest[g].distance;
        nearest = g;
    }
    if (nearest == LikelyGesture::none) return {};
    auto likely = likelihood_of(nearest, space);
    for (const auto twin : twins_[nearest]) {
        if (!(space.nearest[twin].distance < no_match)) continue;
        if (share_by_force(twin, space) > share_by_force(likely.gesture, space))
            likely = likelihood_of(twin, space);
    }
    return likely;
}

LikelyGesture PrefixReader::read(Points stroke, PrefixSpace& space) const {
    space.candidates.resize(beginnings_.size());
    space.nearest.assign(names_.size(), {no_match, 0});
    space.stroke_distance.assign(gesture_of_stroke_.size(), no_match);
    for (const bool solid : {true, false}) {
        if (!(solid ? needs_solid_ : needs_flat_)) continue;
        if (!make_shape(stroke, {solid, channels_.force}, space.points, space.shape)) continue;
        space.force = space.shape.force;
        const std::size_t end = choose(space.shape, space);
        for (std::size_t first = 0; first < end; first += lanes) verify(space.shape, first, end, space);
    }
    join_strokes(space);
    return likeliest(space);
}

std::uint32_t PrefixReader::tell(Points stroke, std::uint32_t told, PrefixSpace& space) const {
    const auto likely = read(stroke, space);
    if (likely.probability >= likely_enough) return likely.gesture;
    if (told >= gestures() || likely.gesture == LikelyGesture::none) return LikelyGesture::none;
    return likelihood_of(told, space).probability >= likely_still ? told : LikelyGesture::none;
}

/// Takes over from the recogniser of whole strokes which gestures are twins, that is, differ in force alone.
void PrefixReader::take_twins(const Recogniser& recogniser) {
    twins_.resize(recogniser.gestures());
    for (std::uint32_t g = 0; g < twins_.size(); ++g) {
        for (std::uint32_t other = 0; other < twins_.size(); ++other) {
            if (recogniser.are_twins(g, other)) twins_[g].push_back(other);
        }
    }
}

void PrefixReader::calibrate(std::span<const Gesture> gestures, std::uint64_t seed, PrefixSpace& space) {
    Random random = random_stream(seed, 0x9e58);
    std::vector<LabelledEvidence> samples;
    const auto keep = [&](Points stroke, std::uint32_t meant) {
        for (const double share : synthetic_shares) {
            const auto likely = read(beginning_of(stroke, share), space);
            if (likely.gesture == LikelyGesture::none) continue;
            const bool is_meant = likely.gesture == meant || are_twins(likely.gesture, meant);
            samples.push_back({likely.evidence, is_meant, 1});
        }
    };
    for (std::uint32_t g = 0; g < gestures.size(); ++g) {
        const auto& strokes = gestures[g].strokes;
        for (std::size_t v = 0; v < synthetic_strokes; ++v) {
            keep(variation_of(strokes[v % strokes.size()], random), g);
            if (v % scribble_every == 0) keep(scribble(gestures, random), LikelyGesture::none);
        }
    }
    calibration_.weights = fit_weights(samples);
}

Expected<PrefixReader> PrefixReader::make(std::span<const Gesture> gestures, const PrefixSettings& settings) {
    if (gestures.empty()) return fail("no gesture to recognise; record one");
    if (gestures.size() > max_gestures)
        return fail(text(gestures.size(), " gestures, more than ", max_gestures, "; leave some out"));
    const auto recogniser = Recogniser::make(gestures, {.channels = settings.channels, .calibrate = false});
    if (!recogniser) return recogniser.error();
    PrefixReader reader;
    reader.channels_ = settings.channels;
    reader.take_twins(*recogniser);
    PrefixSpace space;
    for (const auto& gesture : gestures) {
        if (auto added = reader.add(gesture, space); !added) return added.error();
    }
    reader.weights_ = reader.weights_of_agreement();
    if (force_follows_speed(gestures)) reader.weights_.seconds = 0;
    if (settings.calibrate) reader.calibrate(gestures, settings.seed, space);
    return reader;
}

}  // namespace thaum::gesture
