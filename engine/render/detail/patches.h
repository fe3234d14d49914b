// Selects the patches of a patchwork (a large fixed mesh) that a view sees, each in full detail or in plain
// form, and their order. No OpenGL.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/detail/hidden.h"
#include "render/mesh.h"

namespace thaum::render::detail {

/// The eye and projection of a view, in the frame in which the objects that it sees are given.
struct Sight {
    fmat4 to_clip{1};
    fvec3 eye{0};
    /// Angle below which detail need not be drawn (rad): that of 1 pixel in the middle of the view, or of 2
    /// pixels at low quality.
    float pixel_angle{};
    std::span<const Hidden> hidden{};
    /// Lights near which patches need light at each pixel instead of each vertex; none if no patch does.
    std::span<const PointLight> lights{};
};

struct IndexRange {
    std::uint32_t first{}, count{};
    IndexRange first_of(std::uint32_t n) const { return {first, n}; }           ///< the first n indices
    IndexRange after(std::uint32_t n) const { return {first + n, count - n}; }  ///< all but the first n
};

/// The patches of a large mesh that a view sees: first those that the sun may reach, directly followed by the
/// others.
struct ChosenPatches {
    IndexRange sunlit{}, sunless{};
    /// Numbers of indices at the beginning of `sunlit` and of `sunless` that belong to patches near a light,
    /// where light changes much between the corners of a triangle.
    std::uint32_t near_light_sunlit{}, near_light_sunless{};
    IndexRange all() const { return {sunlit.first, sunlit.count + sunless.count}; }
};

struct PlacedPatch {
    Bounds bounds;
    fvec3 half{0};  ///< half size of the box around the patch; its centre is that of `bounds` (m)
    /// Cone that contains all normals. All triangles of the patch face away from a point p if the angle
    /// between p - apex and -axis has a cosine of at least `backs`. `backs` is > 1 if the triangles face in
    /// all directions.
    fvec3 apex{0}, axis{0};
    float backs = 2;
    float detail{};  ///< size of the detail that the plain form of the patch lacks (m)
    bool sunless{};
    float longest_edge{};  ///< length of the longest edge of a triangle (m)
    /// Ranges in PatchTable::indices of the full and the plain form of the patch; the plain one may be empty.
    IndexRange full{}, plain{};
};

/// The patches of one large mesh in patches (a patchwork); empty for an ordinary mesh.
struct PatchTable {
    std::vector<PlacedPatch> patches;
    /// Vertex indices of all patches in full detail, then those of the plain forms.
    std::vector<std::uint32_t> indices;
    std::uint32_t full_count{};  ///< number of vertex indices of the patches in full detail
};

struct JoinedPatches {
    MeshData mesh;  ///< vertices of all patches; the indices are in `table`
    PatchTable table;
};
JoinedPatches joined(const Patchwork& patchwork);

/// Distances (m) at which fine lines begin to fade into the colour around them, and at which they have done
/// so. Their colour is then multiplied by Vertex::far_away.
struct Fading {
    float from{}, gone{};
};
Fading fading_of(float pixel_angle);

/// Scratch memory for sorting patches by distance, kept between frames.
struct PatchOrder {
    // Distance from the eye to the far end of each patch (m), and the patch.
    std::vector<std::pair<float, std::uint32_t>> near_first;
};

/// Appends the indices of the visible patches, nearest first, so that near patches hide far ones before those
/// are shaded.
ChosenPatches choose_patches(const PatchTable& table, const Sight& sight, PatchOrder& order,
                             std::vector<std::uint32_t>& out);

}  // namespace thaum::render::detail
