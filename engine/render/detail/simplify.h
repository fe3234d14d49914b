// render/detail/simplify.h: copies of a mesh with fewer triangles, for objects that are small on the screen.
//
// Vertices in the same cell of a grid are merged, and triangles that thereby lose a corner are removed
// (Rossignac and Borrel 1993). The displacement of the surface is known exactly. A renderer can therefore
// convert it to pixels and use the coarsest copy that looks the same.
#pragma once
#include "render/mesh.h"

namespace thaum::render {

struct Simplified {
    MeshData mesh;
    float error{};  ///< greatest distance by which a vertex was moved (m)
};

/// Merges the vertices within each cell of a grid around the middle of the mesh. Cells are cubes of width
/// `cell`, > 0 (m). All take the position of the outermost vertex, so that outlines stay. Each vertex keeps
/// its normal and colours.
Simplified clustered(const MeshData& mesh, float cell);

/// Returns increasingly coarse copies, each with at most three quarters of the triangles of the one before. A
/// simple mesh has none.
std::vector<Simplified> coarser_copies(const MeshData& mesh);

}  // namespace thaum::render
