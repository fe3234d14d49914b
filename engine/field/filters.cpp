#include "field/filters.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"

namespace thaum::field {
namespace {

constexpr std::array<std::string_view, 7> names_of_filters{"magnitude", "gradient", "curl",  "divergence",
                                                           "scale",     "clamp",    "smooth"};

std::string_view name_of(FilterKind kind) { return names_of_filters[static_cast<std::size_t>(kind)]; }

const FilterStage& stage_of(const void* what) { return *static_cast<const FilterStage*>(what); }

template <bool quick>
const AnyField& input_of(const FilterStage& stage) {
    return quick ? stage.quick_input : stage.input;
}

// ---- reading ----------------------------------------------------------------------------------------------

/// The places one sample before and after a given place along an axis. If that place lies within the samples,
/// both neighbours do, too.
struct Neighbours {
    vec3 low, high;
    double per_metre;  ///< 1 / distance between the two places (1/m)
};

Neighbours neighbours_of(const FilterStage& stage, vec3 place, int axis) {
    Neighbours n{place, place, 0};
    const double reach = stage.reach[axis];
    n.low[axis] -= stage.step[axis];
    n.high[axis] += stage.step[axis];
    if (std::abs(place[axis]) <= reach) {
        n.low[axis] = std::max(n.low[axis], -reach);
        n.high[axis] = std::min(n.high[axis], reach);
    }
    const double distance = n.high[axis] - n.low[axis];
    n.per_metre = distance > 0 ? 1 / distance : 0;
    return n;
}

/// Derivatives, by differences, of the vector that `value` computes at a place.
template <class Value>
std::array<vec3, 3> derivatives(const FilterStage& stage, vec3 place, Value value) {
    std::array<vec3, 3> result{};
    for (int axis = 0; axis < 3; ++axis) {
        const Neighbours n = neighbours_of(stage, place, axis);
        const vec3 slope = (value(n.high) - value(n.low)) * n.per_metre;
        for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)][axis] = slope[i];
    }
    return result;
}

template <bool quick>
Scalar read_magnitude(const void* what, vec3 place) {
    const Vector v = input_of<quick>(stage_of(what)).vector(place);
    const double length = glm::length(v.value);
    if (!(length > 0)) return {length, {}};
    vec3 slope(0);
    for (int i = 0; i < 3; ++i) slope += v.value[i] * v.gradient[static_cast<std::size_t>(i)];
    return {length, slope / length};
}

template <bool quick>
Vector read_gradient(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    const auto value = [&](vec3 at) { return stage.input.scalar(at).gradient; };
    if constexpr (quick) return {value(place), {}};
    return {value(place), derivatives(stage, place, value)};
}

template <bool quick>
Vector read_curl(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    const auto value = [&](vec3 at) { return curl(stage.input.vector(at)); };
    if constexpr (quick) return {value(place), {}};
    return {value(place), derivatives(stage, place, value)};
}

template <bool quick>
Scalar read_divergence(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    const auto value = [&](vec3 at) { return divergence(stage.input.vector(at)); };
    Scalar result{value(place), {}};
    if constexpr (quick) return result;
    for (int axis = 0; axis < 3; ++axis) {
        const Neighbours n = neighbours_of(stage, place, axis);
        result.gradient[axis] = (value(n.high) - value(n.low)) * n.per_metre;
    }
    return result;
}

template <bool quick>
Scalar read_scaled(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    const Scalar s = input_of<quick>(stage).scalar(place);
    return {stage.filter.a * s.value + stage.filter.b, stage.filter.a * s.gradient};
}

template <bool quick>
Vector read_scaled_vector(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    Vector v = input_of<quick>(stage).vector(place);
    v.value *= stage.filter.a;
    for (vec3& slope : v.gradient) slope *= stage.filter.a;
    return v;
}

template <bool quick>
Scalar read_clamped(const void* what, vec3 place) {
    const FilterStage& stage = stage_of(what);
    const Scalar s = input_of<quick>(stage).scalar(place);
    if (s.value < stage.filter.a) return {stage.filter.a, {}};
    if (s.value > stage.filter.b) return {stage.filter.b, {}};
    return s;
}

Scalar read_smoothed(const void* what, vec3 place) { return stage_of(what).smoothed.component[0](place); }
Vector read_smoothed_vector(const void* what, vec3 place) { return stage_of(what).smoothed(place); }

/// The output of a filter as a field without a bounding box. `quick`: gradients that would take several reads
/// of the input (differences) are 0.
template <bool quick>
AnyField endless_output_of(const FilterStage& stage) {
    const bool vector = stage.input.is_vector();
    switch (stage.filter.kind) {
        case FilterKind::magnitude: return {{&stage, read_magnitude<quick>}, {}};
        case FilterKind::gradient: return {{}, {&stage, read_gradient<quick>}};
        case FilterKind::curl: return {{}, {&stage, read_curl<quick>}};
        case FilterKind::divergence: return {{&stage, read_divergence<quick>}, {}};
        case FilterKind::scale:
            if (vector) return {{}, {&stage, read_scaled_vector<quick>}};
            return {{&stage, read_scaled<quick>}, {}};
        case FilterKind::clamp: return {{&stage, read_clamped<quick>}, {}};
        case FilterKind::smooth:
            if (vector) return {{}, {&stage, read_smoothed_vector}};
            return {{&stage, read_smoothed}, {}};
    }
    return {};
}

/// The box of a filter's input, in which its output has values. The box's samples are not passed on, because
/// they are not the filtered values.
SampleBox filtered_box(const void* what) {
    const AnyField& input = stage_of(what).input;
    SampleBox box = input.is_vector() ? sample_box_of(input.vector) : sample_box_of(input.scalar);
    box.drawn = box.averages = {};
    return box;
}

/// The output of a filter as a field that has a bounding box if its input has one.
template <bool quick>
AnyField output_of(const FilterStage& stage) {
    AnyField out = endless_output_of<quick>(stage);
    const bool bounded = stage.input.vector.box != nullptr || stage.input.scalar.box != nullptr;
    if (bounded) (out.is_vector() ? out.vector.box : out.scalar.box) = filtered_box;
    return out;
}

// ---- smoothing --------------------------------------------------------------------------------------------

/// Weights of the central sample and of those at 1, 2 ... samples to each side. Over both sides they add up
/// to 1.
std::vector<double> gaussian(double deviation) {
    std::vector<double> weights(static_cast<std::size_t>(std::ceil(4 * deviation)) + 1);
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double x = static_cast<double>(i) / deviation;
        weights[i] = det::exp(-0.5 * x * x);
        sum += (i == 0 ? 1 : 2) * weights[i];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Number of lines that are smoothed at once. The innermost loop runs across lines, over contiguous memory,
/// and each sample's sum keeps its order.
constexpr std::size_t lines_at_once = 16;

/// Buffer for lines of samples, side by side: sample i of line l is at lines_at_once * (margin + i) + l.
struct Lines {
    std::vector<double> samples{};
    std::size_t margin{};
};

/// Copies lines of samples into the buffer, with margins that repeat the outermost samples. Line l begins at
/// first[l].
void take_lines(std::span<const float* const> first, std::ptrdiff_t stride, int count, Lines& lines) {
    const int margin = static_cast<int>(lines.margin);
    double* out = lines.samples.data();
    for (int i = -margin; i < count + margin; ++i) {
        const std::ptrdiff_t at = std::clamp(i, 0, count - 1) * stride;
        for (std::size_t l = 0; l < first.size(); ++l) out[l] = first[l][at];
        out += lines_at_once;
    }
}

/// Smooths the `count` samples of up to lines_at_once lines, `stride` apart in each line.
void smooth_lines(std::span<float* const> first, std::ptrdiff_t stride, int count,
                  std::span<const double> weights, Lines& lines) {
    take_lines({first.data(), first.size()}, stride, count, lines);
    for (int i = 0; i < count; ++i) {
        const double* middle = &lines.samples[lines_at_once * (lines.margin + static_cast<std::size_t>(i))];
        std::array<double, lines_at_once> sum;
        for (std::size_t l = 0; l < lines_at_once; ++l) sum[l] = weights[0] * middle[l];
        for (std::size_t n = 1; n < weights.size(); ++n) {
            const double *low = middle - lines_at_once * n, *high = middle + lines_at_once * n;
            for (std::size_t l = 0; l < lines_at_once; ++l) sum[l] += weights[n] * (low[l] + high[l]);
        }
        for (std::size_t l = 0; l < first.size(); ++l) first[l][i * stride] = static_cast<float>(sum[l]);
    }
}

std::uint64_t key_of(std::uint64_t key, double number) {
    return hash_combine(key, std::bit_cast<std::uint64_t>(number));
}

std::uint64_t key_of(const FilterSource& source) {
    std::uint64_t key = hash_combine(source.version, static_cast<std::uint64_t>(source.kernel));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        key = hash_combine(key, static_cast<std::uint64_t>(source.count[axis]));
        key = key_of(key, source.spacing[static_cast<int>(axis)]);
    }
    return hash_combine(key, source.field.is_vector() ? 1 : 0);
}

/// Makes the filter `smooth` of a stage read smoothed samples of its input. Those in `old` are used again if
/// they have the same key, a hash of all that they depend on.
void use_smoothed(FilterStage& stage, const FilterSource& source, std::uint64_t key,
                  std::vector<std::unique_ptr<SmoothedSamples>>& old, FilteredField& out) {
    const auto found =
        std::ranges::find_if(old, [key](const auto& samples) { return samples && samples->key == key; });
    if (found != old.end()) {
        out.smoothed.push_back(std::move(*found));
    } else {
        Volume volume = stage.input.is_vector()
                            ? sampled(stage.quick_input.vector, source.count, source.spacing)
                            : sampled(stage.quick_input.scalar, source.count, source.spacing);
        smooth(volume, stage.filter.a);
        out.smoothed.push_back(std::make_unique<SmoothedSamples>());
        *out.smoothed.back() = {key, std::move(volume)};
        ++out.smoothings;
    }
    const Volume& volume = out.smoothed.back()->volume;
    if (volume.components == 3) {
        stage.smoothed = volume.vector_grid(source.kernel);
    } else {
        stage.smoothed.component[0] = volume.grid(source.kernel);
    }
}

/// Describes what is wrong with the parameters of a filter; empty: nothing.
std::string fault_of(const Filter& filter, bool takes_vector) {
    switch (filter.kind) {
        case FilterKind::scale:
            if (!std::isfinite(filter.a) || !std::isfinite(filter.b)) return "has a factor that is no number";
            if (takes_vector && filter.b != 0) return "adds a number to a vector; set b to 0";
            return {};
        case FilterKind::clamp:
            return filter.a <= filter.b ? "" : "has limits in the wrong order, or one that is no number";
        case FilterKind::smooth:
            if (filter.a >= 0 && filter.a <= max_smoothing) return {};
            return text("has a deviation that is not from 0 to ", max_smoothing, " samples");
        default: return {};
    }
}

}  // namespace

std::span<const std::string_view> filter_names() { return names_of_filters; }

void place(PlacedField& out, const AnyField& own, const Placement& placement) {
    out.scalar = {own.scalar, placement};
    out.vector = {own.vector, placement};
    out.field = {};
    if (own.is_vector())
        out.field.vector = field_of<Vector>(out.vector);
    else
        out.field.scalar = field_of<Scalar>(out.scalar);
    out.field.placement = &out.scalar.placement;
}

Expected<bool> checked_filters(std::span<const Filter> filters, bool source_is_vector) {
    if (filters.size() > max_filters) return fail(text(filters.size(), " filters, more than ", max_filters));
    bool vector = source_is_vector;
    for (std::size_t i = 0; i < filters.size(); ++i) {
        const FilterKind kind = filters[i].kind;
        const auto named = [&] { return text("filter ", i + 1, " (", name_of(kind), ") "); };
        const bool wants_vector =
            kind == FilterKind::magnitude || kind == FilterKind::curl || kind == FilterKind::divergence;
        const bool wants_scalar = kind == FilterKind::gradient || kind == FilterKind::clamp;
        if (wants_vector && !vector) return fail(text(named(), "needs a vector, but gets a scalar"));
        if (wants_scalar && vector) return fail(text(named(), "needs a scalar, but gets a vector"));
        if (const std::string fault = fault_of(filters[i], vector); !fault.empty())
            return fail(text(named(), fault));
        if (wants_vector || wants_scalar) vector = kind == FilterKind::gradient || kind == FilterKind::curl;
    }
    return vector;
}

Expected<void> set_filters(FilteredField& out, const FilterSource& source, std::span<const Filter> filters) {
    if (const auto checked = checked_filters(filters, source.field.is_vector()); !checked)
        return checked.error();
    auto old = std::move(out.smoothed);
    out.smoothed.clear();
    out.field = out.quick = source.field;
    const vec3 count(source.count[0], source.count[1], source.count[2]);
    std::uint64_t key = key_of(source);
    for (std::size_t i = 0; i < filters.size(); ++i) {
        FilterStage& stage = out.stages[i];
        stage = {.filter = filters[i],
                 .input = out.field,
                 .quick_input = out.quick,
                 .step = source.spacing,
                 .reach = 0.5 * source.spacing * (count - vec3(1))};
        key = hash_combine(key, static_cast<std::uint64_t>(filters[i].kind));
        key = key_of(key_of(key, filters[i].a), filters[i].b);
        if (filters[i].kind == FilterKind::smooth) use_smoothed(stage, source, key, old, out);
        out.field = output_of<false>(stage);
        out.quick = output_of<true>(stage);
    }
    return {};
}

void smooth(Volume& volume, double deviation) {
    if (!(deviation > 0)) return;
    const std::vector<double> weights = gaussian(std::min(deviation, max_smoothing));
    Lines lines{.samples = {}, .margin = weights.size() - 1};
    const auto longest = static_cast<std::size_t>(*std::ranges::max_element(volume.count));
    lines.samples.resize(lines_at_once * (longest + 2 * lines.margin));
    std::array<std::ptrdiff_t, 3> stride{volume.components, volume.components * volume.count[0],
                                         volume.components * volume.count[0] * volume.count[1]};
    float* const samples = volume.samples.floats().data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
        std::array<float*, lines_at_once> first{};
        std::size_t waiting = 0;
        const auto smooth_waiting = [&] {
            smooth_lines({first.data(), waiting}, stride[axis], volume.count[axis], weights, lines);
            waiting = 0;
        };
        for (int k = 0; k < volume.count[c]; ++k) {
            for (int j = 0; j < volume.count[b]; ++j) {
                for (int component = 0; component < volume.components; ++component) {
                    first[waiting++] = samples + component + j * stride[b] + k * stride[c];
                    if (waiting == lines_at_once) smooth_waiting();
                }
            }
        }
        if (waiting > 0) smooth_waiting();
    }
}

}  // namespace thaum::field
