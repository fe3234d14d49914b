// Selects the instances (placed copies of meshes) that a view sees and sorts them into one draw call per
// mesh. No OpenGL.
#pragma once
#include <span>
#include <vector>

#include "render/detail/patches.h"
#include "render/mesh.h"
#include "render/scene.h"

namespace thaum::render::detail {

/// An instance in the layout of the vertex shader.
struct GpuInstance {
    fmat4 model;
    fvec4 tint_glow;
    float sun;
};

/// A coarser copy of a mesh, used if the difference is invisible.
struct Coarser {
    MeshId mesh{};
    float error{};  // greatest distance by which a vertex is moved, before the instance's scale (m)
};
/// Coarser copies of one mesh, from the finest to the coarsest. May be empty.
using Levels = std::vector<Coarser>;

struct Batch {
    MeshId mesh{};
    std::size_t first{}, count{};  // the instances of the batch: a range in Batches::instances
    float distance{};              // distance of the nearest instance along the view direction (m)
    // For a patchwork (a large fixed mesh in patches, of which only the visible ones are drawn): its visible
    // patches, in Batches::patch_indices.
    ChosenPatches patches{};
};

/// Batches (draw calls, each for all instances of one mesh) of a frame. All its views share one buffer of
/// instances and one of patches, so each buffer is sent once.
struct Batches {
    std::vector<GpuInstance> instances;
    std::vector<Batch> batches;
    std::vector<std::uint32_t> patch_indices;
    std::size_t culled{};

    // Scratch memory, kept between frames.
    std::vector<std::pair<MeshId, std::uint32_t>> seen;
    PatchOrder order;
    std::vector<Hidden> hidden;
    std::vector<PointLight> lights;

    void clear();
};

fmat4 view_matrix(const Camera& camera);
/// Projection for a viewport `aspect` times as wide as high.
fmat4 projection_matrix(const Camera& camera, float aspect);

/// Returns true if every element of the matrix is finite.
bool finite(const fmat4& m);

/// The bounding sphere of a mesh where the instance places it (m, world).
Bounds placed(const Bounds& bounds, const fmat4& model);

/// Tables of the uploaded meshes, indexed by mesh. `levels` may be empty.
struct MeshTables {
    std::span<const Bounds> bounds;
    std::span<const Levels> levels{};
};

/// Appends the instances that a view sees, each as the coarsest copy that looks the same at its
/// distance. Returns the number of batches added.
std::size_t collect(std::span<const Instance> instances, const MeshTables& meshes, const Sight& sight,
                    Batches& out);

/// Completes the batches (draw calls) from number `first` on: chooses the visible patches of large meshes,
/// and sorts the batches by distance, nearest first, so that objects are drawn before those that they hide.
/// Large meshes in patches, such as walls, come last, since they are behind everything.
void arrange(std::size_t first, std::span<const PatchTable> tables, const Sight& world, Batches& out);

}  // namespace thaum::render::detail
