// Compares filters of fields with formulas, and with samples of these formulas at several spacings. Also
// tests that samples are smoothed only when necessary.
#include "field/filters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "field/analytic.h"
#include "unit/message_of.h"

namespace thaum::field {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

const Gyroid wavy{1.3, {0.1, 0.2, 0.3}};
const BeltramiFlow twist{{1, 0.8, 0.6}, 4};

vec3 place_within(Random& random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

/// A field given by a formula, as the input of a filter, in a box of 2 m.
FilterSource formula(AnyField field, double spacing) {
    const int n = static_cast<int>(2 / spacing) + 1;
    return {.field = field, .count = {n, n, n}, .spacing = vec3(spacing)};
}
FilterSource of_gyroid(double spacing) { return formula({field_of<Scalar>(wavy), {}}, spacing); }
FilterSource of_beltrami(double spacing) { return formula({{}, field_of<Vector>(twist)}, spacing); }

/// Samples of a field that a formula gives, as the input of a filter, with a different spacing along each
/// axis.
struct SampledSource {
    Volume volume;
    Grid grid;
    StaggeredGrid grids;

    SampledSource(const FilterSource& source, Kernel kernel) {
        const std::array<int, 3> count{source.count[0], source.count[1] * 3 / 2, source.count[2] * 5 / 4};
        const vec3 spacing = 2.0 / (vec3(count[0], count[1], count[2]) - vec3(1));
        volume = source.field.is_vector() ? sampled(source.field.vector, count, spacing)
                                          : sampled(source.field.scalar, count, spacing);
        grid = volume.grid(kernel);
        grids = volume.vector_grid(kernel);
    }
    SampledSource(const SampledSource&) = delete;
    SampledSource& operator=(const SampledSource&) = delete;

    FilterSource source() const {
        AnyField field;
        if (volume.components == 3) {
            field.vector = field_of<Vector>(grids);
        } else {
            field.scalar = field_of<Scalar>(grid);
        }
        return {.field = field, .count = volume.count, .spacing = volume.spacing, .version = 1};
    }
};

void put(FilteredField& out, const FilterSource& source, std::initializer_list<Filter> filters) {
    const auto set = set_filters(out, source, std::span(filters.begin(), filters.size()));
    ASSERT_TRUE(set) << set.error().message;
}

// ---- filters of formulas ----------------------------------------------------------------------------------

TEST(Filters, WithoutFiltersTheSourceIsRead) {
    FilteredField f;
    put(f, of_gyroid(0.1), {});
    EXPECT_EQ(f.field.scalar(vec3(0.3)).value, wavy(vec3(0.3)).value);
    EXPECT_EQ(f.quick.scalar(vec3(0.3)).gradient, wavy(vec3(0.3)).gradient);
}

TEST(Filters, MagnitudeScaleAndClampAreExactWithTheirGradients) {
    Random random = random_stream(1, 1);
    FilteredField length, scaled, clamped, scaled_flow;
    put(length, of_beltrami(0.1), {{FilterKind::magnitude}});
    put(scaled, of_gyroid(0.1), {{FilterKind::scale, -3, 2}});
    put(clamped, of_gyroid(0.1), {{FilterKind::clamp, -0.2, 0.4}});
    put(scaled_flow, of_beltrami(0.1), {{FilterKind::scale, -3, 0}});
    for (int run = 0; run < 300; ++run) {
        const vec3 place = place_within(random, 1);
        const Scalar wave = wavy(place), found = length.field.scalar(place);
        EXPECT_NEAR(found.value, glm::length(twist(place).value), 1e-15);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0);
            step[axis] = 1e-5;
            const double rise =
                glm::length(twist(place + step).value) - glm::length(twist(place - step).value);
            EXPECT_NEAR(found.gradient[axis], rise / 2e-5, 1e-6);
        }
        EXPECT_EQ(scaled.field.scalar(place).value, -3 * wave.value + 2);
        EXPECT_EQ(scaled.field.scalar(place).gradient, -3.0 * wave.gradient);
        EXPECT_EQ(clamped.field.scalar(place).value, std::clamp(wave.value, -0.2, 0.4));
        const bool inside = wave.value >= -0.2 && wave.value <= 0.4;
        EXPECT_EQ(clamped.field.scalar(place).gradient, inside ? wave.gradient : vec3(0));
        EXPECT_EQ(scaled_flow.field.vector(place).value, -3.0 * twist(place).value);
        EXPECT_EQ(curl(scaled_flow.field.vector(place)), curl(scaled_flow.quick.vector(place)));
        EXPECT_LE(glm::length(curl(scaled_flow.field.vector(place)) + 3.0 * curl(twist(place))), 1e-12);
    }
    const auto still = [](vec3) { return Vector{}; };
    put(length, formula({{}, field_of<Vector>(still)}, 0.1), {{FilterKind::magnitude}});
    EXPECT_EQ(length.field.scalar(vec3(0)).gradient, vec3(0));
}

TEST(Filters, DerivativesOfFormulasAreExactAndTheirsOfSecondOrder) {
    FilteredField f;
    double curl_error[2]{}, laplace_error[2]{};
    for (const int fine : {0, 1}) {
        Random random = random_stream(2, 2);
        const double h = fine == 1 ? 0.01 : 0.02;
        for (int run = 0; run < 300; ++run) {
            const vec3 place = place_within(random, 0.9);
            put(f, of_beltrami(h), {{FilterKind::curl}});
            const Vector turning = f.field.vector(place), flow = twist(place);
            EXPECT_LE(glm::length(turning.value - twist.wave * flow.value), 1e-12);
            for (std::size_t i = 0; i < 3; ++i) {
                const vec3 off = turning.gradient[i] - twist.wave * flow.gradient[i];
                curl_error[fine] = std::max(curl_error[fine], glm::length(off));
            }
            put(f, of_gyroid(h), {{FilterKind::gradient}, {FilterKind::divergence}});
            const double k = 2 * pi / wavy.period;
            const double laplace = -2 * k * k * wavy(place).value;
            laplace_error[fine] =
                std::max(laplace_error[fine], std::abs(f.field.scalar(place).value - laplace));
            put(f, of_gyroid(h), {{FilterKind::gradient}, {FilterKind::curl}});
            EXPECT_LE(glm::length(f.field.vector(place).value), 1e-12 * k * k / h) << "no curl";
            put(f, of_beltrami(h), {{FilterKind::curl}, {FilterKind::divergence}});
            EXPECT_LE(std::abs(f.field.scalar(place).value), 1e-11 / h) << "no divergence";
        }
    }
    EXPECT_NEAR(std::log2(curl_error[0] / curl_error[1]), 2, 0.05);
    EXPECT_NEAR(std::log2(laplace_error[0] / laplace_error[1]), 2, 0.05);
    EXPECT_LE(curl_error[1], 0.02 * twist.wave * twist.wave);
}

TEST(Filters, QuickValuesAreTheValues) {
    const auto chains = std::to_array<std::vector<Filter>>(
        {{{FilterKind::curl}, {FilterKind::magnitude}, {FilterKind::clamp, 1, 3}},
         {{FilterKind::magnitude}, {FilterKind::gradient}, {FilterKind::scale, 2, 0}},
         {{FilterKind::divergence}, {FilterKind::scale, 2, 5}},
         {{FilterKind::curl}, {FilterKind::curl}, {FilterKind::magnitude}}});
    Random random = random_stream(3, 3);
    for (const auto& chain : chains) {
        FilteredField f;
        ASSERT_TRUE(set_filters(f, of_beltrami(0.05), chain));
        for (int run = 0; run < 100; ++run) {
            const vec3 place = place_within(random, 1.2);
            if (f.field.is_vector()) {
                EXPECT_EQ(f.field.vector(place).value, f.quick.vector(place).value);
            } else {
                EXPECT_EQ(f.field.scalar(place).value, f.quick.scalar(place).value);
            }
        }
    }
}

// ---- filters of samples -----------------------------------------------------------------------------------

/// Root mean square error of the curl's length and of its gradient, from samples `spacing` apart.
std::array<double, 2> sampled_errors(double spacing, Kernel kernel) {
    const SampledSource samples(of_beltrami(spacing), kernel);
    FilteredField found, exact;
    put(found, samples.source(), {{FilterKind::curl}, {FilterKind::magnitude}});
    put(exact, of_beltrami(1e-4), {{FilterKind::curl}, {FilterKind::magnitude}});
    Random random = random_stream(4, 4);
    double value = 0, slope = 0;
    constexpr int places = 2000;
    for (int i = 0; i < places; ++i) {
        const vec3 place = place_within(random, 0.8);
        const Scalar a = found.field.scalar(place), b = exact.field.scalar(place);
        value += (a.value - b.value) * (a.value - b.value) / places;
        slope += glm::dot(a.gradient - b.gradient, a.gradient - b.gradient) / places;
    }
    return {std::sqrt(value), std::sqrt(slope)};
}

TEST(Filters, GradientsOfDerivedQuantitiesConvergeInTheOrdersPromised) {
    for (const Kernel kernel : {Kernel::linear, Kernel::catmull_rom}) {
        const auto coarse = sampled_errors(0.05, kernel), fine = sampled_errors(0.025, kernel);
        const double order = kernel == Kernel::linear ? 1 : 2;
        EXPECT_NEAR(std::log2(coarse[0] / fine[0]), order, 0.35);
        EXPECT_NEAR(std::log2(coarse[1] / fine[1]), order, 0.35);
        RecordProperty(kernel == Kernel::linear ? "linear_slope" : "cubic_slope",
                       std::to_string(fine[1] / (twist.wave * twist.wave)));
    }
}

TEST(Filters, ThePlacesAtTheEdgeAndBeyondAreFinite) {
    const SampledSource samples(of_gyroid(0.1), Kernel::catmull_rom);
    FilteredField f;
    put(f, samples.source(), {{FilterKind::gradient}, {FilterKind::divergence}});
    // A linear source has no second derivatives, also at the outermost samples and beyond.
    const Plane plane{{}, {0, 1, 0}};
    const SampledSource flat(formula({field_of<Scalar>(plane), {}}, 0.1), Kernel::catmull_rom);
    FilteredField g;
    put(g, flat.source(), {{FilterKind::gradient}});
    for (const double x : {-5.0, -1.0, -0.999, 0.0, 0.95, 1.0, 1.2}) {
        EXPECT_TRUE(std::isfinite(f.field.scalar({x, 0.3, -x}).value));
        const Vector slope = g.field.vector({x, 0.3, -x});
        EXPECT_LE(glm::length(slope.value - vec3(0, -1, 0)), 1e-5);
        for (const vec3 row : slope.gradient) EXPECT_LE(glm::length(row), 1e-4);
    }
    EXPECT_EQ(f.field.scalar({nowhere, 0, 0}).value, 0);
}

// ---- smoothing of samples ---------------------------------------------------------------------------------

/// Smooths a sample along one axis by the definition of the sum, adding in the same order.
float smoothed_sample(const Volume& v, std::array<int, 3> at, int axis, int component,
                      const std::vector<double>& weights) {
    const auto a = static_cast<std::size_t>(axis);
    const auto value = [&](int n) {
        auto place = at;
        place[a] = std::clamp(at[a] + n, 0, v.count[a] - 1);
        const int voxel = place[0] + v.count[0] * (place[1] + v.count[1] * place[2]);
        const auto all = static_cast<std::size_t>(v.components);
        return double{v.samples[all * static_cast<std::size_t>(voxel) + static_cast<std::size_t>(component)]};
    };
    double sum = weights[0] * value(0);
    for (int n = 1; n < static_cast<int>(weights.size()); ++n)
        sum += weights[static_cast<std::size_t>(n)] * (value(-n) + value(n));
    return static_cast<float>(sum);
}

TEST(Smoothing, ManyLinesAtOnceGiveTheBitsOfOneSample) {
    for (const int components : {1, 3}) {
        Volume v{.count = {7, 5, 11}, .spacing = vec3(1), .components = components};
        for (int i = 0; i < 7 * 5 * 11 * components; ++i)
            v.samples.floats().push_back(static_cast<float>((i * 7919) % 101) / 7);
        const double deviation = 1.3;
        std::vector<double> weights(7);
        double all = 0;
        for (std::size_t n = 0; n < weights.size(); ++n) {
            const double x = static_cast<double>(n) / deviation;
            weights[n] = det::exp(-0.5 * x * x);
            all += (n == 0 ? 1 : 2) * weights[n];
        }
        for (double& weight : weights) weight /= all;
        Volume wanted = v;
        for (int axis = 0; axis < 3; ++axis) {
            const Volume before = wanted;
            std::size_t at = 0;
            for (int k = 0; k < 11; ++k)
                for (int j = 0; j < 5; ++j)
                    for (int i = 0; i < 7; ++i)
                        for (int c = 0; c < components; ++c)
                            wanted.samples.floats()[at++] =
                                smoothed_sample(before, {i, j, k}, axis, c, weights);
        }
        smooth(v, deviation);
        EXPECT_EQ(v.samples, wanted.samples) << components;
    }
}

TEST(Filters, SmoothingKeepsConstantsAndSlopesAndDampsWavesByTheLaw) {
    const double spacing = 0.05, deviation = 1.5;
    const auto source = [](vec3 p) { return Scalar{2 + 3 * p.y + 0.5 * det::sin(8 * p.x), {}}; };
    Volume volume = sampled(field_of<Scalar>(source), {61, 41, 41}, vec3(spacing));
    smooth(volume, deviation);
    const double damping = std::exp(-0.5 * 8 * 8 * deviation * deviation * spacing * spacing);
    for (int i = 8; i < 53; ++i) {
        for (int j = 8; j < 33; ++j) {
            const vec3 at = volume.place(i, j, 20);
            const int at_sample = i + 61 * (j + 41 * 20);
            const double found = volume.samples[static_cast<std::size_t>(at_sample)];
            EXPECT_NEAR(found, 2 + 3 * at.y + damping * 0.5 * std::sin(8 * at.x), 1e-4);
        }
    }
}

TEST(Filters, SmoothingAnyVolumeStaysWithinItsRange) {
    Random random = random_stream(5, 5);
    Volume volume{.count = {1, 2, 5}, .components = 3};
    for (int i = 0; i < 30; ++i) volume.samples.floats().push_back(static_cast<float>(random.uniform(-1, 1)));
    const SampleRange before = range_of(volume);
    for (const double deviation : {0.0, 1e-9, 0.3, 16.0, 1e9}) {
        smooth(volume, deviation);
        EXPECT_GE(range_of(volume).low, before.low);
        EXPECT_LE(range_of(volume).high, before.high);
    }
}

TEST(Filters, SamplesAreSmoothedOnlyWhenTheirInputChanges) {
    const SampledSource samples(of_gyroid(0.2), Kernel::catmull_rom);
    FilterSource source = samples.source();
    FilteredField f;
    std::vector<Filter> chain{{FilterKind::scale, 2, 0}, {FilterKind::smooth, 1}, {FilterKind::clamp, -1, 1}};
    const auto smoothings = [&] {
        EXPECT_TRUE(set_filters(f, source, chain));
        return f.smoothings;
    };
    EXPECT_EQ(smoothings(), 1);
    EXPECT_EQ(smoothings(), 1) << "nothing has changed";
    const double before = f.field.scalar(vec3(0.1)).value;
    chain[2].a = -0.5;
    EXPECT_EQ(smoothings(), 1) << "a later filter has changed";
    EXPECT_NE(f.field.scalar(vec3(0.1)).value, before);
    chain[1].a = 1.5;
    EXPECT_EQ(smoothings(), 2);
    chain[0].a = 3;
    EXPECT_EQ(smoothings(), 3) << "an earlier filter has changed";
    ++source.version;
    EXPECT_EQ(smoothings(), 4) << "the data have changed";
    chain.push_back({FilterKind::smooth, 1});
    EXPECT_EQ(smoothings(), 5) << "only the new one";
    chain.pop_back();
    EXPECT_EQ(smoothings(), 5);
}

TEST(Filters, AVectorIsSmoothedInEachComponent) {
    const SampledSource samples(of_beltrami(0.1), Kernel::catmull_rom);
    FilteredField f;
    put(f, samples.source(), {{FilterKind::smooth, 1}});
    // Each term is a wave along one axis, so its damping depends on that axis's spacing.
    const vec3 h = samples.volume.spacing;
    const auto damped = [](double spacing) { return std::exp(-0.5 * 16 * spacing * spacing); };
    const auto exact = [&](vec3 p) {
        const vec3 x = twist.wave * p, c = twist.strength;
        return vec3(c.x * damped(h.z) * std::sin(x.z) + c.z * damped(h.y) * std::cos(x.y),
                    c.y * damped(h.x) * std::sin(x.x) + c.x * damped(h.z) * std::cos(x.z),
                    c.z * damped(h.y) * std::sin(x.y) + c.y * damped(h.x) * std::cos(x.x));
    };
    Random random = random_stream(6, 6);
    for (int run = 0; run < 200; ++run) {
        const vec3 place = place_within(random, 0.5);
        EXPECT_LE(glm::length(f.field.vector(place).value - exact(place)), 0.01);
    }
    EXPECT_LT(damped(h.x), 0.95) << "so that the test sees the damping";
}

// ---- chains of filters that do not fit together -----------------------------------------------------------

TEST(Filters, ChainsThatDoNotFitAreRefusedAndChangeNothing) {
    FilteredField f;
    put(f, of_gyroid(0.1), {{FilterKind::scale, 2, 0}});
    const auto message = [&](const FilterSource& source, const std::vector<Filter>& chain) {
        return message_of(set_filters(f, source, chain));
    };
    const FilterSource scalar = of_gyroid(0.1), vector = of_beltrami(0.1);
    EXPECT_EQ(message(scalar, {{FilterKind::curl}}), "filter 1 (curl) needs a vector, but gets a scalar");
    EXPECT_EQ(message(vector, {{FilterKind::magnitude}, {FilterKind::divergence}}),
              "filter 2 (divergence) needs a vector, but gets a scalar");
    EXPECT_EQ(message(vector, {{FilterKind::gradient}}),
              "filter 1 (gradient) needs a scalar, but gets a vector");
    EXPECT_NE(message(vector, {{FilterKind::clamp, 0, 1}}).find("needs a scalar"), std::string::npos);
    EXPECT_NE(message(vector, {{FilterKind::scale, 1, 1}}).find("set b to 0"), std::string::npos);
    EXPECT_NE(message(scalar, {{FilterKind::scale, nowhere, 1}}).find("no number"), std::string::npos);
    EXPECT_NE(message(scalar, {{FilterKind::clamp, 2, 1}}).find("wrong order"), std::string::npos);
    for (const double deviation : {-1.0, 16.5, nowhere})
        EXPECT_NE(message(scalar, {{FilterKind::smooth, deviation}}).find("0 to 16"), std::string::npos);
    EXPECT_NE(message(scalar, std::vector<Filter>(9, {FilterKind::scale, 1, 0})).find("more than 8"),
              std::string::npos);
    EXPECT_EQ(f.field.scalar(vec3(0.3)).value, 2 * wavy(vec3(0.3)).value);
    EXPECT_EQ(f.smoothings, 0);
}

}  // namespace
}  // namespace thaum::field
