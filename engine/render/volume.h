// render/volume.h: what glows and hides all through, such as the cauldron's brew: a box of texels that tell the light each
// place gives and how much it swallows, in a round vessel, under a skin that the eye looks in through.
//
//        skin (triangles)           A ray begins where it meets the skin, or at the eye where that is inside; it ends where it
//     \~~~~~~~~~~~~~~~/             leaves the round or meets something opaque. Between, light is emitted and absorbed
//      \   texels    /              (Max 1995, "Optical models for direct volume rendering", section 4). From outside nothing
//       `-._____.-'  round          is seen but through the skin: the vessel must hide the rest.
//
// Where the box ends, its outermost texels go on, so that neither skin nor round need fit it.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/maths.h"

namespace thaum::render {

/// What Renderer::make_volume gave.
using VolumeId = std::uint32_t;

/// rgb: square root of the light, of Volume::brightness; a: share of Volume::thickness.
struct Texel {
    std::uint8_t r{}, g{}, b{}, a{};
    bool operator==(const Texel&) const = default;
};

struct SkinVertex {
    fvec3 position{0};
    fvec3 normal{0, 1, 0};  ///< unit, out of the volume
    float foam{};           ///< 0 to 1: how much of it is covered
};

struct Volume {
    VolumeId id{};
    /// Of texels and skin: they are sent only where it is another than at the id's last drawing.
    std::uint64_t version{};
    std::array<int, 3> cells{};       ///< texels along x, y, z; x is contiguous
    std::span<const Texel> texels{};  ///< as many; else the volume is not drawn
    fvec3 origin{0}, size{1};         ///< m, the box of texels
    fvec3 centre{0}, radii{1};        ///< m, the round: an ellipsoid; its centre is on the level of the skin
    float brightness = 1;             ///< light of a place whose texel is 255
    float thickness = 4;              ///< 1/m: light falls to 1/e over 1 / thickness where alpha is 255
    std::span<const SkinVertex> skin{};
    std::span<const std::uint32_t> skin_indices{};  ///< triangles, counter-clockwise from outside
    fvec3 foam{0.8F};                               ///< colour of foam, linear
};

}  // namespace thaum::render
