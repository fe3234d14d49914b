// Compares the spring surface (a liquid's surface as a lattice of masses and springs) with closed forms:
// normal modes of the lattice, the recurrence of the Runge-Kutta method, and the static response to a push.
#include "fluid/spring_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace thaum::fluid {
namespace {

SpringSurfaceSettings lattice(std::uint32_t nodes, Rim rim) {
    return {.nodes = nodes, .rim = rim, .damping = 0, .still = 0};
}

double shape_at(const SpringSurfaceSettings& s, std::uint32_t p, std::uint32_t q, std::size_t x,
                std::size_t z) {
    const auto X = static_cast<double>(x), Z = static_cast<double>(z), n = static_cast<double>(s.nodes);
    if (s.rim == Rim::pinned) return std::sin(p * pi * X / (n - 1)) * std::sin(q * pi * Z / (n - 1));
    return std::cos(p * pi * (X + 0.5) / n) * std::cos(q * pi * (Z + 0.5) / n);
}

template <class Visit>
void each_node(const SpringSurfaceSettings& s, Visit visit) {
    for (std::size_t z = 0; z < s.nodes; ++z) {
        for (std::size_t x = 0; x < s.nodes; ++x) visit(x, z, surface_node_index(s, x, z));
    }
}

SpringSurface with_heights(SpringSurface surface,
                           const std::function<double(std::size_t, std::size_t)>& height) {
    const SpringSurfaceSettings& s = surface.settings;
    each_node(s, [&](std::size_t x, std::size_t z, std::size_t i) { surface.height[i] = height(x, z); });
    refresh_after_edit(surface);
    return surface;
}

SpringSurface mode(const SpringSurfaceSettings& s, std::uint32_t p, std::uint32_t q) {
    return with_heights(make_spring_surface(s),
                        [&](std::size_t x, std::size_t z) { return 0.01 * shape_at(s, p, q, x, z); });
}

/// Height and velocity of one mode, and the largest deviation of the surface from the mode.
struct Part {
    double height{}, velocity{}, deviation{};
};

Part part_of(const SpringSurface& surface, std::uint32_t p, std::uint32_t q) {
    const SpringSurfaceSettings& s = surface.settings;
    Part part;
    double norm = 0;
    each_node(s, [&](std::size_t x, std::size_t z, std::size_t i) {
        const double shape = shape_at(s, p, q, x, z);
        part.height += shape * surface.height[i];
        part.velocity += shape * surface.velocity[i];
        norm += shape * shape;
    });
    part.height /= norm;
    part.velocity /= norm;
    each_node(s, [&](std::size_t x, std::size_t z, std::size_t i) {
        part.deviation =
            std::max(part.deviation, std::abs(surface.height[i] - part.height * shape_at(s, p, q, x, z)));
    });
    return part;
}

void expect_frequency(SpringSurfaceSettings s, std::uint32_t p, std::uint32_t q) {
    const double frequency = mode_frequency(s, p, q);
    SpringSurface surface = mode(s, p, q);
    SpringSurfaceScratch scratch;
    const int calls = static_cast<int>(std::ceil(60 * stiffest_frequency(s) / frequency));
    const double t = 1.3 / frequency;  // 1.3 rad of the mode: neither height nor velocity is zero there
    for (int i = 0; i < calls; ++i) advance(surface, scratch, {}, t / calls);
    const Part part = part_of(surface, p, q);
    EXPECT_NEAR(std::atan2(-part.velocity / frequency, part.height), 1.3, 1.3e-8)
        << s.nodes << " nodes, rim " << static_cast<int>(s.rim) << ", shear " << s.shear << ", mode " << p
        << ' ' << q;
    EXPECT_LE(part.deviation, 1e-12);
}

TEST(SpringSurfaceAccuracy, NormalModesHaveTheLatticesFrequencies) {
    for (const std::uint32_t nodes : {classic_nodes, 33U}) {
        for (const double shear : {0.0, 1.0 / 3, 1.0}) {
            for (const double level : {0.0, 5000.0}) {
                SpringSurfaceSettings s = lattice(nodes, Rim::pinned);
                s.shear = shear;
                s.level = level;
                expect_frequency(s, 1, 1);
                expect_frequency(s, 3, 2);
                expect_frequency(s, 1, nodes - 2);
                expect_frequency(s, nodes - 2, nodes - 2);
                s.rim = Rim::free;
                expect_frequency(s, 1, 0);
                expect_frequency(s, 2, 5);
                expect_frequency(s, nodes - 1, 1);
                expect_frequency(s, nodes - 1, nodes - 1);
            }
        }
    }
}

TEST(SpringSurfaceAccuracy, NoModeIsFasterThanTheStiffestFrequency) {
    for (const Rim rim : {Rim::pinned, Rim::free}) {
        for (const double shear : {0.0, 1.0 / 3, 0.5, 0.9, 1.0}) {
            SpringSurfaceSettings s = lattice(15, rim);
            s.shear = shear;
            double fastest = 0;
            for (std::uint32_t p = 1; p <= 13; ++p) {
                for (std::uint32_t q = 1; q <= 13; ++q) fastest = std::max(fastest, mode_frequency(s, p, q));
            }
            EXPECT_LE(fastest, stiffest_frequency(s));
            EXPECT_GE(fastest, 0.97 * stiffest_frequency(s));  // the bound is tight
        }
    }
}

TEST(SpringSurfaceAccuracy, LongWavesApproachThoseOfAMembrane) {
    double before = 0;
    for (const std::uint32_t nodes : {17U, 33U, 65U}) {
        const SpringSurfaceSettings s = lattice(nodes, Rim::pinned);
        const double membrane = pi / s.side * std::sqrt(s.tension / s.areal_mass * (2 * 2 + 3 * 3));
        const double error = std::abs(mode_frequency(s, 2, 3) / membrane - 1);
        if (before > 0) {
            EXPECT_NEAR(std::log2(before / error), 2, 0.1);
        }
        before = error;
    }
    EXPECT_LT(before, 2e-3);
}

/// Height and velocity of a mode are compared with the recurrence of the Runge-Kutta method for one damped
/// oscillator.
TEST(SpringSurfaceAccuracy, AStepFollowsTheRecurrenceOfRungeKutta) {
    SpringSurfaceSettings s = lattice(33, Rim::pinned);
    s.damping = 3;
    const std::uint32_t p = 7, q = 12;
    const double t = 0.9 / stiffest_frequency(s), w2 = mode_frequency(s, p, q) * mode_frequency(s, p, q);
    SpringSurface surface = mode(s, p, q);
    SpringSurfaceScratch scratch;
    double x = 0.01, v = 0;
    for (int i = 0; i < 50; ++i) {
        const SpringSurfaceStep step = advance(surface, scratch, {}, t);
        ASSERT_EQ(step.steps, 1U);
        double dx = x, dv = v;  // terms of the Taylor series of e^(A t)
        for (int k = 1; k <= 4; ++k) {
            const double next = dv * t / k;
            dv = (-w2 * dx - 2 * s.damping * dv) * t / k;
            dx = next;
            x += dx;
            v += dv;
        }
    }
    const Part part = part_of(surface, p, q);
    EXPECT_NEAR(part.height, x, 1e-14);
    EXPECT_NEAR(part.velocity, v, 1e-12);
}

/// Largest difference between the heights of two surfaces (m).
double distance(const SpringSurface& a, const SpringSurface& b) {
    double most = 0;
    each_node(a.settings, [&](std::size_t, std::size_t, std::size_t i) {
        most = std::max(most, std::abs(a.height[i] - b.height[i]));
    });
    return most;
}

SpringSurface run(SpringSurface surface, std::span<const SurfaceProbe> probes, double t, int calls) {
    SpringSurfaceScratch scratch;
    for (int i = 0; i < calls; ++i) EXPECT_EQ(advance(surface, scratch, probes, t / calls).steps, 1U);
    return surface;
}

TEST(SpringSurfaceAccuracy, ConvergesInFourthOrderUnderAProbeToo) {
    SpringSurfaceSettings s = lattice(15, Rim::pinned);
    s.damping = 2;
    s.contact = 500;
    const std::array probes{SurfaceProbe{.place = {0.21, -0.13}, .height = -0.1, .radius = 0.4}};
    const double t = 32 * 0.9 / std::sqrt(2 * stiffest_frequency(s) * stiffest_frequency(s));
    for (const std::size_t count : {0U, 1U}) {
        const auto with = std::span(probes).first(count);
        // The probe pushes with 10 N from the start and stays, so that the motion is smooth.
        const SpringSurface start = with_heights(make_spring_surface(s), [&](std::size_t x, std::size_t z) {
            return 0.05 * shape_at(s, 1, 1, x, z) + 0.02 * shape_at(s, 2, 3, x, z);
        });
        const SpringSurface exact = run(start, with, t, 2048);
        const double coarse = distance(run(start, with, t, 32), exact);
        const double middle = distance(run(start, with, t, 64), exact);
        const double fine = distance(run(start, with, t, 128), exact);
        EXPECT_NEAR(std::log2(coarse / middle), 4, 0.25) << count;
        EXPECT_NEAR(std::log2(middle / fine), 4, 0.15) << count;
    }
}

/// Weights of the probe's footprint at all nodes: (1 - r^2)^2, where r is a node's distance from the probe
/// divided by the probe's radius. Their sum is 1.
std::vector<double> weights_of(const SpringSurfaceSettings& s, const SurfaceProbe& p) {
    std::vector<double> weights(make_spring_surface(s).height.size());
    const double a = surface_node_spacing(s), radius = std::max(p.radius, 1.5 * a);
    double sum = 0;
    each_node(s, [&](std::size_t x, std::size_t z, std::size_t i) {
        const vec2 node(a * static_cast<double>(x) - s.side / 2, a * static_cast<double>(z) - s.side / 2);
        const double r = glm::length(node - p.place) / radius;
        sum += weights[i] = r < 1 ? (1 - r * r) * (1 - r * r) : 0;
    });
    for (double& w : weights) w /= sum;
    return weights;
}

/// Deflection per force at the probe, from the sum over all modes (m/N).
double compliance(const SpringSurfaceSettings& s, const SurfaceProbe& p) {
    const std::vector<double> weights = weights_of(s, p);
    const double mass = s.areal_mass * surface_node_spacing(s) * surface_node_spacing(s);
    const double norm = (s.nodes - 1) * (s.nodes - 1) / 4.0;
    double sum = 0;
    for (std::uint32_t m = 1; m + 1 < s.nodes; ++m) {
        for (std::uint32_t n = 1; n + 1 < s.nodes; ++n) {
            double part = 0;
            each_node(s, [&](std::size_t x, std::size_t z, std::size_t i) {
                if (weights[i] != 0) part += weights[i] * shape_at(s, m, n, x, z);
            });
            const double w = mode_frequency(s, m, n);
            sum += part * part / (norm * mass * w * w);
        }
    }
    return sum;
}

TEST(SpringSurfaceAccuracy, AHeldProbeFeelsTheStaticForce) {
    for (const std::uint32_t nodes : {15U, 33U}) {
        SpringSurfaceSettings s = lattice(nodes, Rim::pinned);
        s.damping = 3;
        s.pop_through = 1e4;
        const SurfaceProbe probe{.place = {0.3, -0.2}, .height = -0.08, .radius = 0.15};
        SpringSurface surface = make_spring_surface(s);
        SpringSurfaceScratch scratch;
        SpringSurfaceStep step;
        for (int i = 0; i < 8000; ++i) step = advance(surface, scratch, {&probe, 1}, 0.001);
        const double force = 0.08 / (1 / s.contact + compliance(s, probe));
        EXPECT_GT(force, 20);
        EXPECT_NEAR(step.probes[0].force, force, 1e-9 * force) << nodes;
        EXPECT_NEAR(step.probes[0].height, -0.08 + force / s.contact, 1e-10);
        EXPECT_FALSE(step.probes[0].inside);
    }
}

TEST(SpringSurfaceAccuracy, TheProbesImpulseIsTheSurfacesMomentum) {
    SpringSurfaceSettings s = lattice(33, Rim::free);
    const double mass = s.areal_mass * surface_node_spacing(s) * surface_node_spacing(s);
    SpringSurface surface = make_spring_surface(s);
    SpringSurfaceScratch scratch;
    double given = 0, momentum = 0;
    for (int i = 0; i < 400; ++i) {
        const std::array probes{SurfaceProbe{{0.3, 0.1}, -0.0008 * i, 0.2},
                                SurfaceProbe{{-0.9, 0.95}, 0.03 * std::sin(0.05 * i), 0.1}};
        const SpringSurfaceStep step = advance(surface, scratch, probes, 0.002);
        given += step.seconds * (step.probes[0].force + step.probes[1].force);
        momentum = 0;
        each_node(s,
                  [&](std::size_t, std::size_t, std::size_t at) { momentum += mass * surface.velocity[at]; });
        ASSERT_NEAR(momentum, -given, 1e-11) << i;
    }
    EXPECT_LT(momentum, -1);
}

}  // namespace
}  // namespace thaum::fluid
