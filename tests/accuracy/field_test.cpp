// Tests of fields between their samples: accuracy of each kernel, also at borders, and results for positions
// that are NaN and for grids without samples.
#include "field/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/random.h"
#include "fluid/fields.h"
#include "fluid/ghosts.h"

namespace thaum::field {
namespace {

constexpr std::array kernels{Kernel::linear, Kernel::catmull_rom};

/// Samples with padding at the end of each row. The padding holds NaN, so a result becomes NaN if it wrongly
/// uses the padding.
struct Stored {
    std::vector<float> values;
    Grid grid;
};

Stored stored(std::array<int, 3> count, vec3 origin, vec3 spacing, Kernel kernel,
              const std::function<double(vec3)>& value) {
    const std::ptrdiff_t row = count[0] + 1, plane = row * count[1];
    Stored result{
        std::vector<float>(static_cast<std::size_t>(plane * count[2]),
                           std::numeric_limits<float>::quiet_NaN()),
        {.count = count, .stride = {1, row, plane}, .origin = origin, .spacing = spacing, .kernel = kernel}};
    for (int k = 0; k < count[2]; ++k) {
        for (int j = 0; j < count[1]; ++j) {
            for (int i = 0; i < count[0]; ++i)
                result.values[static_cast<std::size_t>(i + j * row + k * plane)] =
                    static_cast<float>(value(origin + spacing * vec3(i, j, k)));
        }
    }
    result.grid.first = result.values.data();
    return result;
}

vec3 random_place(Random& random, vec3 low, vec3 high) {
    return {random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.z, high.z)};
}

/// Polynomial of degree 1 or 2 along each axis, with all products. Its values at multiples of 1/8 are exact
/// in float.
Scalar polynomial(int degree, vec3 p) {
    const bool square = degree == 2;
    const auto f = [&](double x, double a, double b) { return 1 + a * x + (square ? b * x * x : 0); };
    const auto d = [&](double x, double a, double b) { return a + (square ? 2 * b * x : 0); };
    const double x = f(p.x, 0.5, -0.25), y = f(p.y, -1, 0.5), z = f(p.z, 0.25, 0.5);
    return {x * y * z, {d(p.x, 0.5, -0.25) * y * z, x * d(p.y, -1, 0.5) * z, x * y * d(p.z, 0.25, 0.5)}};
}

void expect_same(const Scalar& found, const Scalar& exact, double tolerance, vec3 place) {
    EXPECT_NEAR(found.value, exact.value, tolerance) << place.x << ' ' << place.y << ' ' << place.z;
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found.gradient[axis], exact.gradient[axis], tolerance)
            << axis << ": " << place.x << ' ' << place.y << ' ' << place.z;
}

TEST(FieldAccuracy, PolynomialsOfTheDegreePromisedAreExactUpToTheOutermostSamples) {
    Random random = random_stream(1, 1);
    for (const Kernel kernel : kernels) {
        const int degree = kernel == Kernel::catmull_rom ? 2 : 1;
        for (const std::array<int, 3> count : {std::array{7, 4, 5}, std::array{3, 3, 3}}) {
            const vec3 origin(-0.5, 1, 0.25), spacing(0.25, 0.5, 0.125);
            const Stored s =
                stored(count, origin, spacing, kernel, [&](vec3 p) { return polynomial(degree, p).value; });
            const vec3 end = origin + spacing * vec3(count[0] - 1, count[1] - 1, count[2] - 1);
            for (int i = 0; i < 200; ++i) {
                const vec3 place = random_place(random, origin, end);
                expect_same(s.grid(place), polynomial(degree, place), 1e-12, place);
            }
            expect_same(s.grid(origin), polynomial(degree, origin), 1e-12, origin);
            expect_same(s.grid(end), polynomial(degree, end), 1e-12, end);
        }
    }
}

Scalar wave(vec3 p) {
    const double sx = std::sin(3 * p.x), cx = std::cos(3 * p.x), sy = std::sin(2 * p.y),
                 cy = std::cos(2 * p.y), sz = std::sin(4 * p.z), cz = std::cos(4 * p.z);
    return {sx * cy * cz, {3 * cx * cy * cz, -2 * sx * sy * cz, -4 * sx * cy * sz}};
}

struct Errors {
    double value{}, gradient{};
};

/// Root mean square errors of value and gradient between samples, n intervals a side, over the unit box.
Errors errors_of(int n, Kernel kernel) {
    const Stored s =
        stored({n + 1, n + 1, n + 1}, {}, vec3(1.0 / n), kernel, [](vec3 p) { return wave(p).value; });
    Random random = random_stream(2, 2);
    Errors sum;
    constexpr int places = 4000;
    for (int i = 0; i < places; ++i) {
        const vec3 place = random_place(random, {}, vec3(1));
        const Scalar found = s.grid(place), exact = wave(place);
        const vec3 off = found.gradient - exact.gradient;
        sum.value += (found.value - exact.value) * (found.value - exact.value) / places;
        sum.gradient += glm::dot(off, off) / places;
    }
    return {std::sqrt(sum.value), std::sqrt(sum.gradient)};
}

TEST(FieldAccuracy, KernelsConvergeInTheOrdersPromised) {
    struct Promise {
        Kernel kernel;
        double value, gradient;
    };
    for (const Promise& promise : {Promise{Kernel::linear, 2, 1}, Promise{Kernel::catmull_rom, 3, 2}}) {
        const Errors coarse = errors_of(20, promise.kernel), fine = errors_of(40, promise.kernel);
        EXPECT_NEAR(std::log2(coarse.value / fine.value), promise.value, 0.25)
            << static_cast<int>(promise.kernel);
        EXPECT_NEAR(std::log2(coarse.gradient / fine.gradient), promise.gradient, 0.25)
            << static_cast<int>(promise.kernel);
    }
}

TEST(FieldAccuracy, TheGradientIsTheValues) {
    Random random = random_stream(3, 3);
    for (const Kernel kernel : kernels) {
        const Stored s =
            stored({6, 7, 5}, {}, vec3(0.5), kernel, [&](vec3) { return random.uniform(-1, 1); });
        for (int i = 0; i < 300; ++i) {
            const vec3 place = random_place(random, vec3(0), {2.5, 3, 2});
            const Scalar here = s.grid(place);
            for (int axis = 0; axis < 3; ++axis) {
                vec3 step(0);
                step[axis] = 1e-6;
                const double cell = (place[axis] - 1e-6) / 0.5, next = (place[axis] + 1e-6) / 0.5;
                // Skips places beside a cell's border, where the linear kernel has a kink.
                if (std::floor(cell) != std::floor(next)) continue;
                const double rise = (s.grid(place + step).value - s.grid(place - step).value) / 2e-6;
                EXPECT_NEAR(here.gradient[axis], rise, 1e-8);
            }
        }
    }
}

TEST(FieldAccuracy, NothingJumpsBetweenCellsButTheLinearGradient) {
    Random random = random_stream(4, 4);
    for (const Kernel kernel : kernels) {
        const Stored s =
            stored({6, 7, 5}, {}, vec3(0.5), kernel, [&](vec3) { return random.uniform(-1, 1); });
        double most = 0;
        for (int i = 0; i < 300; ++i) {
            vec3 place = random_place(random, vec3(0), {2.5, 3, 2});
            const int axis = i % 3;
            place[axis] = 0.5 * (1 + static_cast<double>(random.below(3)));
            vec3 step(0);
            step[axis] = 1e-10;
            const Scalar before = s.grid(place - step), after = s.grid(place + step);
            EXPECT_NEAR(before.value, after.value, 1e-8);
            most = std::max(most, glm::length(before.gradient - after.gradient));
        }
        if (kernel == Kernel::linear) {
            EXPECT_GT(most, 0.1);
        } else {
            EXPECT_LT(most, 1e-7);
        }
    }
}

TEST(Field, PlacesOutsideTakeTheNearestValue) {
    const Stored s =
        stored({5, 5, 5}, {1, 1, 1}, vec3(0.5), Kernel::catmull_rom, [](vec3 p) { return wave(p).value; });
    const auto same = [&](vec3 outside, vec3 nearest) {
        expect_same(s.grid(outside), s.grid(nearest), 0, outside);
    };
    same({0, 2, 2.2}, {1, 2, 2.2});
    same({9, 2, 2.2}, {3, 2, 2.2});
    same({-1e300, 1e300, 2.2}, {1, 3, 2.2});
    same({1.3, 1.4, -7}, {1.3, 1.4, 1});
}

TEST(Field, NaNAndMissingSamplesGiveZeros) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Stored s = stored({5, 5, 5}, {}, vec3(0.5), Kernel::linear, [](vec3) { return 3; });
    EXPECT_EQ(s.grid({1, 1, 1}).value, 3);
    for (const vec3 place : {vec3(none, 1, 1), vec3(1, endless, 1), vec3(1, 1, -endless)}) {
        EXPECT_EQ(s.grid(place).value, 0);
        EXPECT_EQ(s.grid(place).gradient, vec3(0));
    }
    EXPECT_EQ(Grid{}({1, 1, 1}).value, 0);
    EXPECT_EQ(StaggeredGrid{}({1, 1, 1}).value, vec3(0));
    Grid flat = s.grid;
    flat.count = {5, 0, 5};
    EXPECT_EQ(flat({1, 1, 1}).value, 0);
}

TEST(Field, TheValueAloneHasTheSameBits) {
    Random random = random_stream(5, 5);
    for (const Kernel kernel : kernels) {
        for (const std::array<int, 3> count :
             {std::array{6, 7, 5}, std::array{2, 2, 2}, std::array{1, 3, 2}}) {
            const Stored s = stored(count, {0.1, 0.2, 0.3}, {0.5, 0.3, 0.7}, kernel,
                                    [&](vec3) { return random.uniform(-1, 1); });
            for (int i = 0; i < 300; ++i) {
                const vec3 place = random_place(random, vec3(-1), vec3(4));
                EXPECT_EQ(s.grid.value(place), s.grid(place).value);
            }
            EXPECT_EQ(s.grid.value(vec3(HUGE_VAL)), 0);
        }
    }
    EXPECT_EQ(Grid{}.value({1, 1, 1}), 0);
}

TEST(Field, EqualSamplesHaveTheirValueAndNoGradient) {
    Random random = random_stream(6, 6);
    for (const Kernel kernel : kernels) {
        for (const float all : {0.1F, 255.0F, -1000.0F, 1e30F}) {
            const Stored s =
                stored({6, 7, 5}, {}, {0.5, 0.3, 0.7}, kernel, [&](vec3) { return double{all}; });
            for (int i = 0; i < 100; ++i) {
                const vec3 place = random_place(random, vec3(-1), vec3(4));
                EXPECT_EQ(s.grid(place).value, double{all});
                EXPECT_EQ(s.grid(place).gradient, vec3(0));
            }
        }
    }
}

TEST(Field, OneSampleIsAConstantAndTwoALine) {
    for (const Kernel kernel : kernels) {
        const Stored s = stored({1, 2, 4}, {}, vec3(1), kernel, [](vec3 p) { return 2 + 3 * p.y - p.z; });
        expect_same(s.grid({0.7, 0.25, 1.5}), {2 + 0.75 - 1.5, {0, 3, -1}}, 1e-12, {});
    }
}

// ---- fields of vectors ------------------------------------------------------------------------------------

/// Rigid rotation plus stretching. Its curl is (2, -4, 6) and its divergence 0.75.
struct Whirl {
    Vector operator()(vec3 p) const {
        const vec3 spin(1, -2, 3), stretch(0.5, -0.25, 0.5);
        Vector v{glm::cross(spin, p) + stretch * p, {}};
        v.gradient = {
            vec3{stretch.x, -spin.z, spin.y}, {spin.z, stretch.y, -spin.x}, {-spin.y, spin.x, stretch.z}};
        return v;
    }
};

TEST(FieldVector, FormulasAndSamplesAreReadAlike) {
    const Whirl whirl;
    StaggeredGrid grids;
    std::array<Stored, 3> components;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        vec3 origin(0.25);
        origin[static_cast<int>(axis)] = 0;
        components[axis] = stored({5, 6, 4}, origin, vec3(0.5), Kernel::catmull_rom,
                                  [&](vec3 p) { return whirl(p).value[static_cast<int>(axis)]; });
        grids.component[axis] = components[axis].grid;
    }
    for (const VectorField& field : {field_of<Vector>(whirl), field_of<Vector>(grids)}) {
        const vec3 place(0.7, 0.9, 1.1);
        const Vector v = field(place);
        EXPECT_NEAR(glm::length(v.value - whirl(place).value), 0, 1e-12);
        EXPECT_NEAR(glm::length(curl(v) - vec3(2, -4, 6)), 0, 1e-12);
        EXPECT_NEAR(divergence(v), 0.75, 1e-12);
    }
    const ScalarField height = field_of<Scalar>(components[1].grid);
    EXPECT_NEAR(height({0.7, 0.9, 1.1}).gradient.x, 3, 1e-12);
}

/// Velocity of a vortex: u = sin pi x cos pi y, v = -cos pi x sin pi y. It crosses no wall of the unit box.
Vector box_vortex(vec3 p) {
    const double sx = std::sin(pi * p.x), cx = std::cos(pi * p.x), sy = std::sin(pi * p.y),
                 cy = std::cos(pi * p.y);
    return {{sx * cy, -cx * sy, 0},
            {vec3{pi * cx * cy, -pi * sx * sy, 0}, {pi * sx * sy, -pi * cx * cy, 0}, {0, 0, 0}}};
}

/// Largest errors of the velocity and of its curl in the box, walls included.
Errors fluid_errors(int n) {
    using namespace fluid;
    const Lattice l = make_lattice({n, n, 4}, 1.0 / n, {Edge::free_slip, Edge::free_slip, Edge::free_slip});
    std::array<Samples, 3> velocity{make_samples(l), make_samples(l), make_samples(l)};
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const auto at = static_cast<std::size_t>(l.at(i, j, k));
                velocity[0][at] = static_cast<float>(box_vortex(l.h * vec3(i, j + 0.5, 0)).value.x);
                velocity[1][at] = static_cast<float>(box_vortex(l.h * vec3(i + 0.5, j, 0)).value.y);
            }
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        fill_ghosts(l, ghost_rules_of_velocity(l, axis), velocity[axis]);
    const StaggeredGrid grid = face_grid(l, velocity);
    Random random = random_stream(6, 6);
    Errors most;
    for (int i = 0; i < 3000; ++i) {
        vec3 place = random_place(random, vec3(0), {1, 1, 4 * l.h});
        if (i % 4 == 0) place[i / 4 % 2] = static_cast<double>(i / 8 % 2);  // every fourth point is on a wall
        const Vector found = grid(place), exact = box_vortex(place);
        most.value = std::max(most.value, glm::length(found.value - exact.value));
        most.gradient = std::max(most.gradient, glm::length(curl(found) - curl(exact)));
        if (place.x == 0 || place.x == 1) {
            EXPECT_NEAR(found.value.x, 0, 1e-15);
        }
    }
    return most;
}

TEST(FieldVector, AFluidsVelocityIsReadWithItsCurlUpToTheWalls) {
    const Errors coarse = fluid_errors(16), fine = fluid_errors(32);
    EXPECT_LT(fine.value, 1e-3);
    EXPECT_GE(std::log2(coarse.value / fine.value), 2.7);
    EXPECT_GE(std::log2(coarse.gradient / fine.gradient), 1.7);
}

TEST(FieldVector, ADensityStandsInTheMiddlesOfCells) {
    using namespace fluid;
    const Lattice l = make_lattice({6, 5, 4}, 0.5, {Edge::free_slip, Edge::free_slip, Edge::free_slip});
    Samples density = make_samples(l);
    density[static_cast<std::size_t>(l.at(2, 1, 3))] = 1;
    EXPECT_NEAR(cell_grid(l, density)({1.25, 0.75, 1.75}).value, 1, 1e-15);
    EXPECT_NEAR(cell_grid(l, density, Kernel::linear)({1.25, 0.5, 1.75}).value, 0.5, 1e-15);
}

}  // namespace
}  // namespace thaum::field
