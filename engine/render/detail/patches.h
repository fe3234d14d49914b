// Which patches of a patchwork a view sees, in how much detail and in which order. Pure: no OpenGL.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/detail/hidden.h"
#include "render/mesh.h"

namespace thaum::render::detail {

/// Where a view is looked at from, in the frame of what is looked at.
struct Sight {
    fmat4 to_clip{1};
    fvec3 eye{0};
    float pixel_angle{};  ///< rad, of one pixel in the middle of the view, or of finest_px of them
    std::span<const Hidden> hidden{};
};

struct IndexRange {
    std::uint32_t first{}, count{};
};

/// What a view sees of a patchwork: those that the sun may reach, and directly after them the others.
struct ChosenPatches {
    IndexRange sunlit{}, sunless{};
    IndexRange all() const { return {sunlit.first, sunlit.count + sunless.count}; }
};

struct PlacedPatch {
    Bounds bounds;
    fvec3 half{0};  ///< m, of the box around it, which has the same centre
    /// Seen from a point p, all triangles of the patch show their backs if the angle between p - apex and -axis has a
    /// cosine of at least `backs` (a cone of normals; > 1 where they face all ways).
    fvec3 apex{0}, axis{0};
    float backs = 2;
    float detail{};  ///< m
    bool sunless{};
    IndexRange full{}, plain{};  ///< `plain` may be empty
};

/// The patches of one patchwork; empty for an ordinary mesh.
struct PatchTable {
    std::vector<PlacedPatch> patches;
    std::vector<std::uint32_t> indices;  ///< those of all full patches come first
    std::uint32_t full_count{};          ///< of these
};

struct JoinedPatches {
    MeshData mesh;  ///< all vertices; the indices are the table's
    PatchTable table;
};
JoinedPatches joined(const Patchwork& patchwork);

/// How far off fine lines are told by colour (Vertex::far_away): m, where they begin to fade and where they are gone.
struct Fading {
    float from{}, gone{};
};
Fading fading_of(float pixel_angle);

/// Kept between frames for its memory.
struct PatchOrder {
    std::vector<std::pair<float, std::uint32_t>> near_first;  // m from the eye to its far end, patch
};

/// Appends the indices of what is seen, what is near first, so that it hides what is far before that is paid for.
ChosenPatches choose_patches(const PatchTable& table, const Sight& sight, PatchOrder& order,
                             std::vector<std::uint32_t>& out);

}  // namespace thaum::render::detail
