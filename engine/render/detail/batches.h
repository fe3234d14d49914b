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

/// A mesh that may stand for a finer one where nobody sees the difference.
struct Coarser {
    MeshId mesh{};
    float error{};  // m, as the finer one is made
};
/// Of one mesh, ever coarser; may be empty.
using Levels = std::vector<Coarser>;

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
    std::vector<Hidden> hidden;

    void clear();
};

fmat4 view_matrix(const Camera& camera);
/// Of a viewport `aspect` times as wide as high.
fmat4 projection_matrix(const Camera& camera, float aspect);

/// Is every number of it one?
bool finite(const fmat4& m);

/// The mesh's sphere where the instance has it, world frame.
Bounds placed(const Bounds& bounds, const fmat4& model);

/// What there is to draw, by mesh. Of `levels` there may be none.
struct MeshTables {
    std::span<const Bounds> bounds;
    std::span<const Levels> levels{};
};

/// Appends what a view sees, each as coarse as it may be there; returns the number of batches added.
std::size_t collect(std::span<const Instance> instances, const MeshTables& meshes, const Sight& sight,
                    Batches& out);

/// Chooses the patches of the batches from `first` on, and puts what is near before what is far: what hides is drawn
/// before what it hides. Patchworks are last, since they stand behind everything.
void arrange(std::size_t first, std::span<const PatchTable> tables, const Sight& world, Batches& out);

}  // namespace thaum::render::detail
