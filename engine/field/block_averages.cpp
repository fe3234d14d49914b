#include "field/block_averages.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaum::field {
namespace {

/// Values of the samples up to which an edge has coarse steps.
constexpr std::size_t few_values = 100;
constexpr int widest_block = 16;
/// Blocks along an axis from which on they serve: fewer show nothing of a body's shape.
constexpr int fewest_blocks = 4;
/// Widest spacing from which on slices have steps of their own, in finest spacings.
constexpr double far_apart = 2;
/// Widest spacings in a block of samples with steps.
constexpr double over_steps = 2;

/// Calls use(sample) for each sample of a box until it returns false.
template <class Use>
void for_each_sample(const Grid& grid, const VoxelBox& box, Use use) {
    for (int k = box.low[2]; k < box.high[2]; ++k) {
        for (int j = box.low[1]; j < box.high[1]; ++j) {
            const float* row = grid.first + (k * grid.stride[2] + j * grid.stride[1]);
            for (int i = box.low[0]; i < box.high[0]; ++i)
                if (!use(row[i * grid.stride[0]])) return;
        }
    }
}

/// Average of the finite samples of a box; not a number if there are none.
float average(const Grid& grid, const VoxelBox& box) {
    double sum = 0;
    int finite = 0;
    for_each_sample(grid, box, [&](float sample) {
        sum += std::isfinite(sample) ? sample : 0;
        finite += std::isfinite(sample) ? 1 : 0;
        return true;
    });
    return finite > 0 ? static_cast<float>(sum / finite) : std::numeric_limits<float>::quiet_NaN();
}

/// Computes the averages of these blocks.
void fill(BlockAverages& averages, const Grid& grid, const VoxelBox& blocks) {
    std::array<std::size_t, 3> count{};
    std::ranges::transform(averages.count, count.begin(), [](int n) { return static_cast<std::size_t>(n); });
    for (int k = blocks.low[2]; k < blocks.high[2]; ++k) {
        for (int j = blocks.low[1]; j < blocks.high[1]; ++j) {
            float* row = &averages.samples[count[0] * (static_cast<std::size_t>(j) +
                                                       count[1] * static_cast<std::size_t>(k))];
            for (int i = blocks.low[0]; i < blocks.high[0]; ++i) {
                VoxelBox box;
                const std::array at{i, j, k};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    box.low[axis] = at[axis] * averages.block[axis];
                    box.high[axis] = std::min(box.low[axis] + averages.block[axis], grid.count[axis]);
                }
                row[i] = average(grid, box);
            }
        }
    }
}

/// Whether the samples have few values only, as those of a mask and of numbered parts.
bool has_steps(const Grid& grid) {
    std::array<float, few_values> known{};
    std::size_t count = 0;
    float last = std::numeric_limits<float>::quiet_NaN();
    bool few = true;
    for_each_sample(grid, {{}, grid.count}, [&](float sample) {
        if (sample == last || !std::isfinite(sample)) return true;
        last = sample;
        const auto end = known.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(known.begin(), end, sample) != end) return true;
        few = count < known.size();
        if (few) known[count++] = sample;
        return few;
    });
    return few;
}

std::array<int, 3> block_of(const Grid& grid) {
    const double widest = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    const double finest = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    const double width = (widest >= far_apart * finest || has_steps(grid) ? over_steps : 1) * widest;
    std::array<int, 3> block{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double samples = std::round(width / grid.spacing[static_cast<int>(axis)]);
        const int most = std::clamp(grid.count[axis] / fewest_blocks, 1, widest_block);
        block[axis] = static_cast<int>(std::clamp(samples, 1.0, static_cast<double>(most)));
    }
    return block;
}

}  // namespace

Grid BlockAverages::grid(const Grid& of) const {
    if (samples.empty()) return {};
    const vec3 width(block[0], block[1], block[2]);
    const std::ptrdiff_t row = count[0];
    return {.first = samples.data(),
            .count = count,
            .stride = {1, row, row * count[1]},
            .origin = of.origin + 0.5 * (width - vec3(1)) * of.spacing,
            .spacing = width * of.spacing,
            .kernel = Kernel::linear};
}

BlockAverages make_block_averages(const Grid& grid, const Bricks* bricks) {
    BlockAverages averages;
    if (bricks != nullptr) averages.newest = bricks->newest;
    if (grid.first == nullptr) return averages;
    averages.block = block_of(grid);
    if (averages.block == std::array{1, 1, 1}) return averages;
    std::size_t total = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        averages.count[axis] = (grid.count[axis] + averages.block[axis] - 1) / averages.block[axis];
        total *= static_cast<std::size_t>(averages.count[axis]);
    }
    averages.samples.resize(total);
    fill(averages, grid, {{}, averages.count});
    return averages;
}

void update(BlockAverages& averages, const Grid& grid, const Bricks& bricks) {
    if (averages.samples.empty() || averages.newest == bricks.newest) return;
    for_each_brick(bricks, {{}, bricks.count}, [&](std::array<int, 3> brick, std::size_t number) {
        if (bricks.version[number] <= averages.newest) return;
        const VoxelBox changed = brick_box(grid.count, brick);
        VoxelBox blocks;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            blocks.low[axis] = changed.low[axis] / averages.block[axis];
            blocks.high[axis] = (changed.high[axis] - 1) / averages.block[axis] + 1;
        }
        fill(averages, grid, blocks);
    });
    averages.newest = bricks.newest;
}

}  // namespace thaum::field
