// unit/haptics_round_rig.h: a probe over round surfaces, and a wandering tip.
#pragma once
#include <cmath>

#include "core/random.h"
#include "core/units.h"
#include "haptics/surface/surface.h"

namespace thaum::haptics::round_rig {

inline constexpr double dt = tick_seconds;
inline constexpr double stiffness = 500;  // stiffness of the surfaces (N/m)

/// A surface patch whose one body has the given friction. It has no surfaces yet.
inline SurfacePatch rubbing_patch(double friction) {
    SurfacePatch patch;
    patch.bodies[0].material = {
        .stiffness = stiffness, .static_friction = friction, .dynamic_friction = friction};
    patch.bodies[0].key = 7;
    patch.body_count = 1;
    return patch;
}

inline void add(SurfacePatch& patch, SurfaceKind kind, vec3 a, vec3 b, vec3 c = {}) {
    patch.surfaces[patch.count] = {.kind = kind, .part = patch.count, .a = a, .b = b, .c = c};
    ++patch.count;
}

/// A patch of surfaces near a tip, and the state of the contact between them.
struct Probe {
    SurfacePatch patch{};
    SurfaceState state{};

    ContactResult at(vec3 tip) { return touch(patch, state, {tip, {}}, dt); }
};

inline vec3 polar(double radius, double angle) {
    return {radius * std::sin(angle), radius * std::cos(angle), 0};
}

inline vec3 random_vec(Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// A tip that wanders at a given speed (m/s) and takes a new direction every few ticks.
struct Wanderer {
    Random random;
    vec3 place{};  ///< position of the tip (m)
    vec3 way{};
    int turns{};

    vec3 next(double speed) {
        if (turns-- == 0) {
            way = glm::normalize(random_vec(random) + vec3(1e-9, 0, 0));
            turns = 5 + static_cast<int>(random.below(60));
        }
        return place += speed * dt * way;
    }
};

}  // namespace thaum::haptics::round_rig
