// A tip that goes anywhere over and in round bodies, edges and grooves: while it is inside it is felt, within
// Coulomb's cone, and the
// proxy enters nothing. The places are judged by geometry of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "unit/haptics_round_rig.h"

namespace thaum::haptics {
namespace {

using namespace round_rig;

// ---- every shape --------------------------------------------------------------------------------------------------

/// A convex body as the half-spaces and round solids that bound it, for judging a proxy without the code under test.
struct Scene {
    std::string name;
    SurfacePatch patch{};
    vec3 start{};   ///< place of the tip before it enters (m)
    vec3 middle{};  ///< place about which the tip wanders (m)
    double size{};  ///< distance to which it wanders (m)
};

struct Judged {
    double depth{};  ///< depth of a place beneath the surface (m); below zero outside
    vec3 normal{};
};

/// Depth of p in one solid and the normal there; for a box and a cylinder by the nearest face.
std::vector<Judged> judged(const Surface& s, vec3 p) {
    const vec3 arm = p - s.a;
    const auto from_core = [&](vec3 out, double radius) {
        return Judged{radius - glm::length(out), glm::normalize(out)};
    };
    switch (s.kind) {
        case SurfaceKind::sphere: return {from_core(arm, s.b.x)};
        case SurfaceKind::capsule:
            return {from_core(arm - vec3(0, std::clamp(arm.y, -s.b.y, s.b.y), 0), s.b.x)};
        case SurfaceKind::cylinder:
            return {
                from_core({arm.x, 0, arm.z}, s.b.x), {s.b.y - arm.y, {0, 1, 0}}, {s.b.y + arm.y, {0, -1, 0}}};
        case SurfaceKind::box: {
            std::vector<Judged> faces;
            for (int axis = 0; axis < 3; ++axis) {
                for (const double sign : {1.0, -1.0}) {
                    vec3 normal(0);
                    normal[axis] = sign;
                    faces.push_back({s.b[axis] - sign * arm[axis], normal});
                }
            }
            return faces;
        }
        case SurfaceKind::plane: return {{-glm::dot(s.b, arm), s.b}};
        default: {
            const vec3 normal = glm::normalize(glm::cross(s.b - s.a, s.c - s.a));
            return {{-glm::dot(normal, arm), normal}};
        }
    }
}

double depth_in(const Surface& s, vec3 p) {
    double depth = HUGE_VAL;
    for (const Judged& j : judged(s, p)) depth = std::min(depth, j.depth);
    return depth;
}

/// Least by which Coulomb's law is broken with the loads that the normals bear (m, of pull); below zero inside the
/// cone.
double beyond_cone(const std::vector<vec3>& normals, vec3 pull, double friction) {
    double best = glm::length(pull);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double load = glm::dot(pull, normals[i]);
        if (load > 0) best = std::min(best, glm::length(pull - load * normals[i]) - friction * load);
        for (std::size_t j = 0; j < i; ++j) {
            const double g = glm::dot(normals[i], normals[j]), a = load, b = glm::dot(pull, normals[j]);
            if (1 - g * g < 1e-12) continue;
            const double u = (a - g * b) / (1 - g * g), v = (b - g * a) / (1 - g * g);
            if (u < 0 || v < 0) continue;
            best = std::min(best, glm::length(pull - u * normals[i] - v * normals[j]) - friction * (u + v));
        }
    }
    return best;
}

std::vector<Scene> convex_scenes() {
    constexpr double radius = 0.02;
    std::vector<Scene> scenes;
    const auto scene = [&](const char* name, SurfaceKind kind, vec3 size) {
        Scene s{.name = name, .start = {0.002, 0.05, 0.001}, .size = 0.9 * radius};
        add(s.patch, kind, {}, size);
        scenes.push_back(s);
    };
    scene("sphere", SurfaceKind::sphere, {radius, 0, 0});
    scene("capsule", SurfaceKind::capsule, {radius, 0.015, 0});
    scene("cylinder", SurfaceKind::cylinder, {radius, 0.012, 0});
    scene("box", SurfaceKind::box, {radius, 0.012, 0.015});
    Scene touching{.name = "two spheres that touch", .start = {-0.0001, 0.015, 0}, .size = radius};
    add(touching.patch, SurfaceKind::sphere, {-radius, 0, 0}, {radius, 0, 0});
    add(touching.patch, SurfaceKind::sphere, {radius, 0, 0}, {radius, 0, 0});
    scenes.push_back(touching);
    Scene standing{.name = "sphere on a floor", .start = {0.015, 0.03, 0}, .size = 1.2 * radius};
    add(standing.patch, SurfaceKind::sphere, {0, 0.8 * radius, 0}, {radius, 0, 0});
    add(standing.patch, SurfaceKind::plane, {}, {0, 1, 0});
    scenes.push_back(standing);
    return scenes;
}

/// In contact while inside, and within the cone, wherever the tip goes.
void wander(const Scene& scene, double friction, double speed, std::uint64_t seed) {
    const std::string name =
        scene.name + " friction " + std::to_string(friction) + " speed " + std::to_string(speed);
    Probe probe{scene.patch};
    const SurfaceMaterial material = rubbing_patch(friction).bodies[0].material;
    probe.patch.bodies[0] = rubbing_patch(friction).bodies[0];
    probe.patch.bodies[0].material = material;
    probe.patch.body_count = 1;
    Wanderer tip{.random = Random{seed}, .place = scene.start};
    probe.at(tip.place);
    int lost = 0, inside = 0;
    double worst_cone = 0, worst_entry = 0;
    for (int tick = 0; tick < 3000; ++tick) {
        vec3 place = tip.next(speed);
        if (glm::length(place - scene.middle) > scene.size) tip.way = -glm::normalize(place - scene.middle);
        const Touched touched = probe.at(place);
        std::vector<vec3> normals;
        double depth = -1;
        for (std::uint32_t i = 0; i < scene.patch.count; ++i) {
            const Surface& s = scene.patch.surfaces[i];
            depth = std::max(depth, depth_in(s, place));
            worst_entry = std::max(worst_entry, depth_in(s, touched.proxy));
            if (depth_in(s, touched.proxy) < -1e-8) continue;
            for (const Judged& j : judged(s, touched.proxy))
                if (std::abs(j.depth) < 1e-8) normals.push_back(j.normal);
        }
        if (depth < 1e-6) continue;
        ++inside;
        if (touched.contacts == 0 || glm::length(touched.force) == 0) ++lost;
        worst_cone = std::max(worst_cone, beyond_cone(normals, touched.proxy - place, friction) /
                                              glm::length(touched.proxy - place));
    }
    EXPECT_GT(inside, 300) << name;
    EXPECT_EQ(lost, 0) << name << " of " << inside;
    EXPECT_LE(worst_cone, 1e-5) << name;
    EXPECT_LE(worst_entry, 1e-12) << name << ": the proxy went inside";
}

TEST(RoundBodies, WhileTheTipIsInsideItIsInContactAndWithinTheFrictionCone) {
    for (const Scene& scene : convex_scenes())
        for (const double friction : {0.0, 0.1, 0.35, 1.0})
            for (const double speed : {0.05, 0.2, 1.0})
                for (const std::uint64_t seed : {1U, 2U}) wander(scene, friction, speed, seed);
}

// ---- edges of meshes ----------------------------------------------------------------------------------------------

/// Without friction, under a ridge and in a trench of two sloping faces each 0.1 m wide, along and across the edge.
TEST(RoundBodies, SharpAndConcaveEdgesOfAMeshKeepTheForce) {
    for (const double slope : {0.2, 1.0, 3.0, -0.2, -1.0, -3.0}) {  // above zero: a ridge
        for (const double friction : {0.0, 0.1, 0.35, 1.0}) {
            for (const double speed : {0.05, 0.2, 1.0}) {
                Probe probe{rubbing_patch(friction)};
                const double w = 0.1 / std::sqrt(1 + slope * slope), h = -slope * w;
                const std::array left{vec3(-w, h, -0.1), vec3(-w, h, 0.1)};
                const std::array right{vec3(w, h, -0.1), vec3(w, h, 0.1)};
                const std::array edge{vec3(0, 0, -0.1), vec3(0, 0, 0.1)};
                add(probe.patch, SurfaceKind::triangle, left[0], left[1], edge[0]);
                add(probe.patch, SurfaceKind::triangle, left[1], edge[1], edge[0]);
                add(probe.patch, SurfaceKind::triangle, edge[0], edge[1], right[0]);
                add(probe.patch, SurfaceKind::triangle, edge[1], right[1], right[0]);
                Wanderer tip{.random = Random{5}, .place = {0.001, 0.001, 0}};
                probe.at({0.001, 0.02, 0});
                int lost = 0, inside = 0;
                const vec3 middle(0, slope > 0 ? -0.008 : 0, 0);
                for (int tick = 0; tick < 2000; ++tick) {
                    vec3 place = tip.next(speed);
                    const vec3 off = place - middle;
                    if (glm::length(off) > 0.01) tip.way = -glm::normalize(off);
                    const double under = -slope * std::abs(place.x) - place.y;
                    const Touched touched = probe.at(place);
                    if (under < 1e-6) continue;
                    ++inside;
                    if (touched.contacts == 0 || glm::length(touched.force) == 0) ++lost;
                    std::vector<vec3> normals;
                    for (const double side : {-1.0, 1.0}) {
                        const vec3 normal = glm::normalize(vec3(side * slope, 1, 0));
                        const double off = glm::dot(normal, touched.proxy);
                        if (std::abs(off) < 1e-8) normals.push_back(normal);
                    }
                    ASSERT_LE(beyond_cone(normals, touched.proxy - place, friction),
                              1e-5 * glm::length(touched.proxy - place))
                        << slope << ' ' << friction << ' ' << speed << " at " << tick;
                }
                EXPECT_GT(inside, 50);
                EXPECT_EQ(lost, 0) << slope << ' ' << friction << ' ' << speed << " of " << inside;
            }
        }
    }
}

// ---- attacks ------------------------------------------------------------------------------------------------------

/// A closed box of two-sided triangles, from whose walls round bodies stick out: half spheres on faces, a capsule
/// along an edge, a
/// cylinder through a corner.
SurfacePatch cave(double half, double friction) {
    SurfacePatch patch = rubbing_patch(friction);
    const auto corner = [&](int i) {
        return half * vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    };
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces) {
        add(patch, SurfaceKind::sheet, corner(f[0]), corner(f[1]), corner(f[2]));
        add(patch, SurfaceKind::sheet, corner(f[0]), corner(f[2]), corner(f[3]));
    }
    add(patch, SurfaceKind::sphere, {0, -half, 0}, {0.5 * half, 0, 0});
    add(patch, SurfaceKind::sphere, {0.5 * half, -0.6 * half, 0}, {0.4 * half, 0, 0});
    add(patch, SurfaceKind::capsule, {half, 0, half}, {0.3 * half, 0.8 * half, 0});
    add(patch, SurfaceKind::cylinder, {-half, half, half}, {0.5 * half, 0.6 * half, 0});
    return patch;
}

TEST(RoundBodies, NoSpeedTakesTheProxyThroughRoundBodiesOrTheWallsBesideThem) {
    constexpr double half = 0.02;
    for (const double friction : {0.0, 0.3, 1.0}) {
        Probe probe{cave(half, friction)};
        Random random{17};
        vec3 tip(0, 0.5 * half, 0);
        probe.at(tip);
        for (int n = 0; n < 60'000; ++n) {
            const double size = std::pow(10.0, random.uniform(-5, 1));
            tip = n % 2 == 0 ? tip + 1e-3 * random_vec(random) : size * random_vec(random);
            if (n % 7 == 0) tip = half * random_vec(random);
            const Touched touched = probe.at(tip);
            const vec3 x = probe.state.proxy;
            ASSERT_TRUE(std::abs(x.x) < half && std::abs(x.y) < half && std::abs(x.z) < half)
                << n << " friction " << friction;
            bool inside = std::max({std::abs(tip.x), std::abs(tip.y), std::abs(tip.z)}) > half;
            for (std::uint32_t i = 12; i < probe.patch.count; ++i) {
                ASSERT_LE(depth_in(probe.patch.surfaces[i], x), 0) << n << " friction " << friction;
                inside = inside || depth_in(probe.patch.surfaces[i], tip) > 1e-9;
            }
            if (inside) {
                ASSERT_GT(touched.contacts, 0U) << n << " friction " << friction;
                ASSERT_GT(glm::length(touched.force), 0) << n << " friction " << friction;
            }
        }
    }
}

/// A ball that rolls and a spinning barrel carry the proxy that sticks to them, and push the one that slides.
TEST(RoundBodies, MovingBodiesCarryAndPushTheProxy) {
    for (const SurfaceKind kind : {SurfaceKind::sphere, SurfaceKind::capsule, SurfaceKind::cylinder}) {
        for (const double friction : {0.0, 0.35, 5.0}) {
            Probe probe{rubbing_patch(friction)};
            constexpr double radius = 0.02;
            add(probe.patch, kind, {}, {radius, 0.03, 0});
            SurfaceBody& body = probe.patch.bodies[0];
            body.velocity = {0.01, 0.02, 0};
            body.spin = {0, 3, 0};
            probe.at({0.0001, 0, 0.025});
            for (int tick = 0; tick < 400; ++tick) {
                probe.patch = moved_on(probe.patch, dt);
                const vec3 tip(0.0001, 0, 0.012);
                const Touched touched = probe.at(tip);
                const Surface& s = probe.patch.surfaces[0];
                const double depth = depth_in(s, tip);
                if (depth < 1e-6) continue;
                ASSERT_GT(touched.contacts, 0U) << tick;
                ASSERT_NEAR(depth_in(s, touched.proxy), -surface_gap, 1e-12) << tick;
                const vec3 normal = judged(s, touched.proxy)[0].normal;
                ASSERT_LE(beyond_cone({normal}, touched.proxy - tip, friction), 1e-9) << tick;
                if (friction == 0) {
                    ASSERT_NEAR(glm::length(touched.force), stiffness * depth, 1e-6) << tick;
                }
            }
        }
    }
}

TEST(RoundBodies, AtTheEndOfThePatchTheProxyStaysOnItsSurface) {
    for (const double friction : {0.0, 0.2}) {
        constexpr double radius = 0.02;
        Probe probe{rubbing_patch(friction)};
        add(probe.patch, SurfaceKind::sphere, {}, {radius, 0, 0});
        probe.patch.centre = {0, radius, 0};
        probe.patch.reach = 0.005;
        probe.at({0, 1.1 * radius, 0});
        for (int tick = 0; tick < 100; ++tick) {
            const vec3 tip = polar(0.7 * radius, 0.01 * tick);
            const Touched touched = probe.at(tip);
            ASSERT_GT(touched.contacts, 0U) << tick;
            ASSERT_NEAR(glm::length(touched.proxy), radius + surface_gap, 1e-12) << tick;
            ASSERT_LE(glm::length(touched.proxy - probe.patch.centre), 0.005 + 1e-12) << tick;
        }
        EXPECT_EQ(probe.state.limited, 1U);
    }
}

}  // namespace
}  // namespace thaum::haptics
