// Construction of a recogniser: templates, limits of gentle and harsh force, and the calibration with
// synthetic strokes.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "gesture/detail/speed_force.h"
#include "gesture/detail/twins.h"
#include "gesture/recogniser.h"
#include "gesture/variations.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t variations_of_each = 24;
constexpr std::size_t min_scribbles = 300, max_scribbles = 1200;
/// Bounds of a gentle and of a harsh stroke for gestures that set none, as shares of the templates' mean
/// force.
constexpr double gentle_share = 0.6, harsh_share = 1.6;
constexpr float open_threshold = 1e9F;
constexpr float assumed_usual = 0.1F, min_usual = 1e-3F;
/// Largest number of recorded strokes of a gesture that are compared with one another. More strokes would
/// hardly change the mean distance.
constexpr std::size_t max_compared = 16;

std::vector<StrokePoint> backwards(Points stroke) {
    std::vector<StrokePoint> result(stroke.rbegin(), stroke.rend());
    for (auto& p : result) p.t = stroke.back().t - p.t;
    return result;
}

std::string too_many() {
    return text("more than ", max_templates, " templates; use fewer strokes of each gesture");
}

float quantile(std::vector<float> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::floor(share * last + 0.5))];
}

/// Distance of the stroke that was compared last to the nearest gesture that is not `other`; 0: there is
/// none.
template <class Nearest>
double nearest_third(std::span<const Nearest> nearest, std::uint32_t other) {
    float third = 0;
    for (std::uint32_t g = 0; g < nearest.size(); ++g) {
        if (g == other || nearest[g].count == 0) continue;
        third = third > 0 ? std::min(third, nearest[g].first) : nearest[g].first;
    }
    return static_cast<double>(third);
}

}  // namespace

bool Recogniser::add_template(Points stroke, std::uint32_t number, std::uint32_t stroke_number,
                              RecogniserSpace& space) {
    const auto& options = options_[number];
    const Channels channels{settings_.channels.depth && !options.planar, counts_force_};
    Shape shape;
    if (!make_shape(stroke, channels, space.points_, shape)) return false;
    fine_.emplace_back();
    make_fine_shape(space.points_, 0, space.points_.count - 1, {channels, !(options.rotation > 0)},
                    fine_.back());
    Template t{.gesture = number,
               .stroke = stroke_number,
               .channels = static_cast<std::uint32_t>(shape.channels),
               .values = values_.size()};
    t.size = shape.size;
    t.length = shape.length;
    for (const float v : shape.values) t.self += v * v;
    t.closed = options.closed;
    t.turns = options.rotation > 0;
    t.cosine = static_cast<float>(det::cos(options.rotation));
    t.sine = static_cast<float>(det::sin(options.rotation));
    t.smallest = static_cast<float>(options.min_scale);
    t.largest = static_cast<float>(options.max_scale);
    const auto count = static_cast<std::ptrdiff_t>(shape_points * shape.channels);
    for (int copies = 0; copies < (options.closed ? 2 : 1); ++copies)
        values_.insert(values_.end(), shape.values.begin(), shape.values.begin() + count);
    shortest_ = templates_.empty() ? t.length : std::min(shortest_, t.length);
    longest_ = std::max(longest_, t.length);
    usual_seconds_[number] += shape.seconds;
    (shape.channels == solid_channels ? needs_solid_ : needs_flat_) = true;
    template_force_[number] += static_cast<double>(shape.force);
    templates_.push_back(t);
    return true;
}

/// Values of a template as a shape, to compare it with others. A closed template begins at its first start.
Shape Recogniser::shape_of(const Template& t) const {
    Shape shape{.channels = t.channels};
    std::copy_n(&values_[t.values], shape_points * t.channels, shape.values.begin());
    return shape;
}

/// Adds the mean of a gesture's templates from `first` to before `end`, `step` apart, as one more stroke.
/// Each recorded stroke differs by chance from what its writer means; their mean differs less. Strokes that
/// may be turned are turned towards the first.
void Recogniser::add_mean(std::size_t first, std::size_t step, std::size_t end, RecogniserSpace& space) {
    Template mean = templates_[first];
    const Shape base = shape_of(mean);
    const std::size_t strokes = (end - first + step - 1) / step;
    const auto share = 1 / static_cast<float>(strokes);
    const std::size_t count = shape_points * mean.channels;
    mean.values = values_.size();
    mean.size = mean.length = mean.self = 0;
    values_.resize(values_.size() + count);
    for (std::size_t k = first; k < end; k += step) {
        const auto& t = templates_[k];
        auto match = t.turns ? turned_score(base, t) : Survivor{};
        match.place = static_cast<std::uint32_t>(k);
        const float* values = lane_values(match, 0, space);
        for (std::size_t i = 0; i < count; ++i) values_[mean.values + i] += share * values[i];
        mean.size += share * t.size;
        mean.length += share * t.length;
        mean.stroke = t.stroke + 1;
    }
    for (std::size_t i = mean.values; i < values_.size(); ++i) mean.self += values_[i] * values_[i];
    fine_.emplace_back();  // stays empty: only the spotter reads fine shapes, and it leaves means out
    templates_.push_back(mean);
}

/// Mean distance of the recorded strokes of a gesture, whose templates begin at `first`, from one another.
/// `step` is the number of templates of each stroke.
float Recogniser::spread_of(std::size_t first, std::size_t step, RecogniserSpace& space) const {
    const std::size_t last = std::min(templates_.size(), first + step * max_compared);
    float sum = 0;
    std::size_t count = 0;
    for (std::size_t a = first; a < last; a += step) {
        const Shape shape = shape_of(templates_[a]);
        for (std::size_t b = first; b < last; b += step) {
            if (b == a) continue;
            float least = 1;
            for (std::size_t copy = b; copy < b + step; ++copy) {
                const auto& u = templates_[copy];
                auto match = u.turns    ? turned_score(shape, u)
                             : u.closed ? closed_score(shape, u)
                                        : Survivor{};
                match.place = static_cast<std::uint32_t>(copy);
                std::array<const float*, lanes> same;
                same.fill(lane_values(match, 0, space));
                set_lanes(space.eight_, shape.channels, same);
                least = std::min(least, elastic_distances(shape, space.eight_)[0]);
            }
            sum += least;
            ++count;
        }
    }
    return std::max(sum / static_cast<float>(count), min_usual);
}

/// Adds what follows from several recorded strokes of a gesture: their usual distance from one another, and
/// their mean as a template. A closed gesture has no mean, because its strokes start anywhere.
Expected<void> Recogniser::add_what_strokes_share(const Gesture& gesture, std::size_t first,
                                                  std::size_t copies, RecogniserSpace& space) {
    const bool several = gesture.strokes.size() > 1;
    calibration_.usual.push_back(several ? spread_of(first, copies, space) : assumed_usual);
    const std::size_t end = templates_.size();
    for (std::size_t k = 0; k < copies && several && !gesture.options.closed; ++k)
        add_mean(first + k, copies, end, space);
    if (templates_.size() > max_templates) return fail(too_many());
    return {};
}

Expected<void> Recogniser::add(const Gesture& gesture, RecogniserSpace& space) {
    const std::size_t first = templates_.size();
    const auto number = static_cast<std::uint32_t>(names_.size());
    names_.push_back(gesture.name);
    options_.push_back(gesture.options);
    template_force_.push_back(0);
    usual_seconds_.push_back(0);
    strokes_of_.push_back(static_cast<std::uint32_t>(gesture.strokes.size()));
    if (gesture.strokes.empty()) return fail(text("gesture '", gesture.name, "' has no stroke; record one"));
    for (std::size_t i = 0; i < gesture.strokes.size(); ++i) {
        const auto& stroke = gesture.strokes[i];
        const auto k = static_cast<std::uint32_t>(i);
        bool made = add_template(stroke, number, k, space);
        if (made && !gesture.options.direction_sensitive)
            made = add_template(backwards(stroke), number, k, space);
        if (!made)
            return fail(
                text("gesture '", gesture.name, "': stroke ", i + 1,
                     " has no shape: it needs two different points and finite numbers; record it again"));
        if (templates_.size() > max_templates) return fail(too_many());
    }
    const std::size_t copies = gesture.options.direction_sensitive ? 1 : 2;
    if (auto done = add_what_strokes_share(gesture, first, copies, space); !done) return done;
    template_force_[number] /= static_cast<double>(copies * gesture.strokes.size());
    usual_seconds_[number] /= static_cast<float>(copies * gesture.strokes.size());
    auto& o = options_[number];
    if (!(o.gentle_below > 0)) o.gentle_below = gentle_share * template_force_[number];
    if (!(o.harsh_above > 0)) o.harsh_above = harsh_share * template_force_[number];
    return {};
}

/// Finds twins (gestures of one shape that differ in force): a recorded stroke of one must be near to the
/// other.
void Recogniser::find_twins(std::span<const Gesture> gestures, RecogniserSpace& space) {
    std::vector<std::vector<std::uint32_t>> twins(gestures.size());
    twins_.assign(gestures.size(), {});
    for (std::uint32_t g = 0; g < gestures.size(); ++g) {
        for (const auto& stroke : gestures[g].strokes) {
            recognise_within(stroke, {.left_out = g}, space);
            const std::span compared(std::as_const(space.nearest_).data(), gestures.size());
            for (std::uint32_t other = 0; other < gestures.size(); ++other) {
                const auto& near = compared[other];
                if (near.count == 0 ||
                    !differ_in_force(static_cast<double>(near.first), template_force_[g],
                                     template_force_[other], nearest_third(compared, other)))
                    continue;
                add_twins(twins, g, other);
            }
        }
    }
    twins_ = std::move(twins);
}

/// Calibrates with strokes that other users might draw and with strokes that mean nothing. While these are
/// recognised, the thresholds of acceptance are open: no stroke is refused for its distance.
void Recogniser::calibrate(std::span<const Gesture> gestures, RecogniserSpace& space) {
    Random random = random_stream(settings_.seed, 0x9e57);
    std::vector<std::vector<float>> meant(names_.size()), not_meant(names_.size());
    const auto count = static_cast<float>(variations_of_each);
    std::vector<std::vector<std::vector<StrokePoint>>> drawn(names_.size());
    for (std::uint32_t g = 0; g < names_.size(); ++g) {
        for (std::size_t v = 0; v < variations_of_each; ++v) {
            const auto& strokes = gestures[g].strokes;
            drawn[g].push_back(variation_of(strokes[v % strokes.size()], random));
            // Templates that are means of strokes are left out. The spotter, which searches continuous
            // motion, leaves them out too, and weighs distances by the usual distance found here.
            const auto r = recognise_within(drawn[g].back(), {.means = false}, space);
            if (r.gesture == g || are_twins(g, r.gesture)) meant[g].push_back(r.distance);
        }
        float sum = 0;
        for (const float d : meant[g]) sum += d;
        calibration_.usual[g] = meant[g].empty() ? assumed_usual : std::max(sum / count, min_usual);
    }
    std::vector<LabelledEvidence> samples;
    const auto keep = [&](const Recognition& r, bool is_meant) {
        if (r.gesture == Recognition::none) return;
        samples.push_back({r.evidence, is_meant, 1});
        if (!is_meant) not_meant[r.gesture].push_back(r.distance);
    };
    for (std::uint32_t g = 0; g < names_.size(); ++g) {
        for (const auto& stroke : drawn[g]) {
            const auto r = recognise(stroke, space);
            keep(r, r.gesture == g || are_twins(g, r.gesture));
            keep(recognise_within(stroke, {.left_out = g, .twins = false}, space), false);
        }
    }
    const std::size_t scribbles =
        std::clamp(variations_of_each * names_.size(), min_scribbles, max_scribbles);
    for (std::size_t i = 0; i < scribbles; ++i) keep(recognise(scribble(gestures, random), space), false);
    calibration_.weights = fit_weights(samples);
    for (std::size_t g = 0; g < names_.size(); ++g) {
        const float near = 1.5F * quantile(meant[g], 0.98), far = quantile(not_meant[g], 0.02);
        calibration_.threshold[g] = far > near ? std::sqrt(near * far) : std::max(near, 0.02F);
    }
}

Expected<Recogniser> Recogniser::make(std::span<const Gesture> gestures, const RecogniserSettings& settings) {
    if (gestures.empty()) return fail("no gesture to recognise; record one");
    if (gestures.size() > max_gestures)
        return fail(text(gestures.size(), " gestures, more than ", max_gestures, "; leave some out"));
    Recogniser result;
    result.settings_ = settings;
    result.counts_force_ =
        settings.channels.force && (settings.pace_counts || !force_follows_speed(gestures));
    RecogniserSpace space;
    for (const auto& g : gestures) {
        if (auto added = result.add(g, space); !added) return added.error();
    }
    result.calibration_.weights = {0, 0, 0, 0};
    result.calibration_.threshold.assign(gestures.size(), open_threshold);
    result.twins_.resize(gestures.size());
    if (settings.channels.force) result.find_twins(gestures, space);
    if (settings.calibrate) result.calibrate(gestures, space);
    return result;
}

}  // namespace thaum::gesture
