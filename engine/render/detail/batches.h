// Which instances a view sees, sorted into one draw per mesh. Pure: no OpenGL.
#pragma once
#include <span>
#include <vector>

#include "render/detail/patches.h"
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
    float distance{};              // m ahead, of the nearest
    ChosenPatches patches{};       // of a patchwork, in Batches::patch_indices
};

/// All views of one frame share one buffer of instances and one of patches, so that each is sent once.
struct Batches {
    std::vector<GpuInstance> instances;
    std::vector<Batch> batches;
    std::vector<std::uint32_t> patch_indices;
    std::size_t culled{};

    // Kept between frames for its memory.
    std::vector<std::pair<MeshId, std::uint32_t>> seen;
    PatchOrder order;

    void clear();
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

/// Chooses the patches of the batches from `first` on, and puts what is near before what is far: what hides is drawn
/// before what it hides. Patchworks are last, since they stand behind everything.
void arrange(std::size_t first, std::span<const PatchTable> tables, const Sight& world, Batches& out);

}  // namespace thaum::render::detail
