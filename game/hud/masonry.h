// game/hud/masonry.h: slate and worn brick. A face of a big box is laid with bevelled blocks in running bond, each with a
// shade of its own, and the light that never changes is baked into the vertices: corners that the sky does not reach,
// depth, and the low sun on the tops of the walls.
#pragma once
#include <vector>

#include "game/arena/arena.h"
#include "render/mesh.h"

namespace thaum::game {

/// What keeps light away: the boxes of the arena that never move.
struct Shade {
    struct Block {
        vec3 low{}, high{};  ///< m
    };
    std::vector<Block> blocks;
    std::vector<fvec3> lamps;  ///< on the walls, m
    fvec3 sun{};               ///< unit, towards it
    double half{};             ///< m, of the court between its walls
    double wall_top{};         ///< m
};
Shade make_shade(const Arena& arena, fvec3 towards_sun);

/// What the colour of a point with that normal is multiplied by; world frame.
fvec3 baked_light(const Shade& shade, vec3 point, fvec3 normal);

/// As baked_light, for all vertices of a mesh that stands there.
void bake(const Shade& shade, vec3 position, render::MeshData& mesh);

/// A box of masonry, in the box's own frame, lit as it stands in the arena. Faces that nobody can see are left out.
render::MeshData masonry_box(const Shade& shade, const Thing& thing);

/// The sloping top and the sides of a ramp.
render::MeshData masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid);

/// Merlons on the walls, banners, lamps, and the towers beyond; world frame.
render::MeshData decoration(const Shade& shade);
/// What of it shines by itself.
render::MeshData lamps(const Shade& shade);

}  // namespace thaum::game
