#include "field/voxel_state.h"

#include <bit>
#include <cstring>

#include "core/hash.h"

namespace thaum::field {
namespace {

/// All properties of a voxel, without padding, so that equal voxels have equal bytes.
struct Voxel {
    std::uint32_t density_bits;
    Rgb8 colour;
    std::uint8_t material;

    bool operator==(const Voxel&) const = default;
};
static_assert(sizeof(Voxel) == 8 && std::has_unique_object_representations_v<Voxel>);

/// The voxels of a brick (8 x 8 x 8 voxels), x fastest.
struct BrickVoxels {
    std::array<Voxel, voxels_of_brick> items;
    std::size_t count = 0;

    std::span<const Voxel> used() const { return {items.data(), count}; }
};

BrickVoxels read_brick(const VoxelView& body, const VoxelBox& box) {
    BrickVoxels brick;
    const auto width = static_cast<std::size_t>(box.high[0] - box.low[0]);
    for_each_row(body, box, [&](std::size_t first, std::size_t) {
        for (std::size_t i = first; i < first + width; ++i)
            brick.items[brick.count++] = {std::bit_cast<std::uint32_t>(body.density[i]), body.colour[i],
                                          body.material[i]};
    });
    return brick;
}

void write_brick(const VoxelView& body, const VoxelBox& box, const BrickVoxels& brick) {
    const auto width = static_cast<std::size_t>(box.high[0] - box.low[0]);
    std::size_t at = 0;
    for_each_row(body, box, [&](std::size_t first, std::size_t) {
        for (std::size_t i = first; i < first + width; ++i) {
            const Voxel& voxel = brick.items[at++];
            body.density[i] = std::bit_cast<float>(voxel.density_bits);
            body.colour[i] = voxel.colour;
            body.material[i] = voxel.material;
        }
    });
}

enum class BrickPacking : std::uint8_t { equal, full };

bool all_equal(const BrickVoxels& brick) {
    return std::ranges::all_of(brick.used(), [&](const Voxel& v) { return v == brick.items[0]; });
}

BrickVoxels unpack(ByteReader& saved, std::size_t count) {
    BrickVoxels brick;
    brick.count = count;
    const auto packing = saved.get<BrickPacking>();
    if (packing > BrickPacking::full) saved.reject();
    const std::size_t stored = packing == BrickPacking::equal ? 1 : count;
    const auto bytes = saved.get_bytes(stored * sizeof(Voxel));
    if (!saved.ok()) return brick;
    std::memcpy(brick.items.data(), bytes.data(), bytes.size());
    std::fill(brick.items.begin() + static_cast<std::ptrdiff_t>(stored),
              brick.items.begin() + static_cast<std::ptrdiff_t>(count), brick.items[0]);
    return brick;
}

}  // namespace

std::uint64_t voxel_hash(const VoxelView& body, BrickHashes& hashes) {
    const Bricks& bricks = *body.bricks;
    hashes.hash.resize(bricks.version.size());
    for_each_brick(bricks, {{}, bricks.count}, [&](std::array<int, 3> brick, std::size_t number) {
        if (bricks.version[number] <= hashes.seen) return;
        const BrickVoxels voxels = read_brick(body, brick_box(body.count, brick));
        hashes.hash[number] = hash_bytes(std::as_bytes(voxels.used()));
    });
    hashes.seen = bricks.newest;
    return hash_bytes(std::as_bytes(std::span(hashes.hash)), hash_value(body.count));
}

void save(const VoxelView& body, Bytes& out) {
    ByteWriter writer(out);
    for (const int n : body.count) writer.put(n);
    for_each_brick(*body.bricks, {{}, body.bricks->count}, [&](std::array<int, 3> brick, std::size_t) {
        const BrickVoxels voxels = read_brick(body, brick_box(body.count, brick));
        const bool equal = all_equal(voxels);
        writer.put(equal ? BrickPacking::equal : BrickPacking::full);
        writer.put_bytes(std::as_bytes(voxels.used().first(equal ? 1 : voxels.count)));
    });
}

Expected<void> restore(const VoxelView& body, ByteReader& saved) {
    std::array<int, 3> count{};
    for (int& n : count) n = saved.get<int>();
    if (!saved.ok() || count != body.count) return fail("the saved voxels are not those of this body");
    Bricks& bricks = *body.bricks;
    ++bricks.newest;
    for_each_brick(bricks, {{}, bricks.count}, [&](std::array<int, 3> brick, std::size_t number) {
        const VoxelBox box = brick_box(body.count, brick);
        const BrickVoxels current = read_brick(body, box), then = unpack(saved, current.count);
        if (!saved.ok() || std::ranges::equal(current.used(), then.used())) return;
        write_brick(body, box, then);
        bricks.version[number] = bricks.newest;
    });
    if (!saved.ok()) return fail("the saved voxels end too early");
    return {};
}

}  // namespace thaum::field
