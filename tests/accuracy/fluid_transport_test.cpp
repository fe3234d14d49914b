// Tests the transport of substances by a given flow: order of convergence, constant densities, conservation,
// positive densities, exact symmetry, flow around solids, and diffusion.
#include "fluid/detail/transport.h"
#include "fluid/ghosts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/maths.h"
#include "core/random.h"
#include "fluid/detail/sums.h"
#include "tests/scenes/fluid_substances.h"

namespace thaum::fluid {
namespace {

using Velocity = std::array<Samples, 3>;

constexpr Edges all_round{Edge::periodic, Edge::periodic, Edge::periodic};
constexpr Edges all_walls{Edge::free_slip, Edge::no_slip, Edge::free_slip};

std::size_t place(const Lattice& l, int i, int j, int k) { return static_cast<std::size_t>(l.at(i, j, k)); }

/// Samples of a function of the position (m) at cell centres.
Samples field(const Lattice& l, const std::function<double(vec3)>& value) {
    Samples samples = make_samples(l);
    each_cell(l, [&](int i, int j, int k, std::size_t at) {
        samples[at] = static_cast<float>(value(l.h * vec3(i + 0.5, j + 0.5, k + 0.5)));
    });
    return samples;
}

void fill_velocity_ghosts(const Lattice& l, Velocity& velocity) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        fill_ghosts(l, ghost_rules_of_velocity(l, axis), velocity[axis]);
}

Velocity uniform(const Lattice& l, vec3 v) {
    Velocity velocity;
    for (int axis = 0; axis < 3; ++axis)
        velocity[static_cast<std::size_t>(axis)] = field(l, [&](vec3) { return v[axis]; });
    fill_velocity_ghosts(l, velocity);
    return velocity;
}

/// Velocity of a rotation about z through the centre of a unit box, with one revolution per second.
Velocity rigid_turn(const Lattice& l) {
    const double h = l.h;
    Velocity velocity{make_samples(l), make_samples(l), make_samples(l)};
    each_cell(l, [&](int i, int j, int, std::size_t at) {
        velocity[0][at] = static_cast<float>(-2 * pi * (h * (j + 0.5) - 0.5));
        velocity[1][at] = static_cast<float>(2 * pi * (h * (i + 0.5) - 0.5));
    });
    fill_velocity_ghosts(l, velocity);
    return velocity;
}

using IsClosed = std::function<bool(int, int, int)>;

/// Returns true if none of the four cells around a cell's low edge along `axis` is closed or outside.
bool is_free_edge(const Lattice& l, const IsClosed& closed, std::size_t axis, Cells cell) {
    for (int corner = 0; corner < 4; ++corner) {
        Cells c = cell;
        c[(axis + 1) % 3] -= corner % 2;
        c[(axis + 2) % 3] -= corner / 2;
        for (std::size_t a = 0; a < 3; ++a) {
            if (l.edges[a] == Edge::periodic) c[a] = (c[a] + l.cells[a]) % l.cells[a];
            if (c[a] < 0 || c[a] >= l.cells[a]) return false;
        }
        if (closed(c[0], c[1], c[2])) return false;
    }
    return true;
}

/// Random potentials on the low edges of all cells, zero on edges that touch a closed cell. All are multiples
/// of 1/64, so that their sums are exact.
std::array<Samples, 3> random_potential(const Lattice& l, std::uint64_t seed, const IsClosed& closed) {
    std::array<Samples, 3> potential{make_samples(l), make_samples(l), make_samples(l)};
    Random random = random_stream(seed, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        each_cell(l, [&](int i, int j, int k, std::size_t at) {
            const auto value = static_cast<float>(random.below(129)) / 64 - 1;
            potential[axis][at] = is_free_edge(l, closed, axis, {i, j, k}) ? value : 0;
        });
    }
    return potential;
}

/// The curl of random potentials; its divergence is zero up to rounding.
Velocity solenoidal(const Lattice& l, std::uint64_t seed, const IsClosed& closed) {
    const std::array<Samples, 3> potential = random_potential(l, seed, closed);
    const auto at_high = [&](std::size_t axis, Cells c, std::size_t across) {
        if (++c[across] == l.cells[across]) {
            if (l.edges[across] != Edge::periodic) return 0.0F;
            c[across] = 0;
        }
        return potential[axis][place(l, c[0], c[1], c[2])];
    };
    Velocity velocity{make_samples(l), make_samples(l), make_samples(l)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
        each_cell(l, [&](int i, int j, int k, std::size_t at) {
            velocity[axis][at] =
                (at_high(c, {i, j, k}, b) - potential[c][at]) - (at_high(b, {i, j, k}, c) - potential[b][at]);
        });
    }
    fill_velocity_ghosts(l, velocity);
    return velocity;
}

double amount(const Lattice& l, const Samples& density) {
    double sum = 0;
    each_cell(l, [&](int, int, int, std::size_t at) { sum += double{density[at]}; });
    return sum;
}

float least(const Lattice& l, const Samples& density) {
    float result = density[place(l, 0, 0, 0)];
    each_cell(l, [&](int, int, int, std::size_t at) {
        if (!(density[at] >= result)) result = density[at];  // unlike >, also keeps a NaN
    });
    return result;
}

/// Relative L2 error of a density after its transport.
double error(const Lattice& l, const Samples& found, const Samples& exact) {
    double off = 0, all = 0;
    each_cell(l, [&](int, int, int, std::size_t at) {
        off += std::pow(double{found[at]} - double{exact[at]}, 2);
        all += std::pow(double{exact[at]}, 2);
    });
    return std::sqrt(off / all);
}

/// Transports a density by a velocity in `steps` steps that take `seconds` in total. Returns the last step's
/// report.
TransportReport carry(const Lattice& l, const Velocity& velocity, Samples& density, double seconds, int steps,
                      const TransportSettings& settings = {.max_substeps = 64},
                      const FaceApertures* face_apertures = nullptr) {
    FaceFlow face_flow = make_face_flow(l);
    TransportScratch scratch = make_transport_scratch(l);
    Team alone;
    set_face_flow(l, velocity, velocity, face_apertures, seconds / steps, face_flow, alone);
    TransportReport report;
    for (int i = 0; i < steps; ++i) report = transport(l, face_flow, settings, density, scratch, alone);
    return report;
}

const auto nothing_closed = [](int, int, int) { return false; };

// ---- convergence of transport -----------------------------------------------------------------------------

/// Error after a translation by a quarter of the box along x and an eighth along y and z.
double translation_error(int n, double courant) {
    const Lattice l = make_lattice({n, n, n}, 1.0 / n, all_round);
    const vec3 v(1, 0.5, -0.5);
    const auto wave = [&](double t) {
        return field(l, [&, t](vec3 at) {
            const vec3 x = 2 * pi * (at - t * v);
            return 2 + std::sin(x.x) * std::cos(x.y) + std::sin(x.z);
        });
    };
    Samples density = wave(0);
    const int steps = static_cast<int>(std::lround(0.25 * 2 * n / courant));
    EXPECT_EQ(carry(l, uniform(l, v), density, 0.25, steps).substeps, 1);
    const Samples exact = wave(0.25);
    return error(l, density, exact);
}

TEST(TransportAccuracy, FifthOrderInSpace) {
    const double coarse = translation_error(8, 0.1), middle = translation_error(12, 0.1),
                 fine = translation_error(20, 0.1);
    EXPECT_GE(std::log(coarse / middle) / std::log(12 / 8.0), 4.5);
    EXPECT_GE(std::log(middle / fine) / std::log(20 / 12.0), 4.5);
}

TEST(TransportAccuracy, ThirdOrderWithTheTimeStepsToo) {
    const double coarse = translation_error(16, 0.8), middle = translation_error(24, 0.8),
                 fine = translation_error(36, 0.8);
    EXPECT_GE(std::log(coarse / middle) / std::log(1.5), 3);
    EXPECT_GE(std::log(middle / fine) / std::log(1.5), 3);
}

Samples blob(const Lattice& l) {
    return field(l, [](vec3 at) {
        const vec3 r = at - vec3(0.5, 0.75, 0.5);
        return std::exp(-glm::dot(r, r) / 0.02);
    });
}

TEST(TransportAccuracy, ABlobReturnsFromOneRevolution) {
    const Lattice l =
        make_lattice({32, 32, 32}, 1.0 / 32, {Edge::free_slip, Edge::free_slip, Edge::free_slip});
    for (const double courant : {1.0, 4.0}) {
        const Samples before = blob(l);
        Samples density = before;
        const int steps = static_cast<int>(std::ceil(pi * 32 / courant));
        carry(l, rigid_turn(l), density, 1, steps, {});
        EXPECT_LE(error(l, density, before), 0.0095) << courant;
        EXPECT_NEAR(amount(l, density) / amount(l, before), 1, 1e-6);
        EXPECT_GE(least(l, density), 0);
    }
}

struct Deformed {
    double error;        ///< relative L1 error of the density
    double least, most;  ///< lowest and highest density over all steps
    double change;       ///< relative change of the substance's total amount
};

Velocity deformation_at_start(const Lattice& l) {
    Velocity velocity{make_samples(l), make_samples(l), make_samples(l)};
    for (int axis = 0; axis < 3; ++axis) {
        vec3 stands(0.5);
        stands[axis] = 0;
        each_cell(l, [&](int i, int j, int k, std::size_t at) {
            velocity[static_cast<std::size_t>(axis)][at] =
                static_cast<float>(flows::deformation(l.h * (vec3(i, j, k) + stands), 0)[axis]);
        });
    }
    fill_velocity_ghosts(l, velocity);
    return velocity;
}

Velocity times(double factor, Velocity velocity) {
    for (Samples& component : velocity)
        for (float& u : component) u *= static_cast<float>(factor);
    return velocity;
}

/// Transports a shape by LeVeque's deforming flow, forward and back again.
Deformed deformed(double (*shape)(vec3), int n, double courant) {
    const Lattice l = make_lattice({n, n, n}, 1.0 / n, {Edge::free_slip, Edge::free_slip, Edge::free_slip});
    const Samples before = field(l, shape);
    Samples density = before;
    FaceFlow face_flow = make_face_flow(l);
    TransportScratch scratch = make_transport_scratch(l);
    Team alone;
    const Velocity start = deformation_at_start(l);
    const int steps = flows::steps_of_deformation(n, courant);
    Deformed result{.error = 0, .least = 0, .most = 0, .change = 0};
    for (int i = 0; i < steps; ++i) {
        const Velocity velocity = times(det::cos(pi * (i + 0.5) / steps), start);
        set_face_flow(l, velocity, velocity, nullptr, flows::deformation_end / steps, face_flow, alone);
        transport(l, face_flow, {}, density, scratch, alone);
        result.least = std::min(result.least, double{least(l, density)});
        result.most = std::max(result.most, largest(l, density));
    }
    double off = 0;
    each_cell(
        l, [&](int, int, int, std::size_t at) { off += std::abs(double{density[at]} - double{before[at]}); });
    result.error = off / amount(l, before);
    result.change = amount(l, density) / amount(l, before) - 1;
    return result;
}

TEST(TransportAccuracy, AStretchedShapeStaysWithinItsBoundsAndReturns) {
    for (const double courant : {1.0, 4.0}) {
        const Deformed sphere = deformed(flows::deformed_sphere, 32, courant);
        EXPECT_LE(sphere.most, 1 + 1e-5);
        EXPECT_GE(sphere.least, 0);
        EXPECT_NEAR(sphere.change, 0, 1e-6);
        EXPECT_LE(sphere.error, 0.96);
        const Deformed gaussian = deformed(flows::deformed_gaussian, 32, courant);
        EXPECT_LE(gaussian.most, 1 + 1e-5);
        EXPECT_GE(gaussian.least, 0);
        EXPECT_NEAR(gaussian.change, 0, 1e-6);
        EXPECT_LE(gaussian.error, 0.535);
    }
}

TEST(Transport, SegregationTellsABodyFromAHillAndAMixture) {
    const Lattice l = make_lattice({33, 32, 32}, 1.0 / 32, all_walls);
    const auto found = [&](const std::function<double(vec3)>& value) {
        const Rows rows = whole_rows(l);
        std::vector<SegregationOfRow> of_rows(rows.rows.size());
        segregation_of_rows(rows, all_layers(l), field(l, value), of_rows);
        return segregation(rows, 33 * 32 * 32, of_rows);
    };
    EXPECT_NEAR(found([](vec3 at) { return 7 * flows::deformed_sphere(at); }), 1, 1e-5);
    EXPECT_NEAR(found([](vec3 at) { return at.x > 0.7 ? 0 : 0.2; }), 1, 1e-5);
    EXPECT_LE(found(flows::deformed_gaussian), 0.36);
    EXPECT_LE(found([](vec3 at) { return 0.7 + 0.1 * std::sin(20 * at.x); }), 0.1);
    EXPECT_NEAR(found([](vec3) { return 0.3; }), 0, 1e-5);
    EXPECT_EQ(found([](vec3) { return 0; }), 0);
}

// ---- properties for any flow ------------------------------------------------------------------------------

TEST(Transport, NothingRisesAboveTheHighestWhereTheFlowHasNoDivergence) {
    for (const Edges& edges : {all_round, all_walls}) {
        const Lattice l = make_lattice({12, 15, 9}, 0.1, edges);
        const Velocity velocity = solenoidal(l, 6, nothing_closed);
        Random random = random_stream(9, 1);
        Samples density = field(l, [&](vec3) { return random.uniform() < 0.5 ? random.uniform(0, 3) : 3; });
        const double before = amount(l, density);
        carry(l, velocity, density, 1, 20);
        EXPECT_LE(largest(l, density), 3 * (1 + 1e-5));
        EXPECT_GE(least(l, density), 0);
        EXPECT_NEAR(amount(l, density) / before, 1, 1e-6);
    }
}

TEST(Transport, AConstantDensityStaysConstant) {
    for (const Edges& edges : {all_round, all_walls, Edges{Edge::periodic, Edge::no_slip, Edge::free_slip}}) {
        const Lattice l = make_lattice({17, 10, 12}, 0.1, edges);
        const Velocity velocity = solenoidal(l, 11, nothing_closed);
        Samples density = field(l, [](vec3) { return 0.7; });
        EXPECT_GE(carry(l, velocity, density, 2, 20).substeps, 2);
        each_cell(l, [&](int, int, int, std::size_t at) { ASSERT_NEAR(density[at], 0.7F, 2e-5F); });
    }
}

TEST(Transport, TheAmountIsConservedInAnyFlow) {
    for (const Edges& edges : {all_round, all_walls}) {
        const Lattice l = make_lattice({12, 15, 9}, 0.1, edges);
        Random random = random_stream(7, 1);
        Velocity velocity;
        for (Samples& samples : velocity) samples = field(l, [&](vec3) { return random.uniform(-1, 1); });
        fill_velocity_ghosts(l, velocity);
        Samples density = field(l, [&](vec3) { return random.uniform() < 0.3 ? random.uniform() : 0; });
        const double before = amount(l, density);
        carry(l, velocity, density, 1, 40, {.diffusion = 1e-3, .max_substeps = 64});
        EXPECT_NEAR(amount(l, density) / before, 1, 1e-6);
        EXPECT_GE(least(l, density), 0);
    }
}

TEST(Transport, NothingFallsBelowZeroInAHostileFlow) {
    Random random = random_stream(8, 1);
    for (const double speed : {1.0, 100.0, 1e4, 1e6}) {
        const Lattice l = make_lattice({14, 9, 11}, 0.05, all_walls);
        Samples density = field(l, [&](vec3) { return random.uniform() < 0.2 ? random.uniform(0, 100) : 0; });
        const double before = amount(l, density);
        for (int i = 0; i < 30; ++i) {
            Velocity velocity;
            for (Samples& samples : velocity)
                samples = field(
                    l, [&](vec3) { return random.uniform() < 0.1 ? random.uniform(-speed, speed) : 0; });
            fill_velocity_ghosts(l, velocity);
            const double diffusion = random.below(3) == 0 ? random.uniform(0, speed) : 0;
            const TransportReport report =
                carry(l, velocity, density, 0.016, 1, {.diffusion = diffusion, .max_substeps = 8});
            ASSERT_GE(report.substeps, 1);
            ASSERT_LE(report.substeps, 8);
            ASSERT_GT(report.carried, 0);
            ASSERT_GE(least(l, density), 0) << speed;
        }
        EXPECT_NEAR(amount(l, density) / before, 1, 1e-5) << speed;
    }
}

TEST(Transport, WithTooFewSubStepsItAdvancesLess) {
    const Lattice l = make_lattice({16, 8, 8}, 1.0 / 16, all_round);
    Samples density = field(l, [](vec3 at) { return 2 + std::sin(2 * pi * at.x); });
    Samples same = density;
    const Velocity velocity = uniform(l, {100, 0, 0});
    const TransportReport report = carry(l, velocity, density, 0.1, 1, {.max_substeps = 3});
    EXPECT_EQ(report.substeps, 3);
    EXPECT_EQ(report.cells, 3 * 16 * 8 * 8);
    EXPECT_NEAR(report.carried, 3 * max_courant / 160, 1e-6);
    const TransportReport whole = carry(l, velocity, same, 0.1 * report.carried, 1, {.max_substeps = 4});
    EXPECT_EQ(whole.carried, 1);
    EXPECT_LE(error(l, density, same), 1e-3);
    EXPECT_NEAR(amount(l, density), amount(l, same), 1e-2);
}

TEST(Transport, AnEmptyOrMotionlessDensityVisitsNoCells) {
    const Lattice l = make_lattice({8, 8, 8}, 0.1, all_walls);
    Samples none = make_samples(l);
    const Velocity moving = solenoidal(l, 2, nothing_closed), still = uniform(l, {});
    EXPECT_EQ(carry(l, moving, none, 0.1, 1).cells, 0);
    EXPECT_EQ(carry(l, moving, none, 0.1, 1, {.diffusion = 1}).cells, 0);
    Samples some = field(l, [](vec3 at) { return at.x; });
    const Samples before = some;
    EXPECT_EQ(carry(l, still, some, 0.1, 1).substeps, 0);
    EXPECT_EQ(some, before);
    EXPECT_EQ(carry(l, moving, some, 0, 1).substeps, 0);
    EXPECT_EQ(some, before);
    EXPECT_GE(carry(l, still, some, 0.1, 1, {.diffusion = 0.01}).cells, 8 * 8 * 8);
}

// ---- symmetry of transport --------------------------------------------------------------------------------

/// A lattice seen with permuted and mirrored axes.
struct View {
    std::array<std::size_t, 3> axes{0, 1, 2};  ///< axis a of the view is axis axes[a] of the lattice
    std::array<bool, 3> mirrored{};            ///< which axes of the view are mirrored
};

Cells seen(const View& view, Cells n, Cells cell, std::array<int, 3> faces) {
    Cells old{};
    for (std::size_t a = 0; a < 3; ++a) {
        const int last = n[view.axes[a]] - 1 + faces[a];
        old[view.axes[a]] = view.mirrored[a] ? last - cell[a] : cell[a];
    }
    return old;
}

Samples seen(const View& view, const Lattice& from, const Lattice& to, const Samples& values) {
    Samples result = make_samples(to);
    each_cell(to, [&](int i, int j, int k, std::size_t at) {
        const Cells c = seen(view, from.cells, {i, j, k}, {});
        result[at] = values[place(from, c[0], c[1], c[2])];
    });
    return result;
}

Velocity seen(const View& view, const Lattice& from, const Lattice& to, const Velocity& velocity) {
    Velocity result{make_samples(to), make_samples(to), make_samples(to)};
    for (std::size_t a = 0; a < 3; ++a) {
        each_cell(to, [&](int i, int j, int k, std::size_t at) {
            std::array<int, 3> faces{};
            faces[a] = 1;
            const Cells c = seen(view, from.cells, {i, j, k}, faces);
            const float value = velocity[view.axes[a]][place(from, c[0], c[1], c[2])];
            result[a][at] = view.mirrored[a] ? -value : value;
        });
    }
    fill_velocity_ghosts(to, result);
    return result;
}

/// Largest difference between a density that is first viewed (with permuted or mirrored axes) and then
/// transported, and one that is first transported and then viewed.
double asymmetry(const View& view, const Edges& edges, double diffusion) {
    const Lattice l = make_lattice({13, 10, 11}, 0.1, edges);
    Cells cells{};
    Edges their_edges{};
    for (std::size_t a = 0; a < 3; ++a) {
        cells[a] = l.cells[view.axes[a]];
        their_edges[a] = edges[view.axes[a]];
    }
    const Lattice other = make_lattice(cells, 0.1, their_edges);
    Random random = random_stream(21, 4);
    const Velocity velocity = solenoidal(l, 5, nothing_closed);
    Samples density = field(l, [&](vec3) { return random.uniform() < 0.4 ? random.uniform() : 0; });
    Samples there = seen(view, l, other, density);
    carry(l, velocity, density, 0.5, 5, {.diffusion = diffusion, .max_substeps = 64});
    carry(other, seen(view, l, other, velocity), there, 0.5, 5, {.diffusion = diffusion, .max_substeps = 64});
    const Samples expected = seen(view, l, other, density);
    double most = 0;
    each_cell(other, [&](int, int, int, std::size_t at) {
        most = std::max(most, std::abs(double{there[at]} - double{expected[at]}));
    });
    return most;
}

TEST(Transport, MirrorsAndTheExchangeOfXAndYHoldToTheBit) {
    // Without diffusion, the random density is transported like a body with sharp edges.
    for (const double diffusion : {1e-3, 0.0}) {
        for (const Edges& edges : {all_round, all_walls}) {
            const auto found = [&](const View& view) { return asymmetry(view, edges, diffusion); };
            EXPECT_EQ(found({.mirrored = {true, false, false}}), 0);
            EXPECT_EQ(found({.mirrored = {false, true, false}}), 0);
            EXPECT_EQ(found({.mirrored = {false, false, true}}), 0);
            EXPECT_EQ(found({.mirrored = {true, true, true}}), 0);
            EXPECT_EQ(found({.axes = {1, 0, 2}}), 0);
            EXPECT_LE(found({.axes = {2, 1, 0}}), 2e-6);
            EXPECT_LE(found({.axes = {1, 2, 0}}), 2e-6);
            EXPECT_GT(found({.axes = {1, 2, 0}}), 0);  // the test detects a difference of a single bit
        }
    }
}

// ---- transport around solids ------------------------------------------------------------------------------

Velocity apertures(const Lattice& l, const std::function<bool(int, int, int)>& closed) {
    Velocity result{make_samples(l), make_samples(l), make_samples(l)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        each_cell(l, [&](int i, int j, int k, std::size_t at) {
            Cells below{i, j, k};
            below[axis] =
                below[axis] == 0 && l.edges[axis] == Edge::periodic ? l.cells[axis] - 1 : below[axis] - 1;
            const bool edge = below[axis] < 0;
            result[axis][at] = edge || closed(i, j, k) || closed(below[0], below[1], below[2]) ? 0.0F : 1.0F;
        });
    }
    return result;
}

TEST(TransportSolids, AConstantDensityStaysConstantAroundAStoneAndNothingEntersIt) {
    const auto stone = [](int i, int j, int k) {
        return i >= 5 && i < 9 && j >= 2 && j < 7 && k >= 4 && k < 6;
    };
    for (const Edges& edges : {all_round, all_walls}) {
        const Lattice l = make_lattice({14, 12, 10}, 0.1, edges);
        const FaceApertures face_apertures = make_face_apertures(l, apertures(l, stone));
        const Velocity velocity = solenoidal(l, 4, stone);
        Samples density = make_samples(l);
        each_cell(l,
                  [&](int i, int j, int k, std::size_t at) { density[at] = stone(i, j, k) ? 0.0F : 0.7F; });
        carry(l, velocity, density, 2, 20, {.diffusion = 1e-3, .max_substeps = 64}, &face_apertures);
        each_cell(l, [&](int i, int j, int k, std::size_t at) {
            ASSERT_NEAR(density[at], stone(i, j, k) ? 0 : 0.7, stone(i, j, k) ? 0 : 2e-5);
        });
    }
}

TEST(TransportSolids, AWallOfClosedFacesEqualsAnEdgeOfTheBox) {
    const Lattice box =
        make_lattice({16, 8, 8}, 1.0 / 16, {Edge::periodic, Edge::free_slip, Edge::free_slip});
    const Lattice wide =
        make_lattice({16, 16, 8}, 1.0 / 16, {Edge::periodic, Edge::free_slip, Edge::free_slip});
    const auto walls = [](int, int j, int) { return j < 4 || j >= 12; };
    const FaceApertures face_apertures = make_face_apertures(wide, apertures(wide, walls));
    const auto wave = [](double x, double y) { return 1 + 0.5 * std::sin(2 * pi * x) + y; };
    Samples plain = field(box, [&](vec3 at) { return wave(at.x, at.y); });
    Samples duct = make_samples(wide);
    each_cell(wide, [&](int i, int j, int, std::size_t at) {
        if (!walls(i, j, 0)) duct[at] = static_cast<float>(wave((i + 0.5) / 16, (j + 0.5) / 16 - 0.25));
    });
    const TransportSettings settings{.diffusion = 1e-3, .max_substeps = 64};
    carry(box, uniform(box, {1, 0, 0}), plain, 0.5, 20, settings);
    carry(wide, uniform(wide, {1, 0, 0}), duct, 0.5, 20, settings, &face_apertures);
    each_cell(box, [&](int i, int j, int k, std::size_t at) {
        ASSERT_NEAR(duct[place(wide, i, j + 4, k)], plain[at], 3e-6);
    });
}

TEST(TransportSolids, HalfOpenFacesLetHalfThrough) {
    const Lattice l = make_lattice({16, 8, 8}, 1.0 / 16, all_round);
    Velocity half{make_samples(l), make_samples(l), make_samples(l)};
    for (Samples& samples : half) samples.assign(l.size, 0.5F);
    const FaceApertures face_apertures = make_face_apertures(l, half);
    const auto wave = [](vec3 at) { return 2 + std::sin(2 * pi * at.x); };
    Samples through_half = field(l, wave), slower = field(l, wave);
    carry(l, uniform(l, {1, 0, 0}), through_half, 0.25, 16, {.diffusion = 2e-3, .max_substeps = 9},
          &face_apertures);
    carry(l, uniform(l, {0.5, 0, 0}), slower, 0.25, 16, {.diffusion = 1e-3, .max_substeps = 9});
    EXPECT_LE(error(l, through_half, slower), 1e-6);
}

// ---- diffusion of substances ------------------------------------------------------------------------------

double diffusion_error(int n) {
    const Lattice l = make_lattice({n, n, 4}, 1.0 / n, {Edge::free_slip, Edge::no_slip, Edge::periodic});
    const double k = 0.01, t = 2;
    const auto wave = [&](double seconds) {
        return field(l, [&, seconds](vec3 at) {
            return 2 + std::exp(-5 * k * pi * pi * seconds) * std::cos(pi * at.x) * std::cos(2 * pi * at.y);
        });
    };
    Samples density = wave(0);
    const double before = amount(l, density);
    EXPECT_EQ(carry(l, uniform(l, {}), density, t, 125, {.diffusion = k, .max_substeps = 64}).spread, 1);
    EXPECT_NEAR(amount(l, density) / before, 1, 1e-6);
    return error(l, density, wave(t));
}

TEST(TransportDiffusion, SecondOrderAndNothingThroughWalls) {
    const double coarse = diffusion_error(8), fine = diffusion_error(16);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
    EXPECT_LT(fine, 2e-3);
}

TEST(TransportDiffusion, TooMuchDiffusionIsLimitedAndLeavesTheFlowItsHalf) {
    const Lattice l = make_lattice({16, 8, 8}, 1.0 / 16, all_round);
    Samples density = field(l, [](vec3 at) { return at.x < 0.3 ? 1 : 0; });
    const double before = amount(l, density);
    const TransportReport report =
        carry(l, uniform(l, {1, 0, 0}), density, 0.1, 1, {.diffusion = 1e6, .max_substeps = 8});
    EXPECT_EQ(report.substeps, 8);
    EXPECT_EQ(report.carried, 1);
    EXPECT_LT(report.spread, 1e-3);
    EXPECT_GT(report.spread, 0);
    EXPECT_GE(least(l, density), 0);
    EXPECT_NEAR(amount(l, density) / before, 1, 1e-6);
}

}  // namespace
}  // namespace thaum::fluid
