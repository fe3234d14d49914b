// game/scene/crystal_mesh.h: a coarse mesh of a crystal, for viewers too far away to see the difference to
// voxels.
#pragma once
#include <span>

#include "field/voxels.h"
#include "render/mesh.h"

namespace thaum::game::inline scene {

/// Mesh of the surface at density 0.5 of a cube of voxels, with half as many samples along each axis. Its
/// origin is the middle of the cube. `colours`: the square root of each voxel's light, as render::Scan has
/// it. `spacing`: distance between voxels (m).
render::MeshData crystal_mesh(std::span<const float> density, std::span<const field::Rgb8> colours, int side,
                              float spacing);

}  // namespace thaum::game::inline scene
