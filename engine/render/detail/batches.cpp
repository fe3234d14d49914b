#include "render/detail/batches.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "core/assert.h"
#include "render/detail/frustum.h"

namespace thaum::render::detail {
namespace {

constexpr float far_off = std::numeric_limits<float>::max();

/// Distance along the view direction of the nearest point of a bounding sphere (m).
float ahead(const fmat4& view_projection, const Bounds& there) {
    return (view_projection * fvec4(there.centre, 1)).w - there.radius;
}

/// Displacements of vertices below this size cannot be seen in the picture (px).
constexpr float unseen = 1;

/// Chooses the coarsest copy of a mesh whose error cannot be seen at the instance's nearest point.
MeshId level_for(MeshId mesh, const MeshTables& meshes, const Bounds& there, const Sight& sight) {
    if (mesh >= meshes.levels.size() || meshes.levels[mesh].empty()) return mesh;
    const float scale = there.radius / meshes.bounds[mesh].radius;
    // Size of one pixel at the nearest point (m).
    const float pixel = sight.pixel_angle * ahead(sight.to_clip, there);
    MeshId best = mesh;
    for (const auto& coarser : meshes.levels[mesh]) {
        if (coarser.error * scale > unseen * pixel) break;
        best = coarser.mesh;
    }
    return best;
}

}  // namespace

bool finite(const fmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(m[column][row])) return false;
        }
    }
    return true;
}

Bounds placed(const Bounds& bounds, const fmat4& model) {
    const auto stretch = [&](int axis) { return glm::dot(fvec3(model[axis]), fvec3(model[axis])); };
    return {fvec3(model * fvec4(bounds.centre, 1)),
            bounds.radius * std::sqrt(std::max({stretch(0), stretch(1), stretch(2)}))};
}

fmat4 view_matrix(const Camera& camera) {
    return glm::mat4_cast(glm::conjugate(camera.orientation)) * glm::translate(fmat4(1), -camera.position);
}

fmat4 projection_matrix(const Camera& camera, float aspect) {
    return glm::perspective(camera.fov_y, aspect, camera.near_plane, camera.far_plane);
}

std::size_t collect(std::span<const Instance> instances, const MeshTables& meshes, const Sight& sight,
                    Batches& out) {
    const auto planes = frustum_planes(sight.to_clip);
    auto& seen = out.seen;
    seen.clear();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const auto& instance = instances[i];
        THAUM_ASSERT(instance.mesh < meshes.bounds.size(), "an instance of a mesh that was never uploaded");
        const auto& own = meshes.bounds[instance.mesh];
        // An empty mesh is not drawn, nor an instance with a matrix that is not finite.
        if (own.radius <= 0 || !finite(instance.model)) continue;
        const auto there = placed(own, instance.model);
        if (within(planes, there) && !is_hidden(sight.hidden, there.centre, fvec3(there.radius)))
            seen.emplace_back(level_for(instance.mesh, meshes, there, sight), i);
    }
    out.culled += instances.size() - seen.size();
    std::sort(seen.begin(), seen.end());
    const auto before = out.batches.size();
    for (const auto& [mesh, i] : seen) {
        const bool same = out.batches.size() > before && out.batches.back().mesh == mesh;
        if (!same) out.batches.push_back({mesh, out.instances.size(), 0, far_off, {}});
        const auto& seen_one = instances[i];
        auto& batch = out.batches.back();
        ++batch.count;
        batch.distance =
            std::min(batch.distance, ahead(sight.to_clip, placed(meshes.bounds[mesh], seen_one.model)));
        out.instances.push_back({seen_one.model, fvec4(seen_one.tint, seen_one.glow), seen_one.sun});
    }
    return out.batches.size() - before;
}

void arrange(std::size_t first, std::span<const PatchTable> tables, const Sight& world, Batches& out) {
    for (std::size_t b = first; b < out.batches.size(); ++b) {
        auto& batch = out.batches[b];
        const auto& table = tables[batch.mesh];
        if (table.patches.empty()) continue;
        THAUM_ASSERT(batch.count == 1, "a patchwork stands in one place");
        const auto& model = out.instances[batch.first].model;
        out.hidden.clear();
        for (const auto& hidden : world.hidden) out.hidden.push_back(moved(hidden, model));
        const fmat4 from_world = glm::inverse(model);
        out.lights.assign(world.lights.begin(), world.lights.end());
        for (auto& light : out.lights) light.position = fvec3(from_world * fvec4(light.position, 1));
        const Sight own{world.to_clip * model, fvec3(from_world * fvec4(world.eye, 1)), world.pixel_angle,
                        out.hidden, out.lights};
        batch.patches = choose_patches(table, own, out.order, out.patch_indices);
        batch.distance = far_off;
    }
    std::sort(out.batches.begin() + static_cast<std::ptrdiff_t>(first), out.batches.end(),
              [](const Batch& a, const Batch& b) {
                  return std::pair(a.distance, a.mesh) < std::pair(b.distance, b.mesh);
              });
}

void Batches::clear() {
    instances.clear();
    batches.clear();
    patch_indices.clear();
    culled = 0;
}

}  // namespace thaum::render::detail
