// A tip slides under the surface of round bodies, at depths of 0.1 to 0.9 of the radius, with friction 0 to
// 1, at up to 1 m/s. The force must follow the exact solution and never vanish while the tip is inside.
//
// Exact solution on a sphere of radius R: let theta be the angle at the centre between proxy and tip, and rho
// the distance of the tip from the centre. The pull has the normal part R - rho cos(theta) and the tangential
// part rho sin(theta). Coulomb's law, tangential = mu normal, then reads sin(theta + alpha) = sin(alpha) R /
// rho with alpha = atan(mu). If the right side exceeds 1, the proxy sticks wherever it is. A groove around an
// axis follows the same law with its own radius and a larger coefficient.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/scenes/worse.h"
#include "unit/haptics_round_rig.h"

namespace thaum::haptics {
namespace {

using namespace round_rig;

/// Angle by which the proxy lags behind the tip in steady sliding (rad), or -1 if it sticks forever.
double steady_lag(double radius, double tip_radius, double friction) {
    const double alpha = std::atan(friction);
    const double sine = std::sin(alpha) * radius / tip_radius;
    return sine < 1 ? std::asin(sine) - alpha : -1;
}

// ---- steady sliding ---------------------------------------------------------------------------------------

/// A slide of the tip along a circle at steady speed.
struct Circle {
    double radius{};       ///< radius of the circle (m)
    double depth_ratio{};  ///< depth of the tip divided by the radius
    double friction{};
    double speed{};  ///< speed of the tip along the surface (m/s)
};

std::vector<Circle> all_circles() {
    std::vector<Circle> circles;
    for (const double radius : {0.0075, 0.01, 0.025})
        for (const double depth_ratio : {0.1, 0.32, 0.6, 0.9})
            for (const double friction : {0.0, 0.05, 0.1, 0.35, 1.0})
                for (const double speed : {0.02, 0.2, 1.0})
                    circles.push_back({radius, depth_ratio, friction, speed});
    return circles;
}

std::string name_of(const Circle& c) {
    return "radius " + std::to_string(c.radius) + " depth " + std::to_string(c.depth_ratio) + " friction " +
           std::to_string(c.friction) + " speed " + std::to_string(c.speed);
}

/// Largest differences between the forces and the exact ones over a whole slide (N).
struct Errors {
    double steady{};  ///< largest error once the lag of the proxy is constant
    double before{};  ///< largest error while the proxy sticks and its lag grows
    int lost{};       ///< number of ticks without force, of which there should be none
};

/// Slides a tip along a circle of radius `tip_radius`. The proxy moves outside of that circle, on one of
/// radius `radius`; both circles are around the z axis. Friction here is the ratio of tangential to radial
/// pull at which the proxy slides.
Errors slide_round(Probe& probe, const Circle& c, double friction, double height) {
    Errors errors;
    const double radius = c.radius + surface_gap, tip_radius = c.radius * (1 - c.depth_ratio);
    const double lag = steady_lag(radius, tip_radius, friction);
    const vec3 up(0, 0, height);
    probe.at(polar(1.2 * c.radius, 0));
    probe.at(polar(tip_radius, 0) + up);
    double proxy = 0;
    for (int tick = 1; tick <= 400; ++tick) {
        const double angle = c.speed * dt / c.radius * tick;
        const vec3 tip = polar(tip_radius, angle) + up;
        const double normal = radius - tip_radius * std::cos(angle - proxy);
        const double along = tip_radius * std::sin(angle - proxy);
        const bool slides = std::abs(along) > friction * normal * (1 + 1e-12);
        if (slides && lag >= 0 && along > 0) proxy = angle - lag;
        if (slides && along < 0) return errors;  // the proxy is more than half a turn behind
        const ContactResult touched = probe.at(tip);
        if (glm::length(touched.force) == 0) ++errors.lost;
        const vec3 exact = stiffness * (polar(radius, proxy) - tip);
        (slides ? errors.steady : errors.before) =
            bench::worse(slides ? errors.steady : errors.before, glm::length(touched.force - exact));
    }
    return errors;
}

constexpr double steady_chatter = 1e-6;  // largest error of the force in steady sliding (N)
// Tolerance (N): the accuracy of our Runge-Kutta solution before steady sliding.
constexpr double judged_to = 1e-4;

TEST(RoundBodies, SteadySlidingOverASphereIsTheClosedForm) {
    for (const Circle& c : all_circles()) {
        Probe probe{rubbing_patch(c.friction)};
        add(probe.patch, SurfaceKind::sphere, {}, {c.radius, 0, 0});
        const Errors errors = slide_round(probe, c, c.friction, 0);
        EXPECT_EQ(errors.lost, 0) << name_of(c);
        EXPECT_LE(errors.steady, steady_chatter) << name_of(c);
        EXPECT_LE(errors.before, steady_chatter) << name_of(c);
    }
}

TEST(RoundBodies, SteadySlidingRoundCapsuleAndCylinderIsTheSame) {
    for (const SurfaceKind kind : {SurfaceKind::capsule, SurfaceKind::cylinder}) {
        for (const Circle& c : all_circles()) {
            Probe probe{rubbing_patch(c.friction)};
            add(probe.patch, kind, {}, {c.radius, 0.02, 0});
            // The body is rotated so that its axis is along z.
            probe.patch.bodies[0].orientation = rotation({1, 0, 0}, pi / 2);
            const Errors errors = slide_round(probe, c, c.friction, 0);
            EXPECT_EQ(errors.lost, 0) << name_of(c);
            EXPECT_LE(errors.steady, steady_chatter) << name_of(c);
            EXPECT_LE(errors.before, steady_chatter) << name_of(c);
        }
    }
}

/// Two overlapping spheres have a groove, a circle of radius c < R. The normal forces of both add up to R / c
/// times the radial pull.
TEST(RoundBodies, SteadySlidingInTheGrooveOfTwoSpheresIsTheClosedForm) {
    for (const double overlap : {0.3, 0.6, 0.9}) {  // half the distance of the centres, divided by R
        for (const Circle& c : all_circles()) {
            const double sphere = c.radius / std::sqrt(1 - overlap * overlap);
            Probe probe{rubbing_patch(c.friction)};
            add(probe.patch, SurfaceKind::sphere, {0, 0, overlap * sphere}, {sphere, 0, 0});
            add(probe.patch, SurfaceKind::sphere, {0, 0, -overlap * sphere}, {sphere, 0, 0});
            const Errors errors = slide_round(probe, c, c.friction * sphere / c.radius, 0);
            const double gap_force = 10 * stiffness * surface_gap * sphere / c.radius;
            EXPECT_EQ(errors.lost, 0) << name_of(c);
            EXPECT_LE(errors.steady, steady_chatter + gap_force) << name_of(c);
            EXPECT_LE(errors.before, steady_chatter + gap_force) << name_of(c);
        }
    }
}

/// A sphere stands on a floor, and the tip is inside both. Without friction the proxy is beside the tip, on
/// the circle where the sphere meets the floor.
TEST(RoundBodies, BetweenASphereAndTheFloorTheForceIsExact) {
    for (const Circle& c : all_circles()) {
        if (c.friction > 0) continue;
        const double sphere = 1.25 * c.radius;
        Probe probe{rubbing_patch(0)};
        add(probe.patch, SurfaceKind::sphere, {0, 0, 0.75 * c.radius}, {sphere, 0, 0});
        add(probe.patch, SurfaceKind::plane, {}, {0, 0, 1});
        probe.at(polar(3 * c.radius, 0) + vec3(0, 0, 0.01));
        const Errors errors = slide_round(probe, c, 0, -2 * c.radius);
        EXPECT_EQ(errors.lost, 0) << name_of(c);
        EXPECT_LE(errors.steady + errors.before, steady_chatter + 10 * stiffness * surface_gap) << name_of(c);
    }
}

/// The tip follows a helix at constant depth, with friction. Seen from the tip nothing changes, so the force
/// must not change either.
TEST(RoundBodies, AlongAHelixTheForceIsConstantSeenFromTheTip) {
    for (const SurfaceKind kind : {SurfaceKind::capsule, SurfaceKind::cylinder}) {
        for (const Circle& c : all_circles()) {
            Probe probe{rubbing_patch(c.friction)};
            add(probe.patch, kind, {}, {c.radius, 2, 0});
            const double tip_radius = c.radius * (1 - c.depth_ratio);
            if (c.speed < 0.1) continue;  // skipped, because the lag settles only over several radii
            const int settled = static_cast<int>(20 * c.radius / (c.speed * dt));
            probe.at({1.2 * c.radius, 0, 0});
            vec3 first(0);
            for (int tick = 0; tick < settled + 100; ++tick) {
                const double angle = 0.7 * c.speed * dt / c.radius * tick;
                const vec3 out(std::cos(angle), 0, std::sin(angle)), round(-out.z, 0, out.x);
                const vec3 tip = tip_radius * out + vec3(0, 0.7 * c.speed * dt * tick, 0);
                const vec3 force = probe.at(tip).force;
                ASSERT_GT(glm::length(force), 0) << name_of(c) << " at " << tick;
                const vec3 seen(glm::dot(force, out), force.y, glm::dot(force, round));
                // The proxy sticks forever, and the pull keeps growing.
                if (steady_lag(c.radius, tip_radius, c.friction) < 0) break;
                if (tick == settled) first = seen;
                if (tick > settled) {
                    ASSERT_LE(glm::length(seen - first), steady_chatter) << name_of(c);
                }
            }
        }
    }
}

// ---- from sticking to steady sliding ----------------------------------------------------------------------

/// Exact proxy on a sphere about the origin after the tip has moved (m). The proxy moves along the great
/// circle towards the tip until Coulomb's law holds.
vec3 exact_on_sphere(vec3 proxy, vec3 tip, double friction) {
    const double radius = glm::length(proxy), tip_radius = glm::length(tip);
    const vec3 out = proxy / radius;
    const vec3 along = tip - glm::dot(tip, out) * out;
    const double pull = glm::length(along), normal = radius - glm::dot(tip, out);
    const double lag = steady_lag(radius, tip_radius, friction);
    if (pull <= friction * normal || lag < 0) return proxy;
    const double turn = std::atan2(pull, glm::dot(tip, out)) - lag;
    return radius * (std::cos(turn) * out + std::sin(turn) * along / pull);
}

TEST(RoundBodies, OverASphereEveryTransientIsTheExactOne) {
    constexpr double radius = 0.02;
    for (const double friction : {0.0, 0.1, 0.35, 0.5, 1.0}) {
        for (const double speed : {0.05, 0.2, 1.0}) {
            Probe probe{rubbing_patch(friction)};
            add(probe.patch, SurfaceKind::sphere, {}, {radius, 0, 0});
            Wanderer tip{.random = Random{3}, .place = {0, 0.95 * radius, 0}};
            probe.at({0, 1.1 * radius, 0});
            probe.at(tip.place);
            vec3 proxy(0, radius + surface_gap, 0);
            for (int tick = 0; tick < 4000; ++tick) {
                vec3 place = tip.next(speed);
                const double rho = glm::length(place);
                place *= std::clamp(rho, 0.1 * radius, 0.9 * radius) / rho;
                tip.place = place;
                proxy = exact_on_sphere(proxy, place, friction);
                const ContactResult touched = probe.at(place);
                ASSERT_LE(glm::length(touched.force - stiffness * (proxy - place)), judged_to)
                    << friction << " at " << tick;
                proxy = touched.proxy;
            }
        }
    }
}

/// Exact place of the proxy without friction, for a tip inside the body (m): the nearest point of the round
/// side, and on a capsule also of its round ends.
vec3 foot_on_side(SurfaceKind kind, vec3 tip, double radius, double half) {
    const double held = kind == SurfaceKind::capsule ? std::clamp(tip.y, -half, half) : tip.y;
    const vec3 core(0, held, 0);
    return core + (radius + surface_gap) * glm::normalize(tip - core);
}

TEST(RoundBodies, WithoutFrictionTheProxyIsTheFootOnTheSideThatWasTouched) {
    constexpr double radius = 0.02, half = 0.015;
    for (const SurfaceKind kind : {SurfaceKind::capsule, SurfaceKind::cylinder}) {
        for (const double depth_ratio : {0.1, 0.4, 0.7, 0.9}) {
            for (const double speed : {0.05, 0.2, 1.0}) {
                Probe probe{rubbing_patch(0)};
                add(probe.patch, kind, {}, {radius, half, 0});
                probe.at({1.1 * radius, 0, 0});
                int lost = 0;
                double worst = 0;
                for (int tick = 0; tick < 2000; ++tick) {
                    const double angle = 0.8 * speed * dt / radius * tick;
                    // The tip moves up and down: on a cylinder to just before the point where the cap is
                    // nearer than the side, on a capsule over both ends.
                    const double reach = kind == SurfaceKind::capsule ? half + 0.4 * radius : half - 1e-5;
                    const double up = reach * std::sin(0.6 * speed * dt / reach * tick);
                    vec3 tip((1 - depth_ratio) * radius * std::cos(angle), up,
                             (1 - depth_ratio) * radius * std::sin(angle));
                    if (std::abs(up) > half) tip *= vec3(0.3, 1, 0.3);
                    const ContactResult touched = probe.at(tip);
                    const vec3 exact = stiffness * (foot_on_side(kind, tip, radius, half) - tip);
                    if (glm::length(touched.force) == 0) ++lost;
                    worst = bench::worse(worst, glm::length(touched.force - exact));
                }
                EXPECT_EQ(lost, 0) << depth_ratio << " at " << speed;
                EXPECT_LE(worst, 1e-6) << depth_ratio << " at " << speed;
            }
        }
    }
}

/// Exact proxy on a capsule, or on the side of a cylinder, after the tip has moved. The proxy moves along the
/// surface in the direction in which its distance to the tip decreases fastest, until Coulomb's law holds.
/// Runge-Kutta method, with the last step bisected.
struct Descent {
    SurfaceKind kind{};
    double radius{}, half{}, friction{};

    vec3 core(vec3 y) const {
        return {0, kind == SurfaceKind::capsule ? std::clamp(y.y, -half, half) : y.y, 0};
    }
    vec3 normal(vec3 y) const { return glm::normalize(y - core(y)); }
    vec3 on_surface(vec3 y) const { return core(y) + (radius + surface_gap) * normal(y); }
    vec3 along(vec3 y, vec3 tip) const { return tip - y - glm::dot(tip - y, normal(y)) * normal(y); }
    bool held(vec3 y, vec3 tip) const {
        return glm::length(along(y, tip)) <= 1e-14 + friction * glm::dot(y - tip, normal(y));
    }
    vec3 step(vec3 y, vec3 tip, double h) const {
        const vec3 a = along(y, tip), b = along(y + 0.5 * h * a, tip), c = along(y + 0.5 * h * b, tip),
                   d = along(y + h * c, tip);
        return on_surface(y + h / 6 * (a + 2.0 * b + 2.0 * c + d));
    }
    vec3 proxy(vec3 y, vec3 tip) const {
        double h = 0.02;
        for (int n = 0; n < 4000 && h > 1e-14 && !held(y, tip); ++n) {
            const vec3 next = step(y, tip, h);
            if (held(next, tip))
                h *= 0.5;
            else
                y = next;
        }
        return y;
    }
};

TEST(RoundBodies, OverCapsuleAndCylinderEveryTransientIsTheSteepestDescent) {
    constexpr double radius = 0.02, half = 0.015;
    for (const SurfaceKind kind : {SurfaceKind::capsule, SurfaceKind::cylinder}) {
        for (const double friction : {0.1, 0.35, 1.0}) {
            for (const double speed : {0.05, 0.2, 1.0}) {
                Probe probe{rubbing_patch(friction)};
                add(probe.patch, kind, {}, {radius, half, 0});
                const Descent exact{kind, radius, half, friction};
                Wanderer tip{.random = Random{11}, .place = {0.95 * radius, 0, 0}};
                probe.at({1.1 * radius, 0, 0});
                vec3 proxy = probe.at(tip.place).proxy;
                for (int tick = 0; tick < 1000; ++tick) {
                    vec3 place = tip.next(speed);
                    const double reach = kind == SurfaceKind::capsule ? half + 0.5 * radius : half - 1e-5;
                    place.y = std::clamp(place.y, -reach, reach);
                    const vec3 core = exact.core(place);
                    const double rho = glm::length(place - core);
                    place = core + std::clamp(rho, 0.1 * radius, 0.9 * radius) / rho * (place - core);
                    tip.place = place;
                    proxy = exact.proxy(proxy, place);
                    const ContactResult touched = probe.at(place);
                    ASSERT_LE(glm::length(touched.force - stiffness * (proxy - place)), judged_to)
                        << static_cast<int>(kind) << " friction " << friction << " speed " << speed << " at "
                        << tick;
                    proxy = touched.proxy;
                }
            }
        }
    }
}

}  // namespace
}  // namespace thaum::haptics
