#include "field/voxel_overlap.h"

#include "core/assert.h"

namespace thaum::field {

VoxelOverlap overlap_with(const VoxelView& body, std::span<const float> wanted, float threshold) {
    VoxelOverlap overlap;
    measure_overlap(body, wanted, threshold, overlap);
    return overlap;
}

void measure_overlap(const VoxelView& body, std::span<const float> wanted, float threshold,
                     VoxelOverlap& overlap) {
    THAUM_ASSERT(wanted.size() == body.density.size(), "the wanted body has another number of voxels");
    overlap.count = body.count;
    overlap.threshold = threshold;
    overlap.both = overlap.either = 0;
    overlap.inside.resize(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        overlap.inside[i] = wanted[i] >= threshold ? 2 : 0;
        overlap.either += wanted[i] >= threshold ? 1 : 0;
    }
    recount(overlap, body, body.all());
}

void recount(VoxelOverlap& overlap, const VoxelView& body, const VoxelBox& changed) {
    THAUM_ASSERT(overlap.count == body.count, "the overlap of another body");
    const auto width = static_cast<std::size_t>(std::max(changed.high[0] - changed.low[0], 0));
    for_each_row(body, changed, [&](std::size_t first, std::size_t) {
        for (std::size_t i = first; i < first + width; ++i) {
            const unsigned was = overlap.inside[i], wanted = was & 2U;
            const unsigned current = wanted | (body.density[i] >= overlap.threshold ? 1U : 0U);
            overlap.both += current == 3 ? 1 : 0;
            overlap.both -= was == 3 ? 1 : 0;
            overlap.either += current != 0 ? 1 : 0;
            overlap.either -= was != 0 ? 1 : 0;
            overlap.inside[i] = static_cast<std::uint8_t>(current);
        }
    });
}

}  // namespace thaum::field
