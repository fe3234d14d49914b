#include "field/block_averages.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaum::field {
namespace {

/// Largest number of distinct sample values with which the surface of a body counts as having coarse steps,
/// as that of a mask has.
constexpr std::size_t few_values = 100;
constexpr int widest_block = 16;
/// Fewest blocks along an axis for which averages are made. Fewer blocks would not show the shape of a body.
constexpr int fewest_blocks = 4;
/// Smallest ratio of the widest to the finest spacing at which the slices of a scan count as coarse steps.
constexpr double far_apart = 2;
/// Smallest result of steadiness() at which slices that are far apart make no coarse steps. Slices that each
/// average their whole thickness, as those of most scans do, have 0.31 on a level surface and more on others,
/// but less on sheets thinner than two slices; those of a mask have 0.
constexpr double steady = 0.28;
/// Edge of a block if slices make coarse steps or samples have few values, as a multiple of the widest
/// distance between samples.
constexpr double over_steps = 2;

/// Average of the finite samples of a box; NaN if there are none. `first` is the grid's first sample.
template <class T>
float average(const Grid& grid, const T* first, const VoxelBox& box) {
    double sum = 0;
    int finite = 0;
    for (int k = box.low[2]; k < box.high[2]; ++k) {
        for (int j = box.low[1]; j < box.high[1]; ++j) {
            const T* row = first + (k * grid.stride[2] + j * grid.stride[1]);
            for (int i = box.low[0]; i < box.high[0]; ++i) {
                const auto sample = static_cast<float>(row[i * grid.stride[0]]);
                sum += std::isfinite(sample) ? sample : 0;
                finite += std::isfinite(sample) ? 1 : 0;
            }
        }
    }
    return finite > 0 ? static_cast<float>(sum / finite) : std::numeric_limits<float>::quiet_NaN();
}

/// Number of blocks along x that are summed together, so that memory is read in order.
constexpr int together = 64;

/// The box of samples that a box of blocks covers.
VoxelBox samples_of(const BlockAverages& averages, const Grid& grid, const VoxelBox& blocks) {
    VoxelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = blocks.low[axis] * averages.block[axis];
        box.high[axis] = std::min(blocks.high[axis] * averages.block[axis], grid.count[axis]);
    }
    return box;
}

/// Adds each sample of a row to the sum of its block, in the order of the row.
template <class T>
void add_row(const T* row, std::ptrdiff_t stride, int samples, int block, double* sums) {
    for (int first = 0; first < samples; first += block, ++sums) {
        const int end = std::min(first + block, samples);
        for (int i = first; i < end; ++i) *sums += static_cast<double>(row[i * stride]);
    }
}

/// Computes the averages of up to `together` blocks along x.
template <class T>
void fill_run(BlockAverages& averages, const Grid& grid, const T* first, const VoxelBox& run) {
    std::array<double, together> sums{};
    const VoxelBox all = samples_of(averages, grid, run);
    for (int k = all.low[2]; k < all.high[2]; ++k) {
        for (int j = all.low[1]; j < all.high[1]; ++j) {
            const T* row = first + (k * grid.stride[2] + j * grid.stride[1] + all.low[0] * grid.stride[0]);
            add_row(row, grid.stride[0], all.high[0] - all.low[0], averages.block[0], sums.data());
        }
    }
    const int rows = (all.high[1] - all.low[1]) * (all.high[2] - all.low[2]);
    const std::ptrdiff_t count = averages.count[0];
    float* result =
        averages.samples.data() + count * (run.low[1] + averages.count[1] * std::ptrdiff_t{run.low[2]});
    for (int i = run.low[0]; i < run.high[0]; ++i) {
        VoxelBox one = run;
        one.low[0] = i;
        one.high[0] = i + 1;
        const VoxelBox box = samples_of(averages, grid, one);
        const double sum = sums[static_cast<std::size_t>(i - run.low[0])];
        // A sample that is not finite makes the sum not finite. Then only the finite samples are averaged.
        result[i] = std::isfinite(sum) ? static_cast<float>(sum / (rows * (box.high[0] - box.low[0])))
                                       : average(grid, first, box);
    }
}

/// Computes the average of the samples of each block in the range `blocks`.
void fill(BlockAverages& averages, const Grid& grid, const VoxelBox& blocks) {
    const auto fill_row = [&](int j, int k, const auto* first) {
        for (int i = blocks.low[0]; i < blocks.high[0]; i += together)
            fill_run(averages, grid, first,
                     {{i, j, k}, {std::min(i + together, blocks.high[0]), j + 1, k + 1}});
    };
    for (int k = blocks.low[2]; k < blocks.high[2]; ++k) {
        for (int j = blocks.low[1]; j < blocks.high[1]; ++j)
            grid.with_samples([&](const auto* first) { fill_row(j, k, first); });
    }
}

constexpr int in_a_row = 16;
/// Whether the next `in_a_row` samples, which are adjacent in memory, all equal `value`, as in most parts of
/// a mask.
template <class T>
bool all_equal(const T* samples, float value) {
    bool equal = true;
    for (int i = 0; i < in_a_row; ++i) equal &= static_cast<float>(samples[i]) == value;
    return equal;
}

/// The distinct finite sample values seen so far, until they are no longer few.
struct FewValues {
    std::array<float, few_values> known{};
    std::size_t count = 0;
    float last = std::numeric_limits<float>::quiet_NaN();

    /// Adds a sample value if it is new. Returns false once there are more than `few_values`.
    bool add(float sample) {
        if (sample == last || !std::isfinite(sample)) return true;
        last = sample;
        const auto end = known.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(known.begin(), end, sample) != end) return true;
        if (count == known.size()) return false;
        known[count++] = sample;
        return true;
    }
};

/// Whether the samples take so few values that a body's surface has coarse steps, as in masks and in numbered
/// segments.
template <class T>
bool has_steps(const Grid& grid, const T* first) {
    FewValues values;
    for (int k = 0; k < grid.count[2]; ++k) {
        for (int j = 0; j < grid.count[1]; ++j) {
            const T* row = first + (k * grid.stride[2] + j * grid.stride[1]);
            for (int i = 0; i < grid.count[0]; ++i) {
                const bool more = grid.stride[0] == 1 && grid.count[0] - i >= in_a_row;
                if (more && all_equal(row + i, values.last))
                    i += in_a_row - 1;
                else if (!values.add(static_cast<float>(row[i * grid.stride[0]])))
                    return false;
            }
        }
    }
    return true;
}

/// How steadily the samples rise or fall along an axis: the product of the rises in two successive intervals
/// over the mean of their squares, averaged over the grid. It is 1 on even slopes and where nothing changes,
/// and 0 for a mask, where each rise takes a single interval. The weight of a place is the square of both
/// rises together, so that noise hardly counts beside the surfaces of bodies.
template <class T>
double steadiness(const Grid& grid, const T* first, std::size_t axis) {
    VoxelBox all{{}, grid.count};
    all.high[axis] -= 2;
    const std::ptrdiff_t next = grid.stride[axis];
    double products = 0, squares = 0;
    for (int k = 0; k < all.high[2]; ++k) {
        for (int j = 0; j < all.high[1]; ++j) {
            const T* row = first + (k * grid.stride[2] + j * grid.stride[1]);
            for (int i = 0; i < all.high[0]; ++i) {
                const T* sample = row + i * grid.stride[0];
                const double middle = static_cast<double>(sample[next]);
                const double before = middle - static_cast<double>(sample[0]);
                const double after = static_cast<double>(sample[2 * next]) - middle;
                const double weight = (before + after) * (before + after);
                if (!std::isfinite(weight)) continue;
                products += weight * before * after;
                squares += weight * (before * before + after * after) / 2;
            }
        }
    }
    return squares > 0 ? products / squares : 1;
}

/// Whether the samples make steps that are coarser than the finest distance between them.
template <class T>
bool has_coarse_steps(const Grid& grid, const T* first) {
    const double finest = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool apart = grid.spacing[static_cast<int>(axis)] >= far_apart * finest;
        if (apart && steadiness(grid, first, axis) < steady) return true;
    }
    return has_steps(grid, first);
}

std::array<int, 3> block_of(const Grid& grid, bool coarse_steps) {
    const double widest = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    const double width = (coarse_steps ? over_steps : 1) * widest;
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
    if (!grid.has_samples()) return averages;
    averages.coarse_steps =
        grid.with_samples([&](const auto* first) { return has_coarse_steps(grid, first); });
    averages.block = block_of(grid, averages.coarse_steps);
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
