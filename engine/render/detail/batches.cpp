#include "render/detail/batches.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "core/assert.h"

namespace thaum::render::detail {
namespace {

using Planes = std::array<fvec4, 6>;

/// The six sides of what the camera sees, normals inwards (Gribb and Hartmann 2001).
Planes frustum_planes(const fmat4& view_projection) {
    const fmat4 rows = glm::transpose(view_projection);
    Planes planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                  rows[3] - rows[1], rows[3] + rows[2], rows[3] - rows[2]};
    for (auto& p : planes) p /= glm::length(fvec3(p));
    return planes;
}

bool visible(const Planes& planes, const Bounds& bounds, const fmat4& model) {
    if (bounds.radius <= 0) return false;  // an empty mesh
    const auto there = placed(bounds, model);
    return std::all_of(planes.begin(), planes.end(), [&](const fvec4& plane) {
        return glm::dot(plane, fvec4(there.centre, 1)) > -there.radius;
    });
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

std::size_t collect(std::span<const Instance> instances, std::span<const Bounds> mesh_bounds,
                    const fmat4& view_projection, Batches& out) {
    const auto planes = frustum_planes(view_projection);
    auto& seen = out.seen;
    seen.clear();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const auto& instance = instances[i];
        THAUM_ASSERT(instance.mesh < mesh_bounds.size(), "an instance of a mesh that was never uploaded");
        if (finite(instance.model) && visible(planes, mesh_bounds[instance.mesh], instance.model)) {
            seen.emplace_back(instance.mesh, i);
        }
    }
    out.culled += instances.size() - seen.size();
    std::sort(seen.begin(), seen.end());
    const auto before = out.batches.size();
    for (const auto& [mesh, i] : seen) {
        const bool same = out.batches.size() > before && out.batches.back().mesh == mesh;
        if (!same) out.batches.push_back({mesh, out.instances.size(), 0});
        ++out.batches.back().count;
        const auto& seen_one = instances[i];
        out.instances.push_back({seen_one.model, fvec4(seen_one.tint, seen_one.glow), seen_one.sun});
    }
    return out.batches.size() - before;
}

}  // namespace thaum::render::detail
