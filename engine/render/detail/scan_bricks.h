// Densities of a scan as texels, and the bricks (cubes of 8^3 samples) that a ray may skip. No OpenGL.
#pragma once
#include <cstddef>
#include <vector>

#include "render/scan.h"

namespace thaum::render::detail {

/// A box of samples or bricks: its first element, and the number of elements along each axis.
struct ScanBox {
    std::array<int, 3> first{}, count{};
};

/// Lowest and highest density of a brick (a cube of 8^3 samples); 65,535 stands for 1. A brick includes the
/// first samples of the next brick along each axis, since the density between the two belongs to it.
struct DensityRange {
    std::uint16_t low{}, high{};
    bool operator==(const DensityRange&) const = default;
};

/// Returns true if the scan can be drawn: it has at least two samples along each axis, one value for each
/// sample, a finite invertible model, and everything that its way of drawing needs.
bool drawable(const Scan& scan);

/// Number of bytes with which the density of a sample is sent: 1 or 2.
std::size_t density_bytes(const Scan& scan);
/// Writes the densities of a box of samples as texels, x contiguous.
void pack_density(const Scan& scan, const ScanBox& box, std::vector<std::uint8_t>& out);
/// Writes colour and material of a box of samples, four bytes each.
void pack_paint(const Scan& scan, const ScanBox& box, std::vector<std::uint8_t>& out);

DensityRange density_range(const Scan& scan, const std::array<int, 3>& brick);

/// Runs along x of those bricks (cubes of 8^3 samples) whose version, which counts their changes, differs
/// from `sent`. Updates `sent`. If the versions are empty, or their number has changed, the result is one run
/// with all bricks.
std::vector<ScanBox> changed_bricks(const Scan& scan, std::vector<std::uint32_t>& sent);

/// Calls `visit(brick, index)` for each brick that contains one of the given bricks' samples: the bricks
/// themselves and their lower neighbours, which share samples with them.
template <class Visit>
void visit_sharing(const ScanBox& bricks, const std::array<int, 3>& count, Visit visit) {
    const auto from = [&](std::size_t axis) { return bricks.first[axis] > 0 ? bricks.first[axis] - 1 : 0; };
    const auto end = [&](std::size_t axis) { return bricks.first[axis] + bricks.count[axis]; };
    for (int z = from(2); z < end(2); ++z) {
        for (int y = from(1); y < end(1); ++y) {
            for (int x = from(0); x < end(0); ++x) {
                const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(count[1]) +
                                 static_cast<std::size_t>(y);
                visit(std::array{x, y, z},
                      row * static_cast<std::size_t>(count[0]) + static_cast<std::size_t>(x));
            }
        }
    }
}

/// Finds the bricks (cubes of 8^3 samples) in which the scan shows something. One byte for each brick: 1 or
/// 0.
void find_shown(const Scan& scan, const std::vector<DensityRange>& ranges, std::vector<std::uint8_t>& shown);

/// Distance of each brick to the nearest visible one: the largest of the distances along the three axes, in
/// bricks. At most 255.
void find_distances(const std::vector<std::uint8_t>& shown, const std::array<int, 3>& count,
                    std::vector<std::uint8_t>& distance);

}  // namespace thaum::render::detail
