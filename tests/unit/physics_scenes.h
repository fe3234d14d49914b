// Scenes shared by the tests of physics.
#pragma once

#include "core/hash.h"
#include "core/random.h"
#include "physics/physics.h"

namespace thaum::physics::scenes {

inline constexpr double dt = 0.001;
inline constexpr Key floor_key = 1;

inline BodyDesc box(vec3 half, double mass, double friction = 0.7) {
    return {.shape = Shape::box, .size = half, .mass = mass, .friction = friction};
}

inline BodyDesc ball(double radius, double mass) {
    return {.shape = Shape::sphere, .size = {radius, 0, 0}, .mass = mass, .rolling_friction = 0.02};
}

inline BodyState at(vec3 position, vec3 velocity = {}) {
    return {.position = position, .velocity = velocity};
}

/// Adds a floor with its top at y = 0.
inline void add_floor(Physics& physics) { physics.add(floor_key, box({50, 1, 50}, 0), at({0, -1, 0})); }

inline BodyDesc wizard() {
    return {.shape = Shape::capsule, .size = {0.35, 0.55, 0}, .mass = 75, .friction = 0, .upright = 1};
}

/// Adds a floor, 14 boxes stacked askew, and two wizards.
inline void add_pile(Physics& physics) {
    add_floor(physics);
    for (Key i = 0; i < 14; ++i) {
        const auto level = i / 2;
        const double side = i % 2 == 0 ? -0.28 : 0.28;
        physics.add(10 + i, box({0.25, 0.2, 0.25}, 5),
                    at({side + 0.02 * level, 0.25 + 0.45 * level, 0.03 * i}));
    }
    physics.add(30, wizard(), at({-3, 1.2, 0}));
    physics.add(31, wizard(), at({3, 1.2, 0}));
}

/// A hilly mesh of one-sided triangles, `cells` by `cells` squares of 1 m, centred on the origin.
inline TriangleMesh hills(std::uint32_t cells, double height) {
    TriangleMesh mesh;
    const std::uint32_t row = cells + 1;
    for (std::uint32_t z = 0; z < row; ++z) {
        for (std::uint32_t x = 0; x < row; ++x) {
            const double up = height * det::sin(0.9 * x) * det::cos(0.7 * z);
            mesh.vertices.push_back({x - cells / 2.0, up, z - cells / 2.0});
        }
    }
    for (std::uint32_t z = 0; z < cells; ++z) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t a = z * row + x, b = a + 1, c = a + row, d = c + 1;
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({b, c, d});
        }
    }
    return mesh;
}

using Keys = std::vector<Key>;

inline std::uint64_t hash_of(const Physics& physics, const Keys& keys) {
    std::uint64_t hash = 0;
    for (const Key key : keys) {
        hash = hash_combine(hash, key);
        hash = hash_combine(hash, hash_value(physics.state(key)));
    }
    return hash;
}

inline std::uint64_t hash_of(std::span<const Contact> contacts) {
    std::uint64_t hash = 0;
    for (const Contact& c : contacts) {
        hash = hash_combine(hash, c.a);
        hash = hash_combine(hash, c.b);
        hash = hash_combine(hash, hash_value(c.point));
        hash = hash_combine(hash, hash_value(c.normal));
        hash = hash_combine(hash, hash_value(c.impulse));
        hash = hash_combine(hash, c.began ? 1 : 0);
    }
    return hash;
}

}  // namespace thaum::physics::scenes
