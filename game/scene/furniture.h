// game/scene/furniture.h: the meshes of loose things and of the arena's furniture. Each mesh has the same
// origin as its body.
#pragma once
#include "game/picture/picture.h"
#include "render/mesh.h"

namespace thaum::game::inline scene {

/// A thing in two meshes: a lit part and a self-lit part. The second may be empty.
struct FurnitureMesh {
    render::MeshData lit, glowing;
};

/// The mesh of a box, cylinder or sphere with any surface.
FurnitureMesh furniture(const ShapeKey& key);

/// The cauldron with its legs and the painted brew. The bowl is the surface of revolution of `solid`.
FurnitureMesh cauldron(const physics::TriangleMesh& solid);

/// A swing anchor, a point to which ropes are attached: iron rings around a glowing core of radius 1, made
/// for scaling.
FurnitureMesh anchor();

/// A flat start pad with the team's mark, a ring or a triangle, centred on the ground. no_player: without a
/// mark.
FurnitureMesh start_plate(std::uint32_t team);

/// A ring of signs around the cauldron, level with the ground.
render::MeshData rune_circle(float radius);

/// A soft shade of radius 1 m on the ground at y = 0: light is multiplied by `darkest` in the middle and by 1
/// at the rim.
render::MeshData contact_shade(float darkest);

}  // namespace thaum::game::inline scene
