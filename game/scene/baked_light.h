// game/scene/baked_light.h: constant light of an arena, computed once for each vertex: visible share of the
// sky, light of lamps, darkening with depth, and whether the low sun is visible. The last is used for
// pictures without a shadow map.
#pragma once
#include <vector>

#include "game/arena/arena.h"
#include "game/arena/look.h"
#include "render/mesh.h"
#include "render/occlusion.h"

namespace thaum::game::inline scene {

/// Everything that blocks light: the fixed boxes of the arena.
struct Shade {
    std::vector<render::Block> blocks;
    std::vector<fvec3> lamps;  ///< positions of the lamps (m, world)
    fvec3 sun{};               ///< unit direction towards the sun
    vec2 low{}, high{};        ///< inner bounds of the arena in x and z (m, world)
    double wall_top{};         ///< height of the walls (m, world)
    double depth{};            ///< depth of the lowest ground below y = 0 (m)
};
Shade make_shade(const Arena& arena, const ArenaLook& look);

/// Whether a point lies within the inner bounds, at any height. `margin` widens the bounds (m).
bool is_inside(const Shade& shade, vec3 point, double margin = 0);

/// Constant light at a vertex, in the form of render::Vertex.
struct BakedLight {
    fvec3 lamps{};
    float open{};
    bool sunny{};
};
/// Constant light at a point with a unit normal (world frame).
BakedLight baked_light(const Shade& shade, vec3 point, fvec3 normal);

/// Whether nothing stands between the point and the sun.
bool sees_sun(const Shade& shade, vec3 point);

/// Bakes the light into all vertices of a mesh at `position`.
void bake(const Shade& shade, vec3 position, render::MeshData& mesh);

}  // namespace thaum::game::inline scene
