// render/simplify.h: the same shape with fewer triangles, for where it is small on the screen.
//
// Vertices that lie in one cell of a grid become one, and triangles that lose a corner so are gone (Rossignac and Borrel 1993).
// How far the surface moved is known exactly, so a renderer can say in pixels what is lost, and take the coarsest copy
// of which nobody sees that it is one.
#pragma once
#include "render/mesh.h"

namespace thaum::render {

struct Simplified {
    MeshData mesh;
    float error{};  ///< m: no vertex moved farther
};

/// Cells are cubes, `cell` m wide (> 0), around the middle of the mesh. Of the vertices in one, the place of the outermost
/// stands for all, so that outlines stay; each keeps its normal and colours.
Simplified clustered(const MeshData& mesh, float cell);

/// Ever coarser copies, each with at most three quarters of the triangles of the one before; none of a mesh that is simple.
std::vector<Simplified> coarser_copies(const MeshData& mesh);

}  // namespace thaum::render
