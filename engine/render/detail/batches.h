// Which instances a view sees, sorted into one draw per mesh. Pure: no OpenGL.
#pragma once
#include <span>
#include <vector>

#include "render/mesh.h"
#include "render/scene.h"

namespace thaum::render::detail {

/// As the vertex shader takes it.
struct GpuInstance {
    fmat4 model;
    fvec4 tint_glow;
    float sun;
};

struct Batch {
    MeshId mesh{};
    std::size_t first{}, count{};  // in Batches::instances
};

/// All views of one frame share one buffer of instances, so that it is sent once.
struct Batches {
    std::vector<GpuInstance> instances;
    std::vector<Batch> batches;
    std::size_t culled{};

    // Kept between frames for its memory.
    std::vector<std::pair<MeshId, std::uint32_t>> seen;
};

fmat4 view_matrix(const Camera& camera);
/// Of a viewport `aspect` times as wide as high.
fmat4 projection_matrix(const Camera& camera, float aspect);

/// Is every number of it one?
bool finite(const fmat4& m);

/// The mesh's sphere where the instance has it, world frame.
Bounds placed(const Bounds& bounds, const fmat4& model);

/// Appends what a view sees; returns the number of batches added.
std::size_t collect(std::span<const Instance> instances, std::span<const Bounds> mesh_bounds,
                    const fmat4& view_projection, Batches& out);

}  // namespace thaum::render::detail
