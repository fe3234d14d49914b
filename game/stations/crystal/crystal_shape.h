// game/stations/crystal/crystal_shape.h: the key's shape that is to be carved from a crystal, and the
// crystal's initial rough body. Both are computed from a seed.
//
//     ring (bow) --- shaft --- bits      seen from +z; the key lies along x, its middle is the body's middle
//     rough body = key - bites + lumps   most of the key's volume is there, but the two overlap by half
//
// Each part is a solid with a formula for the depth below its surface. A voxel's density is 0.5 at the
// surface and changes from 0 to 1 within two voxels, like the rims that carving tools leave. Only + - * / and
// sqrt are used, so that every processor computes the same bits. The sizes of parts are in voxels of a body
// with 48 along each axis; other bodies scale them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths.h"

namespace thaum::game::inline stations {

/// Tooth of a key: a block on the side of the shaft. Lengths are in voxels.
struct KeyBit {
    double along{};  ///< x of the bit's middle
    double half{};   ///< half the bit's width along x
    double deep{};   ///< distance from the shaft's axis to the bit's end
};

inline constexpr std::size_t max_key_bits = 4;

/// Dimensions of a key (voxels).
struct KeyShape {
    double ring_x{};                          ///< x of the middle of the handle, a ring
    double ring_radius{};                     ///< radius of the middle line of the handle, a ring
    double ring_thick{};                      ///< radius of the cross-section of the handle, a ring
    double ring_high{};                       ///< height (y) of the handle, a ring, divided by its width (x)
    double shaft_end{};                       ///< x of the shaft's tip
    double shaft_thick{};                     ///< radius of the shaft
    double collar_x{};                        ///< x of the collar, a disc around the shaft
    double collar{};                          ///< radius of the collar
    double side{};                            ///< 1: the bits point up; -1: down
    std::array<KeyBit, max_key_bits> bits{};  ///< the bits; only the first `bit_count` are used
    std::size_t bit_count{};
};

KeyShape key_shape(std::uint64_t seed);

/// Density of the key in each voxel, x fastest, for a body with `voxels` along each axis.
std::vector<float> key_density(std::uint64_t seed, int voxels);
/// Writes key_density to `density`, which has one element for each voxel. Does not allocate.
void write_key_density(std::uint64_t seed, int voxels, std::span<float> density);

/// Density of the crystal before anyone carves it (the rough body). Its overlap with the key is between 0.4
/// and 0.65.
std::vector<float> rough_density(std::uint64_t seed, std::span<const float> key, int voxels);
/// Writes rough_density to `density`, which has one element for each voxel. Does not allocate.
void write_rough_density(std::uint64_t seed, std::span<const float> key, int voxels,
                         std::span<float> density);

}  // namespace thaum::game::inline stations
