#include "gesture/recogniser.h"

#include <algorithm>

#include "gesture/detail/twins.h"
#include "gesture/detail/vectors.h"

namespace thaum::gesture {
namespace {

constexpr float lowest_score = -1e30F;
constexpr float farthest_possible = 1e9F;  ///< distance of a gesture if none of its templates was compared
/// Weight of the second nearest recorded stroke in the distance of a gesture, as a share of that of the
/// nearest.
constexpr float second_weight = 0.5F;
// Twins (gestures of one shape with different forces) are told apart by odds. The ratio of the stroke's
// distances from two twins enters the odds with the power twin_distance_power. twin_common_distance is added
// to both distances before, because the ratio of two small distances is a matter of chance.
constexpr double twin_distance_power = 4;
constexpr float twin_common_distance = 0.1F;

/// Sums of the eight lanes of four vectors, neighbours first.
Floats4 sums_of(Floats8 p, Floats8 q, Floats8 r, Floats8 s) {
    const auto neighbours = [](Floats8 a, Floats8 b) {
        return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
               __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
    };
    const Floats8 sum = neighbours(neighbours(p, q), neighbours(r, s));
    return __builtin_shufflevector(sum, sum, 0, 1, 2, 3) + __builtin_shufflevector(sum, sum, 4, 5, 6, 7);
}

/// Dot products of an array with four others, all of `count` numbers, a multiple of eight. Four products at
/// once are enough to keep the processor's adders busy.
Floats4 dots(const float* a, const std::array<const float*, 4>& four, std::size_t count) {
    const auto [p, q, r, s] = four;
    Floats8 even_p{}, even_q{}, even_r{}, even_s{}, odd_p{}, odd_q{}, odd_r{}, odd_s{};
    std::size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const Floats8 x = load<Floats8>(a + i), y = load<Floats8>(a + i + 8);
        even_p += x * load<Floats8>(p + i);
        even_q += x * load<Floats8>(q + i);
        even_r += x * load<Floats8>(r + i);
        even_s += x * load<Floats8>(s + i);
        odd_p += y * load<Floats8>(p + i + 8);
        odd_q += y * load<Floats8>(q + i + 8);
        odd_r += y * load<Floats8>(r + i + 8);
        odd_s += y * load<Floats8>(s + i + 8);
    }
    for (; i < count; i += 8) {
        const Floats8 x = load<Floats8>(a + i);
        even_p += x * load<Floats8>(p + i);
        even_q += x * load<Floats8>(q + i);
        even_r += x * load<Floats8>(r + i);
        even_s += x * load<Floats8>(s + i);
    }
    return sums_of(even_p + odd_p, even_q + odd_q, even_r + odd_r, even_s + odd_s);
}

float dot(const float* a, const float* b, std::size_t count) {
    Floats8 even{}, odd{};
    std::size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        even += load<Floats8>(a + i) * load<Floats8>(b + i);
        odd += load<Floats8>(a + i + 8) * load<Floats8>(b + i + 8);
    }
    for (; i < count; i += 8) even += load<Floats8>(a + i) * load<Floats8>(b + i);
    const Floats8 sum = even + odd;
    return sums_of(sum, sum, sum, sum)[0];
}

static_assert(shape_points * planar_channels % 8 == 0 && shape_points * solid_channels % 8 == 0);

/// The pairs of channels (numbers of each point of a shape) that are x and y of a vector, which turns with
/// the stroke: the first channel of each pair.
std::span<const std::size_t> turning_pairs(std::size_t channels) {
    static constexpr std::array<std::size_t, 2> planar{0, 2};
    static constexpr std::array<std::size_t, 3> solid{0, 3, 6};
    if (channels == planar_channels) return planar;
    return solid;
}

/// Parts of the dot product after the stroke is turned by an angle a: the product is fixed + cosine cos a +
/// sine sin a.
struct TurnedProduct {
    float fixed{}, cosine{}, sine{};
};

TurnedProduct turned_product(const float* stroke, const float* t, std::size_t channels) {
    TurnedProduct sum;
    sum.fixed = dot(stroke, t, shape_points * channels);
    for (const auto pair : turning_pairs(channels)) {
        for (std::size_t i = 0; i < shape_points; ++i) {
            const float *q = stroke + i * channels + pair, *r = t + i * channels + pair;
            sum.cosine += q[0] * r[0] + q[1] * r[1];
            sum.sine += q[0] * r[1] - q[1] * r[0];
        }
    }
    sum.fixed -= sum.cosine;
    return sum;
}

/// Turns the values of a template towards a stroke.
void turn(float* values, std::size_t points, std::size_t channels, float cosine, float sine) {
    for (const auto pair : turning_pairs(channels)) {
        for (std::size_t i = 0; i < points; ++i) {
            float* v = values + i * channels + pair;
            const float x = v[0], y = v[1];
            v[0] = cosine * x + sine * y;
            v[1] = cosine * y - sine * x;
        }
    }
}

/// For each of the eight scores (dot products with templates) from `first` on, the number of scores that are
/// better: larger, or as large and before it.
Ints8 ranks_of(std::size_t first, const float* scores, std::size_t count) {
    const auto own = load<Floats8>(scores + first);
    Ints8 better{};  // number of better scores, negative: a true comparison is minus one
    for (std::size_t i = 0; i < first; ++i) better += scores[i] + Floats8{} >= own;
    for (std::size_t i = 0; i < lanes; ++i) {
        const Floats8 other = scores[first + i] + Floats8{};
        const Ints8 order{0, 1, 2, 3, 4, 5, 6, 7};
        better += (other > own) | ((other == own) & (order > static_cast<std::int32_t>(i)));
    }
    for (std::size_t i = first + lanes; i < count; ++i) better += scores[i] + Floats8{} > own;
    return -better;
}

}  // namespace

RecogniserSpace::RecogniserSpace() {
    survivors_.resize(max_templates + 1);
    compared_.resize(max_templates);
}

Recogniser::Survivor Recogniser::turned_score(const Shape& shape, const Template& t) const {
    Survivor best{.score = lowest_score};
    const std::size_t shifts = t.closed ? shape_points : 1;
    for (std::size_t s = 0; s < shifts; ++s) {
        const auto product =
            turned_product(shape.values.data(), &values_[t.values + s * t.channels], t.channels);
        Survivor survivor{.shift = static_cast<std::uint32_t>(s)};
        const float length = std::sqrt(product.cosine * product.cosine + product.sine * product.sine);
        survivor.cosine = length > 0 ? product.cosine / length : 1;
        survivor.sine = length > 0 ? product.sine / length : 0;
        if (survivor.cosine < t.cosine) {
            survivor.cosine = t.cosine;
            survivor.sine = survivor.sine < 0 ? -t.sine : t.sine;
        }
        survivor.score = product.fixed + product.cosine * survivor.cosine + product.sine * survivor.sine;
        if (survivor.score > best.score) best = survivor;
    }
    return best;
}

Recogniser::Survivor Recogniser::closed_score(const Shape& shape, const Template& t) const {
    static_assert(shape_points % 4 == 0);
    Survivor best{.score = lowest_score};
    for (std::uint32_t s = 0; s < shape_points; s += 4) {
        std::array<const float*, 4> shifted;
        for (std::size_t k = 0; k < 4; ++k) shifted[k] = &values_[t.values + (s + k) * t.channels];
        const auto products = dots(shape.values.data(), shifted, shape_points * t.channels);
        for (std::uint32_t k = 0; k < 4; ++k) {
            if (products[k] > best.score) best = {.score = products[k], .shift = s + k};
        }
    }
    return best;
}

/// Computes the dot products of a stroke's shape with the first `count` templates in the list of those to
/// compare.
void Recogniser::score(const Shape& shape, std::size_t count, RecogniserSpace& space) const {
    std::array<const float*, 4>
        plain;  // values of templates that need neither turn nor other start: four are multiplied at a time
    std::array<std::size_t, 4> places;
    std::size_t waiting = 0;
    const auto multiply = [&] {
        for (std::size_t k = waiting; k < 4; ++k) plain[k] = plain[0];
        const auto products = dots(shape.values.data(), plain, shape_points * shape.channels);
        for (std::size_t k = 0; k < waiting; ++k) space.compared_[places[k]].score = products[k];
        waiting = 0;
    };
    for (std::size_t i = 0; i < count; ++i) {
        auto& match = space.compared_[i];
        const auto& t = templates_[match.place];
        if (t.turns || t.closed) {
            const auto place = match.place;
            match = t.turns ? turned_score(shape, t) : closed_score(shape, t);
            match.place = place;
            continue;
        }
        plain[waiting] = &values_[t.values];
        places[waiting] = i;
        if (++waiting == 4) multiply();
    }
    if (waiting > 0) multiply();
    for (std::size_t i = 0; i < count; ++i) space.scores_[i] = space.compared_[i].score;
}

std::size_t Recogniser::verified_at_most() const {
    if (settings_.exhaustive) return max_templates;
    const std::size_t groups = (templates_.size() + 31) / 32 + (templates_.size() > 128 ? 2 : 0);
    return lanes * std::clamp<std::size_t>(groups, 1, 8);
}

/// Chooses the templates to compare elastically: those with the `most` largest dot products, best first.
void Recogniser::choose(const Shape& shape, const Limits& limits, std::size_t most,
                        RecogniserSpace& space) const {
    auto& list = space.compared_;
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < templates_.size(); ++k) {
        const auto& t = templates_[k];
        if (t.channels != shape.channels || t.gesture == limits.left_out) continue;
        if (!limits.twins && are_twins(t.gesture, limits.left_out)) continue;
        if (!limits.means && t.stroke == strokes_of_[t.gesture]) continue;
        if (shape.size < t.smallest * t.size || shape.size > t.largest * t.size) continue;
        if (limits.length_range > 0 &&
            (shape.length > t.length * limits.length_range || shape.length * limits.length_range < t.length))
            continue;
        list[count++] = {.place = k};
    }
    score(shape, count, space);
    keep_best(count, most, space);
}

/// Puts the `most` templates with the largest dot products in the list of survivors, which are compared
/// elastically, best first. The rank of each is found by comparison with all others, without a branch that
/// the processor might mispredict.
void Recogniser::keep_best(std::size_t count, std::size_t most, RecogniserSpace& space) {
    const std::size_t rounded = (count + lanes - 1) / lanes * lanes;
    std::fill(space.scores_.begin() + static_cast<std::ptrdiff_t>(count),
              space.scores_.begin() + static_cast<std::ptrdiff_t>(rounded), lowest_score);
    for (std::size_t k = 0; k < count; k += lanes) {
        const Ints8 ranks = ranks_of(k, space.scores_.data(), count);
        for (std::size_t lane = 0; lane < std::min(lanes, count - k); ++lane) {
            const auto rank = static_cast<std::size_t>(ranks[lane]);
            // Templates of rank `most` or worse all go to the one place after the best, which is never read.
            space.survivors_[std::min(rank, most)] = space.compared_[k + lane];
        }
    }
    space.survivor_count_ = std::min(count, most);
}

/// Values of a template's shape as the elastic distance needs them: from the start that fits the stroke best,
/// and turned towards the stroke.
const float* Recogniser::lane_values(const Survivor& survivor, std::size_t lane,
                                     RecogniserSpace& space) const {
    const auto& t = templates_[survivor.place];
    const float* values = &values_[t.values + survivor.shift * t.channels];
    if (!t.turns) return values;
    auto& turned = space.turned_[lane];
    std::copy(values, values + shape_points * t.channels, turned.begin());
    turn(turned.data(), shape_points, t.channels, survivor.cosine, survivor.sine);
    return turned.data();
}

FineKind Recogniser::fine_template(const Survivor& survivor, FineShape& shape) const {
    const auto& t = templates_[survivor.place];
    shape = fine_[survivor.place];
    const std::size_t start = (survivor.shift * fine_points + shape_points / 2) / shape_points;
    std::rotate(shape.begin(), shape.begin() + static_cast<std::ptrdiff_t>(start % fine_points * t.channels),
                shape.begin() + static_cast<std::ptrdiff_t>(fine_points * t.channels));
    if (t.turns) turn(shape.data(), fine_points, t.channels, survivor.cosine, survivor.sine);
    return {{t.channels == solid_channels, counts_force_}, !t.turns};
}

/// Computes the elastic distances of a stroke from the templates that the dot product chose (survivors);
/// keeps the two nearest of each gesture.
void Recogniser::verify(const Shape& shape, RecogniserSpace& space) const {
    for (std::size_t first = 0; first < space.survivor_count_; first += lanes) {
        const std::size_t count = std::min(lanes, space.survivor_count_ - first);
        std::array<const float*, lanes> values;
        for (std::size_t k = 0; k < lanes; ++k)
            values[k] = lane_values(space.survivors_[first + std::min(k, count - 1)], k, space);
        set_lanes(space.eight_, shape.channels, values);
        const auto distances = elastic_distances(shape, space.eight_);
        for (std::size_t k = 0; k < count; ++k)
            note(distances[k], templates_[space.survivors_[first + k].place], space);
    }
}

/// Takes a stroke's distance from a template into account: keeps the distances of the two nearest recorded
/// strokes of the template's gesture.
void Recogniser::note(float distance, const Template& t, RecogniserSpace& space) const {
    auto& near = space.nearest_[t.gesture];
    if (near.count == 0) {
        near = {distance, distance, t.stroke, 1};
    } else if (t.stroke == near.stroke) {
        near.first = std::min(near.first, distance);
    } else if (distance < near.first) {
        near = {distance, near.first, t.stroke, 2};
    } else {
        near.second = near.count == 1 ? distance : std::min(near.second, distance);
        near.count = 2;
    }
}

/// Distance of a stroke from a gesture: the mean of those from its two nearest recorded strokes, of which the
/// nearest has more weight.
float Recogniser::distance_of(std::uint32_t gesture, float farthest, const RecogniserSpace& space) const {
    const auto& near = space.nearest_[gesture];
    // If only one of several recorded strokes was compared, the others count as being at the largest distance
    // that was found for any gesture, `farthest`.
    const float unknown = strokes_of_[gesture] > 1 ? farthest : near.first;
    const float second = near.count > 1 ? near.second : unknown;
    const float mean = (near.first + second_weight * second) / (1 + second_weight);
    return near.count > 0 ? mean : farthest_possible;
}

bool Recogniser::are_twins(std::uint32_t a, std::uint32_t b) const {
    if (a >= twins_.size()) return false;
    return std::find(twins_[a].begin(), twins_[a].end(), b) != twins_[a].end();
}

std::uint32_t Recogniser::twin_by_force(std::uint32_t gesture, double mean_force) const {
    const auto oddness = [&](std::uint32_t g) { return force_oddness(mean_force, template_force_[g]); };
    auto best = gesture;
    for (const auto twin : twins_[gesture]) {
        if (oddness(twin) < oddness(best)) best = twin;
    }
    return best;
}

/// Chooses between the nearest gesture and its twins (gestures of its shape with another force), and then the
/// runner-up among all other gestures. Returns the probability of the choice among the twins, 0 to 1.
double Recogniser::by_twins(float force, float farthest, const RecogniserSpace& space, Recognition& r) const {
    const auto oddness = [&](std::uint32_t g) {
        const auto ratio = static_cast<double>((distance_of(g, farthest, space) + twin_common_distance) /
                                               (r.distance + twin_common_distance));
        return force_oddness(static_cast<double>(force), template_force_[g]) +
               twin_distance_power * det::log(std::max(ratio, 1.0));
    };
    const auto twins = std::span(twins_[r.gesture]);
    std::uint32_t best = r.gesture;
    double least = oddness(best), sum = 1;  // `sum`: 1 for the best choice, plus the odds of each other twin
    for (const auto twin : twins) {
        const double odd = space.nearest_[twin].count > 0 ? oddness(twin) : 1e3;
        sum = odd < least ? 1 + sum * det::exp(odd - least) : sum + det::exp(least - odd);
        best = odd < least ? twin : best;
        least = std::min(least, odd);
    }
    r.runner_up = Recognition::none;
    r.runner_up_distance = 0;
    for (std::uint32_t g = 0; g < gestures(); ++g) {
        if (space.nearest_[g].count == 0 || g == best || are_twins(best, g)) continue;
        const float d = distance_of(g, farthest, space);
        if (r.runner_up != Recognition::none && d >= r.runner_up_distance) continue;
        r.runner_up = g;
        r.runner_up_distance = d;
    }
    r.gesture = best;
    r.distance = distance_of(best, farthest, space);
    return 1 / sum;
}

Recognition Recogniser::result_of(const Shape& shape, const RecogniserSpace& space) const {
    float farthest = 0;
    for (std::size_t g = 0; g < gestures(); ++g) {
        const auto& near = space.nearest_[g];
        if (near.count > 0) farthest = std::max({farthest, near.first, near.count > 1 ? near.second : 0});
    }
    Recognition r;
    r.distance = r.runner_up_distance = farthest_possible;
    for (std::uint32_t g = 0; g < gestures(); ++g) {
        const float d = distance_of(g, farthest, space);
        // Decided without branches, which the processor would often mispredict.
        const bool best = d < r.distance, next = !best && d < r.runner_up_distance;
        r.runner_up = best ? r.gesture : next ? g : r.runner_up;
        r.runner_up_distance = best ? r.distance : next ? d : r.runner_up_distance;
        r.gesture = best ? g : r.gesture;
        r.distance = best ? d : r.distance;
    }
    if (r.runner_up == Recognition::none) r.runner_up_distance = 0;
    if (r.gesture == Recognition::none) r.distance = 0;
    if (r.gesture == Recognition::none) return r;
    const double by_force = twins_[r.gesture].empty() ? 1 : by_twins(shape.force, farthest, space, r);
    const float other = r.runner_up == Recognition::none ? farthest_possible : r.runner_up_distance;
    r.evidence = evidence_of(r.distance, other, calibration_.usual[r.gesture]);
    const double even = calibration_.probability(r.evidence);
    r.even_probability = by_force * even;
    r.probability = by_force * probability_on_purpose(r.distance, other, even);
    r.accepted =
        r.distance <= calibration_.threshold[r.gesture] && r.even_probability >= settings_.min_probability;
    r.mean_force = static_cast<double>(shape.force);
    r.force = force_class(r.gesture, r.mean_force);
    r.start = static_cast<double>(shape.start_t);
    r.end = static_cast<double>(shape.end_t);
    return r;
}

double Recogniser::probability_of(std::uint32_t gesture, float distance, bool has_runner_up,
                                  float runner_up_distance) const {
    const float other = has_runner_up ? runner_up_distance : farthest_possible;
    return calibration_.probability(evidence_of(distance, other, calibration_.usual[gesture]));
}

ForceClass Recogniser::force_class(std::uint32_t gesture, double mean_force) const {
    const auto& o = options_[gesture];
    if (mean_force < o.gentle_below) return ForceClass::gentle;
    return mean_force > o.harsh_above ? ForceClass::harsh : ForceClass::normal;
}

Recognition Recogniser::decide(const Shape* solid, const Shape* flat, const Limits& limits,
                               RecogniserSpace& space) const {
    std::fill_n(space.nearest_.begin(), gestures(), RecogniserSpace::Nearest{});
    for (const Shape* shape : {solid, flat}) {
        if (shape == nullptr) continue;
        choose(*shape, limits, verified_at_most(), space);
        verify(*shape, space);
    }
    return result_of(solid != nullptr ? *solid : *flat, space);
}

Recognition Recogniser::recognise(Points stroke, RecogniserSpace& space) const {
    return recognise_without(stroke, Recognition::none, space);
}

Recognition Recogniser::recognise_part(Points part, RecogniserSpace& space) const {
    return recognise_within(part, {.rests = Rests::kept}, space);
}

Recognition Recogniser::recognise_without(Points stroke, std::uint32_t left_out,
                                          RecogniserSpace& space) const {
    return recognise_within(stroke, {.left_out = left_out}, space);
}

Recognition Recogniser::recognise_within(Points stroke, const Limits& limits, RecogniserSpace& space) const {
    const Channels solid{true, counts_force_}, flat{false, counts_force_};
    if (needs_solid_ && !make_shape(stroke, solid, space.points_, space.solid_, limits.rests)) return {};
    const bool flat_made =
        needs_flat_ && make_shape(stroke, flat, space.points_, space.planar_, limits.rests);
    if (!needs_solid_ && !flat_made) return {};
    return decide(needs_solid_ ? &space.solid_ : nullptr, flat_made ? &space.planar_ : nullptr, limits,
                  space);
}

}  // namespace thaum::gesture
