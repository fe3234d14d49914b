// render/volume.h: a translucent body that emits and absorbs light, such as the cauldron's brew. A box of
// texels gives the emission and absorption at each place. A round vessel (an ellipsoid, called the round)
// bounds it, and the eye looks in through a surface, called the skin.
//
//        skin (triangles)
//     \~~~~~~~~~~~~~~~/
//      \   texels    /
//       `-._____.-'  round
//
// A ray starts where it meets the skin, or at the eye if the eye is inside. It ends where it leaves the round
// or meets an opaque object. In between, light is emitted and absorbed (Max 1995, "Optical models for direct
// volume rendering", section 4). From outside the volume is visible only through the skin, so the vessel must
// hide the rest.
//
// Outside the box the outermost texels are repeated, so neither the skin nor the round must fit the box.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/maths.h"

namespace thaum::render {

/// Handle of a volume, returned by Renderer::make_volume.
using VolumeId = std::uint32_t;

/// r, g, b: square root of the light, as a share of Volume::brightness. a: share of Volume::thickness.
struct Texel {
    std::uint8_t r{}, g{}, b{}, a{};
    bool operator==(const Texel&) const = default;
};

/// A corner of a triangle of the skin, the surface of a volume through which the eye looks in.
struct SkinVertex {
    fvec3 position{0};
    fvec3 normal{0, 1, 0};  ///< normal of the skin, pointing out of the volume (unit)
    float foam{};           ///< share of the skin that foam covers here, 0 to 1
};

/// A body that emits and absorbs light. It lies below its skin (the surface through which the eye looks in)
/// and within an ellipsoid, the round.
struct Volume {
    VolumeId id{};
    /// Version of texels and skin (upper surface). They are sent only if it differs from that at the last
    /// drawing of the volume with this id.
    std::uint64_t version{};
    std::array<int, 3> cells{};       ///< texels along x, y, z; x is contiguous
    std::span<const Texel> texels{};  ///< one texel for each cell; otherwise the volume is not drawn
    /// Corner and size of the box of texels (m).
    fvec3 origin{0}, size{1};
    /// The round, which is the ellipsoid that bounds the volume; its centre is at the level of the skin (m).
    fvec3 centre{0}, radii{1};
    float brightness = 1;  ///< light that a texel of 255 emits
    /// Absorption where alpha is 255 (1/m): light falls to 1/e over a length of 1 / thickness.
    float thickness = 4;
    std::span<const SkinVertex> skin{};
    /// Triangles of the skin, counter-clockwise seen from outside.
    std::span<const std::uint32_t> skin_indices{};
    fvec3 foam{0.8F};  ///< colour of the foam, linear light
};

}  // namespace thaum::render
