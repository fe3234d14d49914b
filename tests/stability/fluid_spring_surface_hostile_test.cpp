// The spring surface (a liquid's surface as a lattice of masses and springs) under hostile input: any
// stiffness and time step, probes that jump or are NaN. Also tests the surface's symmetry and its sleep at
// rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "fluid/spring_surface.h"

namespace thaum::fluid {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();

SpringSurface rough(const SpringSurfaceSettings& s, std::uint64_t seed) {
    SpringSurface surface = make_spring_surface(s);
    Random random = random_stream(seed, 1);
    for (std::size_t z = 0; z < s.nodes; ++z) {
        for (std::size_t x = 0; x < s.nodes; ++x) {
            surface.height[surface_node_index(s, x, z)] = random.uniform(-0.1, 0.1);
            surface.velocity[surface_node_index(s, x, z)] = random.uniform(-1, 1);
        }
    }
    refresh_after_edit(surface);
    return surface;
}

bool all_finite(const SpringSurface& surface) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(surface.height, finite) && std::ranges::all_of(surface.velocity, finite);
}

bool all_zero(const SpringSurface& surface) {
    const auto zero = [](double value) { return value == 0; };
    return std::ranges::all_of(surface.height, zero) && std::ranges::all_of(surface.velocity, zero);
}

TEST(SpringSurfaceStability, EnergyNeverGrowsAtAnyStiffnessDampingAndStep) {
    for (const double stiffness : {1.0, 1e3, 1e6}) {
        for (const double damping : {0.0, 0.5, 40.0, 1e5}) {
            for (const double dt : {1e-4, 0.004, 0.016, 0.1}) {
                for (const Rim rim : {Rim::pinned, Rim::free}) {
                    SpringSurfaceSettings s{.nodes = 15, .rim = rim, .damping = damping, .still = 0};
                    s.tension *= stiffness;
                    s.level = 100 * stiffness;
                    SpringSurface surface = rough(s, 3);
                    SpringSurfaceScratch scratch;
                    double before = energy(surface);
                    for (int i = 0; i < 60; ++i) {
                        const SpringSurfaceStep step = advance(surface, scratch, {}, dt);
                        const double current = energy(surface);
                        ASSERT_LE(current, before * (1 + 1e-13))
                            << stiffness << ' ' << damping << ' ' << dt << ' ' << i;
                        ASSERT_LE(step.steps, s.max_steps);
                        ASSERT_GT(step.seconds, 0);
                        ASSERT_LE(step.seconds, dt * (1 + 1e-12));
                        before = current;
                    }
                    ASSERT_GT(before, 0);
                }
            }
        }
    }
}

/// A random probe: mostly near the surface, sometimes far away, huge, or NaN.
SurfaceProbe hostile_probe(Random& random) {
    SurfaceProbe probe{.place = {random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)},
                       .height = random.uniform(-0.2, 0.2),
                       .radius = random.uniform(-0.1, 0.6)};
    const std::array odd{none, endless, -endless, 1e300, -1e300, 0.0};
    const double value = odd[random.below(odd.size())];
    switch (random.below(12)) {
        case 0: probe.place.x = value; break;
        case 1: probe.place.y = value; break;
        case 2: probe.height = value; break;
        case 3: probe.radius = value; break;
        default: break;
    }
    return probe;
}

TEST(SpringSurfaceStability, JumpingProbesAddNoMoreEnergyThanTheirSpringsHold) {
    for (const double stiffness : {1.0, 1e6}) {
        for (const Rim rim : {Rim::pinned, Rim::free}) {
            SpringSurfaceSettings s{.nodes = 21, .rim = rim, .damping = 0, .still = 0};
            s.tension *= stiffness;
            Random random = random_stream(5, 2);
            SpringSurface surface = make_spring_surface(s);
            SpringSurfaceScratch scratch;
            double before = 0;
            int through = 0;
            for (int i = 0; i < 4000; ++i) {
                const std::array probes{hostile_probe(random), hostile_probe(random), hostile_probe(random),
                                        hostile_probe(random), hostile_probe(random)};
                const double dt = random.uniform(0, 0.02);
                const SpringSurfaceStep step = advance(surface, scratch, probes, dt);
                ASSERT_TRUE(all_finite(surface));
                ASSERT_LE(step.steps, s.max_steps);
                for (const ProbeReaction& probe : step.probes) {
                    ASSERT_LE(probe.force, s.pop_through * (1 + 1e-12));
                    ASSERT_GE(probe.force, -s.cling * (1 + 1e-12));
                    through += probe.inside ? 1 : 0;
                }
                // Energy that four springs can store before they break (J).
                const double held = 4 * s.pop_through * s.pop_through / (2 * s.contact);
                const double current = energy(surface);
                ASSERT_LE(current, before + 1.02 * held) << i;
                before = current;
            }
            EXPECT_GT(through, 100);
        }
    }
}

TEST(SpringSurfaceStability, ProbesThatAreNotFiniteAreAbsent) {
    SpringSurface surface = make_spring_surface({});
    SpringSurfaceScratch scratch;
    for (const double odd : {none, endless, -endless}) {
        const std::array probes{SurfaceProbe{{odd, 0}, -0.1, 0.1}, SurfaceProbe{{0, odd}, -0.1, 0.1},
                                SurfaceProbe{{0, 0}, odd, 0.1}, SurfaceProbe{{0, 0}, -0.1, odd}};
        const SpringSurfaceStep step = advance(surface, scratch, probes, 0.01);
        EXPECT_EQ(step.steps, 0U);
        for (const ProbeReaction& probe : step.probes) EXPECT_EQ(probe.force, 0);
    }
    const SurfaceProbe press{{0, 0}, -0.01, 0.1};
    for (const double dt : {none, -1.0, 0.0, -endless}) {
        const SpringSurfaceStep step = advance(surface, scratch, {&press, 1}, dt);
        EXPECT_EQ(step.seconds, 0);
        EXPECT_TRUE(all_zero(surface));
    }
    const SpringSurfaceStep step = advance(surface, scratch, {&press, 1}, endless);
    EXPECT_NEAR(step.seconds, longest_surface_call, 1e-12);
    EXPECT_TRUE(all_finite(surface));
}

/// Whether the surface equals its eight mirror images and rotations.
bool has_all_mirrors(const SpringSurface& surface) {
    const SpringSurfaceSettings& s = surface.settings;
    const std::size_t last = s.nodes - 1;
    for (std::size_t z = 0; z <= last; ++z) {
        for (std::size_t x = 0; x <= last; ++x) {
            for (const auto* values : {&surface.height, &surface.velocity}) {
                const double value = (*values)[surface_node_index(s, x, z)];
                if (value != (*values)[surface_node_index(s, last - x, z)]) return false;
                if (value != (*values)[surface_node_index(s, x, last - z)]) return false;
                if (value != (*values)[surface_node_index(s, z, x)]) return false;
            }
        }
    }
    return true;
}

TEST(SpringSurfaceStability, APushInTheMiddleKeepsAllMirrorImagesToTheBit) {
    for (const std::uint32_t nodes : {15U, 32U, 33U}) {
        for (const Rim rim : {Rim::pinned, Rim::free}) {
            SpringSurfaceSettings s{.nodes = nodes, .rim = rim};
            SpringSurface surface = make_spring_surface(s);
            SpringSurfaceScratch scratch;
            bool popped = false, left = false;
            for (int i = 0; i < 1500; ++i) {
                const double height = 0.3 * std::sin(-0.006 * i);
                const SurfaceProbe probe{.height = height, .radius = 0.17};
                const bool inside = advance(surface, scratch, {&probe, 1}, 0.001).probes[0].inside;
                popped = popped || inside;
                left = left || (popped && !inside);
                if (i % 50 == 0) {
                    ASSERT_TRUE(has_all_mirrors(surface)) << nodes << "; " << i;
                }
            }
            EXPECT_TRUE(popped && left);
            surface.height[surface_node_index(s, 3, 4)] += 1e-15;
            EXPECT_FALSE(has_all_mirrors(surface));
        }
    }
}

TEST(SpringSurfaceStability, ASleepingSurfaceIsExactlyLevelAndVisitsNoNodes) {
    SpringSurface surface = make_spring_surface({.damping = 5});
    SpringSurfaceScratch scratch;
    EXPECT_EQ(advance(surface, scratch, {}, 0.01).visited, 0U);
    const SurfaceProbe above{.height = 0.001, .radius = 0.1}, press{.height = -0.03, .radius = 0.1};
    EXPECT_EQ(advance(surface, scratch, {&above, 1}, 0.01).visited, 0U);
    for (int i = 0; i < 100; ++i) EXPECT_GE(advance(surface, scratch, {&press, 1}, 0.01).visited, 31U * 31);
    int awake = 0;
    double last = energy(surface);
    while (awake < 2000 && advance(surface, scratch, {}, 0.01).visited != 0) {
        ++awake;
        if (surface.asleep == 0) last = energy(surface);
    }
    EXPECT_GT(awake, 50);
    EXPECT_LT(awake, 1000);
    EXPECT_LE(last, 3 * surface.settings.tension * surface.settings.still * surface.settings.still);
    EXPECT_TRUE(all_zero(surface));
    EXPECT_EQ(energy(surface), 0);
    EXPECT_EQ(advance(surface, scratch, {}, 0.01).seconds, 0.01);
}

TEST(SpringSurface, AProbeInsideStaysInsideWhileTheSurfaceSleeps) {
    SpringSurface surface = make_spring_surface({.damping = 5});
    SpringSurfaceScratch scratch;
    const SurfaceProbe deep{.height = -0.5, .radius = 0.1};
    SpringSurfaceStep last;
    for (int i = 0; i < 2000 && (i == 0 || last.visited != 0); ++i)
        last = advance(surface, scratch, {&deep, 1}, 0.01);
    ASSERT_EQ(surface.asleep, 1U);
    last = advance(surface, scratch, {&deep, 1}, 0.01);
    EXPECT_EQ(last.visited, 0U);
    EXPECT_TRUE(last.probes[0].inside);
    EXPECT_FALSE(last.probes[1].inside);
}

TEST(SpringSurface, PressedHardItGivesWayAndTheProbeThatLeavesPullsALastRipple) {
    const SpringSurfaceSettings s;
    SpringSurface surface = make_spring_surface(s);
    SpringSurfaceScratch scratch;
    SurfaceProbe probe{.radius = 0.15};
    const auto step = [&] { return advance(surface, scratch, {&probe, 1}, 0.001).probes[0]; };
    double most = 0;
    ProbeReaction current;
    while (!current.inside && probe.height > -1) {
        probe.height -= 0.0002;
        current = step();
        most = std::max(most, current.force);
    }
    EXPECT_LE(most, s.pop_through);
    EXPECT_GT(most, 0.95 * s.pop_through);
    for (int i = 0; i < 3000; ++i) {
        current = step();
        ASSERT_EQ(current.force <= 0, true);  // while the probe is inside the surface, nothing may push it up
    }
    EXPECT_TRUE(current.inside);
    double least = 0, highest = 0;
    while (current.inside && probe.height < 1) {
        probe.height += 0.00005;
        current = step();
        least = std::min(least, current.force);
        highest = std::max(highest, current.height);
    }
    EXPECT_LT(least, -0.9 * s.cling);
    EXPECT_GE(least, -s.cling);
    EXPECT_GT(highest, 0.01);
    EXPECT_LT(current.height, probe.height);
    const double ripple = energy(surface);
    EXPECT_GT(ripple, 0.01);
    current = step();
    EXPECT_EQ(current.force, 0);
    EXPECT_FALSE(current.inside);
}

TEST(SpringSurface, TwoProbesPressAsEachAlone) {
    const SpringSurfaceSettings s;
    SpringSurface both = make_spring_surface(s), first = make_spring_surface(s),
                  second = make_spring_surface(s);
    SpringSurfaceScratch scratch;
    const std::array probes{SurfaceProbe{{-0.7, -0.6}, -0.01, 0.1}, SurfaceProbe{{0.8, 0.5}, -0.02, 0.1}};
    const std::array only_second{SurfaceProbe{{none, none}, 0, 0}, probes[1]};
    SpringSurfaceStep a, b, c;
    for (int i = 0; i < 40; ++i) {  // short enough that neither wave reaches the other probe
        a = advance(both, scratch, probes, 0.001);
        b = advance(first, scratch, {probes.data(), 1}, 0.001);
        c = advance(second, scratch, only_second, 0.001);
    }
    EXPECT_NEAR(a.probes[0].force, b.probes[0].force, 1e-9);
    EXPECT_NEAR(a.probes[1].force, c.probes[1].force, 1e-9);
    EXPECT_GT(a.probes[1].force, 1);
}

TEST(SpringSurface, HeightsBetweenNodesAreLinear) {
    const SpringSurfaceSettings s{.nodes = 9, .rim = Rim::free};
    SpringSurface surface = make_spring_surface(s);
    const auto plane = [](double x, double z) { return 0.3 + 0.2 * x - 0.5 * z; };
    for (std::size_t z = 0; z < 9; ++z) {
        for (std::size_t x = 0; x < 9; ++x)
            surface.height[surface_node_index(s, x, z)] =
                plane(0.25 * static_cast<double>(x) - 1, 0.25 * static_cast<double>(z) - 1);
    }
    for (const double x : {-1.0, -0.99, 0.0, 0.111, 0.99, 1.0}) {
        for (const double z : {-1.0, -0.3, 0.2501, 1.0})
            EXPECT_NEAR(height_at(surface, {x, z}), plane(x, z), 1e-14);
    }
    EXPECT_EQ(height_at(surface, {1.001, 0}), 0);
    EXPECT_EQ(height_at(surface, {0, -1.001}), 0);
    EXPECT_EQ(height_at(surface, {none, 0}), 0);
}

TEST(SpringSurface, DeeperAndDenserLayersMoveLess) {
    const SpringSurfaceSettings s;
    EXPECT_EQ(transmitted(s, 0, 1), 1);
    EXPECT_EQ(transmitted(s, -0.5, 1), 1);
    EXPECT_NEAR(transmitted(s, s.reach, 1), std::exp(-1.0), 1e-15);
    EXPECT_NEAR(transmitted(s, s.reach, 2), std::exp(-2.0), 1e-15);
    EXPECT_LT(transmitted(s, 0.2, 1), transmitted(s, 0.1, 1));
    EXPECT_EQ(transmitted(s, 1e300, 1e300), 0);
    EXPECT_EQ(transmitted(s, none, 1), 0);
    EXPECT_EQ(transmitted(s, 1, endless), 0);
}

TEST(SpringSurface, SettingsOutOfRangeAreNamed) {
    EXPECT_TRUE(checked(SpringSurfaceSettings{}));
    const auto message = [](const SpringSurfaceSettings& s) {
        return checked(s) ? "" : checked(s).error().message;
    };
    EXPECT_EQ(message({.nodes = 2}), "surface: nodes is 2; it must be 3 to 129");
    EXPECT_EQ(message({.shear = 1.5}), "surface: shear is 1.5; it must be 0 to 1");
    EXPECT_NE(message({.tension = none}).find("tension"), std::string::npos);
    EXPECT_NE(message({.damping = -1}).find("damping"), std::string::npos);
    EXPECT_NE(message({.max_steps = 0}).find("most_steps"), std::string::npos);
    EXPECT_NE(message({.areal_mass = 0}).find("areal_mass"), std::string::npos);
}

}  // namespace
}  // namespace thaum::fluid
