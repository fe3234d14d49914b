// The six planes that bound the view of a camera.
#pragma once
#include <algorithm>
#include <array>

#include "render/mesh.h"

namespace thaum::render::detail {

using Planes = std::array<fvec4, 6>;

/// Planes with inward normals (Gribb and Hartmann 2001), in the frame that `to_clip` maps to clip space.
inline Planes frustum_planes(const fmat4& to_clip) {
    const fmat4 rows = glm::transpose(to_clip);
    Planes planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                  rows[3] - rows[1], rows[3] + rows[2], rows[3] - rows[2]};
    for (auto& p : planes) p /= glm::length(fvec3(p));
    return planes;
}

/// Returns true if part of the sphere may be inside the planes, so in view.
inline bool within(const Planes& planes, const Bounds& bounds) {
    return std::all_of(planes.begin(), planes.end(), [&](const fvec4& plane) {
        return glm::dot(plane, fvec4(bounds.centre, 1)) > -bounds.radius;
    });
}

}  // namespace thaum::render::detail
