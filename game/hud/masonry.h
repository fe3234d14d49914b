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

// Still stone in the world's frame; the first three are added to what is there already. A patch is a block, or a piece of
// decoration.

/// A box of masonry, lit as it stands in the arena. Faces that nobody can see are left out.
void add_masonry_box(const Shade& shade, const Thing& thing, render::Patchwork& out);

/// The sloping top of a ramp.
void add_masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid,
                      render::Patchwork& out);

/// Merlons on the walls, pilasters and banners.
void add_decoration(const Shade& shade, render::Patchwork& out);

/// The towers beyond; they are too far off to cast a shadow here.
render::Patchwork skyline();
/// What of both shines by itself.
render::Patchwork lamps(const Shade& shade);

}  // namespace thaum::game
