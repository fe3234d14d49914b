// game/hud/masonry.h: walls of slate and worn brick with baked light. Bevelled blocks in running bond cover
// each face of a large box, each block in its own shade. The vertices hold all constant light: the open share
// of the sky, the lamps, the darker depth, and whether the low sun arrives. The last is for pictures without
// a shadow map.
#pragma once
#include <vector>

#include "game/arena/arena.h"
#include "render/mesh.h"
#include "render/occlusion.h"

namespace thaum::game {

/// Blockers of light: the fixed boxes of the arena.
struct Shade {
    std::vector<render::Block> blocks;
    std::vector<fvec3> lamps;  ///< positions of the wall lamps (m)
    fvec3 sun{};               ///< unit direction towards the sun
    double half{};             ///< half the inner width of the arena (m)
    double wall_top{};         ///< height of the walls (m)
};
Shade make_shade(const Arena& arena, fvec3 towards_sun);

/// Constant light at a vertex, in the form of render::Vertex.
struct BakedLight {
    fvec3 lamps{};
    float open{};
    bool sunny{};
};
/// Constant light at a point with a unit normal (world frame).
BakedLight baked_light(const Shade& shade, vec3 point, fvec3 normal);

/// True if nothing stands between the point and the sun.
bool sees_sun(const Shade& shade, vec3 point);

/// Bakes the light into all vertices of a mesh at `position`.
void bake(const Shade& shade, vec3 position, render::MeshData& mesh);

// The functions below make fixed stone in the world frame. The first three append to `out`. A patch is one
// block or one piece of decoration.

/// Adds a box of masonry, lit at its place in the arena. Faces that no player can see are left out.
void add_masonry_box(const Shade& shade, const Thing& thing, render::Patchwork& out);

/// Adds the sloping top of a ramp.
void add_masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid,
                      render::Patchwork& out);

/// Adds merlons on the walls, pilasters and banners.
void add_decoration(const Shade& shade, render::Patchwork& out);

/// The towers outside the arena. They are too far away to cast a shadow into it.
render::Patchwork skyline();
/// The self-lit parts of the lamps and the towers.
render::Patchwork lamps(const Shade& shade);

}  // namespace thaum::game
