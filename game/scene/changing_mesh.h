// game/scene/changing_mesh.h: a mesh whose triangles change while the arena is shown.
#pragma once
#include "render/scene.h"

namespace thaum::game::inline scene {

struct ChangingMesh {
    render::MeshId mesh{};
    render::MeshData triangles{};
    std::uint64_t version = 0;  ///< number of changes of the mesh so far

    render::MeshChange change() const { return {mesh, version, &triangles}; }
};

}  // namespace thaum::game::inline scene
