// The textures of a scan (a volume of samples, such as a CT scan).
#pragma once
#include <cstddef>
#include <vector>

#include "render/detail/gl.h"
#include "render/detail/scan_bricks.h"

namespace thaum::render::detail {

struct GpuScan {
    Texture density, paint, bricks, table, materials;
    std::array<int, 3> count{};
    std::size_t bytes{};   ///< bytes for the density of each sample
    bool filled = false;   ///< true: the textures hold samples
    bool painted = false;  ///< true: the scan has colours or materials
    bool shows = false;    ///< true: at least one brick (of 8^3 samples) has a visible density
    std::uint64_t version{};
    std::uint64_t look{};  ///< hash of everything that decides which bricks have a visible density
    /// Hash of the contents of the colour table (transfer function) and of the materials.
    std::uint64_t colours{};
    std::vector<std::uint32_t> brick_versions;
    std::vector<DensityRange> ranges;  ///< range of densities of each brick (of 8^3 samples)
    /// For each brick, whether it has a visible density, and the distance to the nearest brick that has one.
    std::vector<std::uint8_t> shown, distances;
};

GpuScan make_gpu_scan();

/// Sends the parts of a scan that changed since the last call to its textures, and returns the number of
/// bricks sent. `scratch` is kept between calls. drawable(scan) must be true.
std::size_t send(const Scan& scan, GpuScan& gpu, std::vector<std::uint8_t>& scratch);

/// Hash of the contents of the colour table (transfer function) and of the materials.
std::uint64_t hash_colours(const Scan& scan);

}  // namespace thaum::render::detail
