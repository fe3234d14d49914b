// unit/haptics_surface_rig.h: patches of surfaces and a probe that touches them.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "core/random.h"
#include "core/units.h"
#include "haptics/surface/surface.h"

namespace thaum::haptics::surface_tests {

inline constexpr double dt = tick_seconds;
inline constexpr double stiffness = 500;  // stiffness of the surfaces (N/m)
// Known error of the force with friction (N), which comes from the gap between proxy and surface.
inline constexpr double gap_force = 1.5 * stiffness * surface_gap;
inline constexpr double rounding = 1e-9;  // accepted rounding error of a force (N)

inline std::uint32_t add_body(SurfacePatch& patch,
                              const SurfaceMaterial& material = {.stiffness = stiffness}) {
    SurfaceBody body;
    body.material = material;
    body.key = 100 + patch.body_count;
    patch.bodies[patch.body_count] = body;
    return patch.body_count++;
}

inline Surface& add(SurfacePatch& patch, SurfaceKind kind, vec3 a, vec3 b, vec3 c = {}) {
    if (patch.body_count == 0) add_body(patch);
    patch.surfaces[patch.count] = {
        .kind = kind, .body = patch.body_count - 1, .part = patch.count, .a = a, .b = b, .c = c};
    return patch.surfaces[patch.count++];
}

inline constexpr SurfaceMaterial rough{
    .stiffness = stiffness, .static_friction = 0.6, .dynamic_friction = 0.4};

inline SurfacePatch floor_patch(const SurfaceMaterial& material = {.stiffness = stiffness}) {
    SurfacePatch patch;
    add_body(patch, material);
    add(patch, SurfaceKind::plane, {}, {0, 1, 0});
    return patch;
}

/// A tip that jumps to a place, without a path in between.
struct Probe {
    SurfacePatch patch{};
    SurfaceState state{};

    ContactResult at(vec3 tip, vec3 velocity = {}) { return touch(patch, state, {tip, velocity}, dt); }
    /// Moves the bodies by their velocities for one tick. The tip stays where it is.
    void advance() {
        for (std::uint32_t i = 0; i < patch.count; ++i) {
            Surface& s = patch.surfaces[i];
            const SurfaceBody& body = patch.bodies[s.body];
            const vec3 by = dt * body.velocity;
            s.a += by;
            if (s.kind == SurfaceKind::triangle || s.kind == SurfaceKind::sheet) {
                s.b += by;
                s.c += by;
            }
        }
        for (std::uint32_t i = 0; i < patch.body_count; ++i)
            patch.bodies[i].position += dt * patch.bodies[i].velocity;
    }
};

inline vec3 random_vec(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

inline vec3 random_unit(Random& random) {
    for (;;) {
        const vec3 v = random_vec(random, 1);
        const double length = glm::length(v);
        if (length > 0.1 && length < 1) return v / length;
    }
}

inline void expect_near(vec3 a, vec3 b, double by, const std::string& what = {}) {
    EXPECT_LE(glm::length(a - b), by)
        << what << ": " << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

inline void add_box_mesh(SurfacePatch& patch, vec3 half, SurfaceKind kind) {
    const auto corner = [&](int i) {
        return half * vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    };
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces) {
        add(patch, kind, corner(f[0]), corner(f[1]), corner(f[2]));
        add(patch, kind, corner(f[0]), corner(f[2]), corner(f[3]));
    }
}

}  // namespace thaum::haptics::surface_tests
