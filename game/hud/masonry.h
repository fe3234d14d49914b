// game/hud/masonry.h: slate and worn brick. A face of a big box is laid with bevelled blocks in running bond, each with a
// shade of its own, and the light that never changes is baked into the vertices: corners that the sky does not reach,
// depth, the lamps, and whether the low sun arrives (for pictures without a shadow map).
#pragma once
#include <vector>

#include "game/arena/arena.h"
#include "render/mesh.h"
#include "render/occlusion.h"

namespace thaum::game {

/// What keeps light away: the boxes of the arena that never move.
struct Shade {
    std::vector<render::Block> blocks;
    std::vector<fvec3> lamps;  ///< on the walls, m
    fvec3 sun{};               ///< unit, towards it
    double half{};             ///< m, of the court between its walls
    double wall_top{};         ///< m
};
Shade make_shade(const Arena& arena, fvec3 towards_sun);

/// The light that never changes, as render::Vertex has it.
struct BakedLight {
    fvec3 lamps{};
    float open{};
    bool sunny{};
};
/// At a point with that unit normal; world frame.
BakedLight baked_light(const Shade& shade, vec3 point, fvec3 normal);

/// Whether nothing stands between the point and the sun.
bool sees_sun(const Shade& shade, vec3 point);

/// The baked light of all vertices of a mesh that stands there.
void bake(const Shade& shade, vec3 position, render::MeshData& mesh);

/// A box of masonry, in the box's own frame, lit as it stands in the arena. Faces that nobody can see are left out.
render::MeshData masonry_box(const Shade& shade, const Thing& thing);

/// The sloping top and the sides of a ramp.
render::MeshData masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid);

/// Merlons on the walls, banners and lamps; world frame.
render::MeshData decoration(const Shade& shade);
/// The towers beyond; they are too far off to cast a shadow here.
render::MeshData skyline();
/// What of both shines by itself.
render::MeshData lamps(const Shade& shade);

}  // namespace thaum::game
