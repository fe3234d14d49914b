// field/voxel_state.h: hash and snapshots of a body of voxels.
//
// Hash and snapshots are computed brick by brick (8 x 8 x 8 voxels). The hash of the whole body combines a
// hash for each brick, so after an edit only the changed bricks are read again. In a snapshot a brick of
// equal voxels takes 9 bytes instead of 4 KB. Most bricks are like that, either empty or solid.
#pragma once
#include "core/bytes.h"
#include "core/error.h"
#include "field/voxels.h"

namespace thaum::field {

/// Hash of each brick (block of 8 x 8 x 8 voxels), kept so that only changed bricks are hashed again. With an
/// empty cache the hash of the body is the same, but takes longer.
struct BrickHashes {
    std::vector<std::uint64_t> hash{};
    std::uint32_t seen = 0;  ///< Bricks::newest (number of the body's last change) when the hashes were made
};

/// Hash of the body's density, colour and material, bit for bit. Reads only the bricks (8 x 8 x 8 voxels)
/// that changed since the last call.
std::uint64_t voxel_hash(const VoxelView& body, BrickHashes& hashes);

/// Appends a snapshot of all voxels to `out`.
void save(const VoxelView& body, Bytes& out);

/// Restores saved voxels. The body must have the same number of voxels along each axis. Bricks (8 x 8 x 8
/// voxels) that change get a new version number. On an error, such as bytes that end too early, the body may
/// hold part of the snapshot.
Expected<void> restore(const VoxelView& body, ByteReader& saved);

}  // namespace thaum::field
