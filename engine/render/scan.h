// render/scan.h: a body of samples on a grid, such as a CT scan or a carved block, placed in the world.
//
//     samples --low, high--> density 0 to 1 --+-- table ------> translucent: colour and opacity along a ray
//                                             '-- level ------> surface: the places of one density
//     model: own frame -> world; own frame: m, the middle of all samples is the origin
//
// Between samples the density is trilinear. A view may show any number of scans. They are drawn after all
// solid objects. Surfaces write depth, so they hide and are hidden like meshes, also where they cross each
// other. A ray through a translucent scan ends at the depth of the scene, so a tool inside is seen through
// the part in front of it.
//
// Translucent scans are drawn one after another, the one with the farthest middle first. Where two of them
// overlap, this is not exact: one of them is drawn completely over the other. Shadows ignore scans: a scan
// neither casts nor receives any.
//
// A ray skips bricks of 8^3 samples in which the table or the level shows nothing. An edit sends only the
// bricks whose version changed, within the same picture.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include "core/maths.h"
#include "field/voxels.h"

namespace thaum::render {

/// Handle of a scan, returned by Renderer::make_scan.
using ScanId = std::uint32_t;

/// Samples along one side of a brick, a cube of samples that is sent or skipped as a whole.
inline constexpr int scan_brick = 8;

/// Number of bricks (cubes of 8^3 samples) along each axis for a given number of samples. The last brick of
/// an axis may be smaller.
constexpr std::array<int, 3> bricks_of(const std::array<int, 3>& samples) {
    return {(samples[0] + scan_brick - 1) / scan_brick, (samples[1] + scan_brick - 1) / scan_brick,
            (samples[2] + scan_brick - 1) / scan_brick};
}

/// One sample for each place, x contiguous. A float that is NaN counts as Scan::low.
using ScanSamples = std::variant<std::span<const std::uint8_t>, std::span<const std::int16_t>,
                                 std::span<const std::uint16_t>, std::span<const float>>;

/// Colour and opacity of one density.
struct ScanEntry {
    fvec3 colour{1};  ///< colour in linear light
    float opacity{};  ///< share of the light that a layer of thickness Scan::unit hides, 0 to 1
};

/// How the voxels with one material index are drawn.
struct ScanMaterial {
    fvec3 colour{1};    ///< factor of the colour
    float opacity = 1;  ///< factor of the absorption; a surface with less than 0.5 is invisible
};

/// Colour and opacity at the densities 0, 1/255, ..., 1. Between them colour and absorption are linear.
using ScanTable = std::array<ScanEntry, 256>;

/// Whether one sees through a scan or only its surface.
enum class ScanLook : std::uint8_t { translucent, surface };

/// A body of samples on a grid, such as a CT scan, and how it is drawn.
struct Scan {
    ScanId id{};
    /// Version of all samples, colours and materials. They are examined only if it differs from that at the
    /// last drawing of the scan with this id.
    std::uint64_t version{};
    /// Samples along x, y, z: at least 2 and at most what OpenGL allows (GL_MAX_3D_TEXTURE_SIZE) each,
    /// otherwise the scan is not drawn.
    std::array<int, 3> count{};
    ScanSamples samples{};
    /// Samples that mean density 0 and 1. Bytes from 0 to 255 take half the memory of all others.
    float low = 0, high = 1;
    /// Version of each brick (cube of 8^3 samples), x contiguous. Bricks with a new version are sent. Empty:
    /// all bricks are sent.
    std::span<const std::uint32_t> brick_versions{};
    /// Factor for the colour of each sample, stored as the square root of the factor. Empty: 1.
    std::span<const field::Rgb8> colours{};
    std::span<const std::uint8_t> materials{};  ///< index into `material_table` of each sample; empty: 0
    /// At most 256 materials; an index without a material changes nothing.
    std::span<const ScanMaterial> material_table{};

    fvec3 spacing{1};  ///< distance between samples along each axis (m, own frame)
    /// From the scan's own frame to the world: rotation, scale and translation; must be invertible.
    fmat4 model{1};

    ScanLook look = ScanLook::translucent;
    // Values of a translucent scan:
    const ScanTable* table{};  ///< colour and opacity by density; null: the scan is not drawn
    float unit = 0.01F;  ///< thickness of the layer to which the opacities of the table apply (m, own frame)
    /// true: shaded by sky and sun, with the density's gradient as normal; false: the matter glows.
    bool lit = false;
    /// Distance between samples along a ray, in distances between the samples of the scan. It is doubled
    /// while a picture has fewer rays than pixels, as quick ones have.
    float step = 0.5F;
    // Values of a surface:
    float level = 0.5F;  ///< density of the surface; denser places are inside
    fvec3 colour{1};     ///< colour in linear light
    float sun = 1;       ///< share of the sunlight that reaches the surface

    bool leaps = true;  ///< false: rays do not skip bricks (of 8^3 samples) that show nothing; for tests
};

/// Resolution of the scans of a view. In a quick picture one ray serves 3 x 3 pixels at Quality::low, 2 x 2
/// at medium and one at high.
enum class ScanDetail : std::uint8_t {
    automatic,  ///< sharp if the scans look the same as in the previous picture, otherwise quick
    quick,
    sharp,
};

}  // namespace thaum::render
