// Tests of analytic fields against difference quotients, of sampled volumes against analytic fields, and of
// placements: a volume that is moved, rotated and scaled has the same values in a frame that is transformed
// likewise.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/random.h"
#include "field/analytic.h"
#include "field/placement.h"
#include "field/volume.h"

namespace thaum::field {
namespace {

vec3 random_place(Random& random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

Placement random_placement(Random& random) {
    const vec3 axis = glm::normalize(random_place(random, 1) + vec3(0, 2, 0));
    return {random_place(random, 3), glm::mat3_cast(rotation(axis, random.uniform(-3, 3))),
            random.uniform(0.2, 5)};
}

const Sphere sphere{{0.1, -0.05, 0.02}, 0.6};
const Plane plane{{0.1, 0.2, 0.3}, glm::normalize(vec3(1, -2, 3))};
const Gyroid gyroid{1.3, {0.1, 0.2, 0.3}};
const RankineVortex vortex{{0.1, 0, -0.1}, glm::normalize(vec3(1, 2, -0.5)), 0.3, 1.5};
const BeltramiFlow beltrami{{1, 0.8, 0.6}, 4};
const VortexFlow orb = make_vortex_flow(2, 7);

struct NamedScalar {
    const char* name;
    ScalarField field;
};
struct NamedVector {
    const char* name;
    VectorField field;
};

std::vector<NamedScalar> scalars() {
    return {{"sphere", field_of<Scalar>(sphere)},
            {"plane", field_of<Scalar>(plane)},
            {"gyroid", field_of<Scalar>(gyroid)}};
}

std::vector<NamedVector> vectors() {
    return {{"vortex", field_of<Vector>(vortex)},
            {"beltrami", field_of<Vector>(beltrami)},
            {"orb", field_of<Vector>(orb)}};
}

// ---- fields given by formulas -----------------------------------------------------------------------------

TEST(AnalyticField, GradientsAreTheValues) {
    Random random = random_stream(1, 1);
    constexpr double h = 1e-5;
    for (int run = 0; run < 400; ++run) {
        const vec3 place = random_place(random, 1);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0);
            step[axis] = h;
            for (const auto& [name, field] : scalars()) {
                // Skips the centre, where the gradient is undefined.
                if (glm::length(place - sphere.middle) < 0.05) continue;
                const double slope = (field(place + step).value - field(place - step).value) / (2 * h);
                EXPECT_NEAR(field(place).gradient[axis], slope, 1e-6) << name;
            }
            for (const auto& [name, field] : vectors()) {
                const Vector low = field(place - step), high = field(place + step), here = field(place);
                for (int i = 0; i < 3; ++i) {
                    const auto row = static_cast<std::size_t>(i);
                    // skips the edge of a vortex's core, where the gradient jumps
                    if (std::abs(high.gradient[row][axis] - low.gradient[row][axis]) > 0.1) continue;
                    EXPECT_NEAR(here.gradient[row][axis], (high.value[i] - low.value[i]) / (2 * h), 1e-6)
                        << name;
                }
            }
        }
    }
}

TEST(AnalyticField, CurlsAndDivergencesAreThoseOfTheBooks) {
    Random random = random_stream(2, 2);
    for (int run = 0; run < 400; ++run) {
        const vec3 place = random_place(random, 1);
        const Vector flow = beltrami(place);
        EXPECT_LE(glm::length(curl(flow) - beltrami.wave * flow.value), 1e-12);
        const vec3 off = place - vortex.middle;
        const double distance = glm::length(glm::cross(off, vortex.axis));
        const vec3 exact =
            distance < vortex.radius ? 2 * vortex.speed / vortex.radius * vortex.axis : vec3(0);
        EXPECT_LE(glm::length(curl(vortex(place)) - exact), 1e-12);
        const double speed = vortex.speed * std::min(distance / vortex.radius, vortex.radius / distance);
        EXPECT_NEAR(glm::length(vortex(place).value), speed, 1e-12);
        for (const auto& [name, field] : vectors()) EXPECT_NEAR(divergence(field(place)), 0, 1e-12) << name;
    }
    EXPECT_EQ(glm::length(vortex(vortex.middle).value), 0);
}

TEST(AnalyticField, SurfacesAreWhereTheyShouldBe) {
    EXPECT_NEAR(sphere(sphere.middle + vec3(0, 0.6, 0)).value, 0, 1e-15);
    EXPECT_EQ(sphere(sphere.middle).value, 0.6);
    EXPECT_EQ(sphere(sphere.middle).gradient, vec3(0));
    EXPECT_NEAR(plane(plane.through - 0.3 * plane.normal).value, 0.3, 1e-15);
    EXPECT_NEAR(gyroid(gyroid.phase).value, 0, 1e-15);
}

// ---- fields given by samples ------------------------------------------------------------------------------

struct VolumeErrors {
    double value{}, gradient{}, curl{};  ///< root mean square errors of the value, its gradient and the curl
};

/// Errors of a sampled field. The spacing is different along each axis. Samples lie in a box of about 2 m.
VolumeErrors volume_errors(const ScalarField& field, int n, Kernel kernel,
                           const std::function<bool(vec3)>& smooth) {
    const Volume volume = sampled(field, {n, n * 3 / 2, n * 3 / 4}, 2.0 / vec3(n, n * 1.5, n * 0.75));
    const Grid grid = volume.grid(kernel);
    Random random = random_stream(3, 3);
    VolumeErrors sum;
    constexpr int places = 3000;
    for (int i = 0; i < places; ++i) {
        const vec3 place = random_place(random, 0.9);
        if (!smooth(place)) continue;
        const Scalar found = grid(place), exact = field(place);
        const vec3 off = found.gradient - exact.gradient;
        sum.value += (found.value - exact.value) * (found.value - exact.value) / places;
        sum.gradient += glm::dot(off, off) / places;
    }
    return {std::sqrt(sum.value), std::sqrt(sum.gradient), 0};
}

VolumeErrors volume_errors(const VectorField& field, int n, Kernel kernel,
                           const std::function<bool(vec3)>& smooth) {
    const Volume volume = sampled(field, {n, n * 3 / 2, n * 3 / 4}, 2.0 / vec3(n, n * 1.5, n * 0.75));
    const StaggeredGrid grid = volume.vector_grid(kernel);
    Random random = random_stream(4, 4);
    VolumeErrors sum;
    constexpr int places = 3000;
    for (int i = 0; i < places; ++i) {
        const vec3 place = random_place(random, 0.9);
        if (!smooth(place)) continue;
        const Vector found = grid(place), exact = field(place);
        const vec3 off = found.value - exact.value, curl_off = curl(found) - curl(exact);
        sum.value += glm::dot(off, off) / places;
        sum.curl += glm::dot(curl_off, curl_off) / places;
        for (std::size_t row = 0; row < 3; ++row) {
            const vec3 slope = found.gradient[row] - exact.gradient[row];
            sum.gradient += glm::dot(slope, slope) / places;
        }
    }
    return {std::sqrt(sum.value), std::sqrt(sum.gradient), std::sqrt(sum.curl)};
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// Whether sphere and vortex are smooth at all samples that the kernel reads for this point, even on the
/// coarsest grid. Only such points are compared.
bool is_smooth(vec3 p) {
    if (glm::length(p - sphere.middle) < 0.3) return false;
    return std::abs(glm::length(glm::cross(p - vortex.middle, vortex.axis)) - vortex.radius) > 0.15;
}

bool is_everywhere_smooth(vec3) { return true; }

TEST(SampledVolume, ValuesGradientsAndCurlsConvergeInTheOrdersOfTheKernels) {
    struct Promise {
        Kernel kernel;
        double value, slope;
    };
    for (const Promise& promise : {Promise{Kernel::linear, 2, 1}, Promise{Kernel::catmull_rom, 3, 2}}) {
        for (const ScalarField& field : {field_of<Scalar>(sphere), field_of<Scalar>(gyroid)}) {
            const VolumeErrors coarse = volume_errors(field, 32, promise.kernel, is_smooth);
            const VolumeErrors fine = volume_errors(field, 64, promise.kernel, is_smooth);
            EXPECT_NEAR(order(coarse.value, fine.value), promise.value, 0.4);
            EXPECT_NEAR(order(coarse.gradient, fine.gradient), promise.slope, 0.3);
        }
        for (const VectorField& field : {field_of<Vector>(vortex), field_of<Vector>(beltrami)}) {
            const VolumeErrors coarse = volume_errors(field, 32, promise.kernel, is_smooth);
            const VolumeErrors fine = volume_errors(field, 64, promise.kernel, is_smooth);
            EXPECT_NEAR(order(coarse.value, fine.value), promise.value, 0.4);
            EXPECT_NEAR(order(coarse.gradient, fine.gradient), promise.slope, 0.3);
            // In the vortex's outer flow the errors of the two parts of the curl partly cancel, so that it
            // may converge faster.
            EXPECT_GE(order(coarse.curl, fine.curl), promise.slope - 0.3);
        }
        const VolumeErrors flat =
            volume_errors(field_of<Scalar>(plane), 16, promise.kernel, is_everywhere_smooth);
        EXPECT_LE(flat.value, 1e-7) << "a plane is exact but for the rounding of samples to float";
        EXPECT_LE(flat.gradient, 1e-6);
    }
}

// ---- placements of fields in a parent frame ---------------------------------------------------------------

void expect_same(const Scalar& a, const Scalar& b, double tolerance) {
    EXPECT_NEAR(a.value, b.value, tolerance);
    EXPECT_LE(glm::length(a.gradient - b.gradient), tolerance);
}

void expect_same(const Vector& a, const Vector& b, double tolerance) {
    EXPECT_LE(glm::length(a.value - b.value), tolerance);
    for (std::size_t row = 0; row < 3; ++row)
        EXPECT_LE(glm::length(a.gradient[row] - b.gradient[row]), tolerance);
}

TEST(Placement, FramesLeadThereAndBack) {
    Random random = random_stream(5, 5);
    for (int run = 0; run < 300; ++run) {
        const Placement outer = random_placement(random), inner = random_placement(random);
        const vec3 place = random_place(random, 2);
        EXPECT_LE(glm::length(to_own(outer, to_parent(outer, place)) - place), 1e-13);
        EXPECT_LE(
            glm::length(to_parent(combined(outer, inner), place) - to_parent(outer, to_parent(inner, place))),
            1e-13);
    }
    EXPECT_EQ(to_parent(Placement{}, vec3(1, 2, 3)), vec3(1, 2, 3));
}

/// Placed fields must equal a sphere, a plane and a vortex whose formulas are written in the parent frame.
TEST(Placement, APlacedFormulaIsTheFormulaOfThePlacedBody) {
    Random random = random_stream(6, 6);
    for (int run = 0; run < 300; ++run) {
        const Placement p = random_placement(random);
        const Sphere ball{to_parent(p, sphere.middle), sphere.radius * p.scale};
        RankineVortex whirl = vortex;
        whirl.middle = to_parent(p, vortex.middle);
        whirl.axis = p.turn * vortex.axis;
        whirl.radius *= p.scale;
        const vec3 place = to_parent(p, random_place(random, 1));
        const Scalar depth = Placed<Scalar>{field_of<Scalar>(sphere), p}(place);
        expect_same({depth.value * p.scale, depth.gradient * p.scale}, ball(place), 1e-12);
        const double edge = glm::length(glm::cross(place - whirl.middle, whirl.axis)) - whirl.radius;
        if (std::abs(edge) < 1e-9) continue;
        expect_same(Placed<Vector>{field_of<Vector>(vortex), p}(place), whirl(place), 1e-11);
    }
}

TEST(Placement, ASampledVolumeFeelsTheSameWhereverItLies) {
    Volume body = sampled(field_of<Scalar>(gyroid), {17, 21, 13}, {0.1, 0.08, 0.15});
    const Volume flow = sampled(field_of<Vector>(orb), {17, 21, 13}, {0.1, 0.08, 0.15});
    Random random = random_stream(7, 7);
    for (const Kernel kernel : {Kernel::linear, Kernel::catmull_rom}) {
        const Grid grid = body.grid(kernel);
        const StaggeredGrid grids = flow.vector_grid(kernel);
        for (int run = 0; run < 200; ++run) {
            const Placement p = random_placement(random);
            const vec3 own = random_place(random, 0.75), place = to_parent(p, own);
            const Scalar one = Placed<Scalar>{field_of<Scalar>(grid), p}(place);
            EXPECT_NEAR(one.value, grid(own).value, 1e-12);
            // The force is along the gradient, which is rotated together with the volume.
            const vec3 back = glm::transpose(p.turn) * one.gradient * p.scale;
            EXPECT_LE(glm::length(back - grid(own).gradient), 1e-10);
            const Vector many = Placed<Vector>{field_of<Vector>(grids), p}(place);
            EXPECT_LE(glm::length(many.value - p.turn * grids(own).value), 1e-12);
            EXPECT_LE(glm::length(curl(many) * p.scale - p.turn * curl(grids(own))), 1e-10);
            EXPECT_NEAR(divergence(many) * p.scale, divergence(grids(own)), 1e-10);
        }
    }
}

TEST(Placement, APlacementThatIsNoneGivesZeros) {
    for (const double scale : {0.0, -1.0, std::nan("")}) {
        const Placed<Scalar> placed{field_of<Scalar>(sphere), {.scale = scale}};
        expect_same(placed(vec3(0.1)), {}, 0);
    }
    expect_same(Placed<Vector>{}(vec3(1)), {}, 0);
}

}  // namespace
}  // namespace thaum::field
