// game/hud/furniture.h: the meshes of loose things and of the court's stations. All are centred as their bodies are.
#pragma once
#include "game/arena/arena.h"
#include "game/hud/picture.h"
#include "render/mesh.h"

namespace thaum::game {

/// What a thing is made of, and what of it shines by itself; the second may be empty.
struct FurnitureMesh {
    render::MeshData lit, glowing;
};

/// A box, cylinder or sphere of any surface.
FurnitureMesh furniture(const ShapeKey& key);

/// The cauldron as a surface of revolution of its solid, with legs, and the brew in it.
FurnitureMesh cauldron(const physics::TriangleMesh& solid);

/// Iron rings to swing from around a glowing core of radius 1; to be scaled.
FurnitureMesh anchor();

/// A flat plate to start from, centre on the ground, with the mark of the team (no_player: none).
FurnitureMesh start_plate(std::uint32_t team);

/// A ring of signs around the cauldron, flush with the ground.
render::MeshData rune_circle(float radius);

/// Shade that fades out, radius 1 m, on the ground at y = 0: 1 at the rim, darkest in the middle.
render::MeshData contact_shade(float darkest);

}  // namespace thaum::game
