#include "render/detail/scan_bricks.h"

#include <algorithm>
#include <cmath>

#include "render/detail/batches.h"

namespace thaum::render::detail {
namespace {

constexpr float full = 65535;
constexpr int max_samples = 2048;  // largest number of samples along an axis; OpenGL may allow fewer

std::size_t number(const std::array<int, 3>& count) {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
}

std::size_t index_of(const Scan& scan, int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(scan.count[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(scan.count[0]) +
           static_cast<std::size_t>(x);
}

/// Converts samples to 16-bit densities; 65,535 stands for 1.
struct ToDensity {
    float low, factor;
    explicit ToDensity(const Scan& scan) : low(scan.low), factor(full / (scan.high - scan.low)) {}

    template <class Sample>
    std::uint16_t operator()(Sample sample) const {
        const float at = (static_cast<float>(sample) - low) * factor + 0.5F;
        // A NaN fails this form of the test and gives 0.
        return at > 0 ? static_cast<std::uint16_t>(std::min(at, full)) : std::uint16_t{0};
    }
};

template <class Visit>
void visit_rows(const ScanBox& box, Visit visit) {
    for (int z = box.first[2]; z < box.first[2] + box.count[2]; ++z) {
        for (int y = box.first[1]; y < box.first[1] + box.count[1]; ++y) visit(y, z);
    }
}

std::uint8_t nearest_on_line(const std::vector<std::uint8_t>& line, std::size_t k) {
    std::size_t best = line[k];
    for (std::size_t away = 1; away < best; ++away) {
        if (away > k && k + away >= line.size()) break;
        if (away <= k) best = std::min(best, std::max<std::size_t>(away, line[k - away]));
        if (k + away < line.size()) best = std::min(best, std::max<std::size_t>(away, line[k + away]));
    }
    return static_cast<std::uint8_t>(best);
}

bool is_placed(const Scan& scan) {
    if (!finite(scan.model)) return false;
    const float turned = glm::determinant(glm::mat3(scan.model));
    return std::isfinite(turned) && turned != 0 && finite(glm::inverse(scan.model));
}

bool has_look(const Scan& scan) {
    if (scan.look == ScanLook::surface) return std::isfinite(scan.level);
    return scan.table != nullptr && scan.unit > 0 && std::isfinite(scan.unit) && scan.step > 0 &&
           std::isfinite(scan.step);
}

}  // namespace

bool drawable(const Scan& scan) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float spacing = scan.spacing[static_cast<int>(axis)];
        if (scan.count[axis] < 2 || scan.count[axis] > max_samples) return false;
        if (!(spacing > 0) || !std::isfinite(spacing)) return false;
    }
    const auto samples = number(scan.count);
    const auto fits = [&](std::size_t size) { return size == 0 || size == samples; };
    const auto size = std::visit([](const auto& all) { return all.size(); }, scan.samples);
    const float range = scan.high - scan.low;
    return size == samples && fits(scan.colours.size()) && fits(scan.materials.size()) &&
           std::isfinite(range) && range > 0 && std::isfinite(full / range) && is_placed(scan) &&
           has_look(scan);
}

std::size_t density_bytes(const Scan& scan) {
    const bool bytes = std::holds_alternative<std::span<const std::uint8_t>>(scan.samples);
    return bytes && scan.low == 0 && scan.high == 255 ? 1 : 2;
}

void pack_density(const Scan& scan, const ScanBox& box, std::vector<std::uint8_t>& out) {
    out.clear();
    const bool as_bytes = density_bytes(scan) == 1;
    out.reserve(number(box.count) * density_bytes(scan));
    const ToDensity to_density(scan);
    const auto width = static_cast<std::size_t>(box.count[0]);
    std::visit(
        [&]<class Sample>(std::span<const Sample> all) {
            visit_rows(box, [&](int y, int z) {
                for (const auto sample : all.subspan(index_of(scan, box.first[0], y, z), width)) {
                    if (sizeof(Sample) == 1 && as_bytes) {
                        out.push_back(static_cast<std::uint8_t>(sample));
                    } else {
                        const auto density = to_density(sample);
                        const auto* bytes = reinterpret_cast<const std::uint8_t*>(&density);
                        out.insert(out.end(), bytes, bytes + 2);
                    }
                }
            });
        },
        scan.samples);
}

void pack_paint(const Scan& scan, const ScanBox& box, std::vector<std::uint8_t>& out) {
    out.clear();
    out.reserve(4 * number(box.count));
    visit_rows(box, [&](int y, int z) {
        for (int x = box.first[0]; x < box.first[0] + box.count[0]; ++x) {
            const auto i = index_of(scan, x, y, z);
            const auto colour = scan.colours.empty() ? field::Rgb8{255, 255, 255} : scan.colours[i];
            const std::uint8_t material = scan.materials.empty() ? std::uint8_t{0} : scan.materials[i];
            out.insert(out.end(), {colour.r, colour.g, colour.b, material});
        }
    });
}

DensityRange density_range(const Scan& scan, const std::array<int, 3>& brick) {
    ScanBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.first[axis] = scan_brick * brick[axis];
        box.count[axis] = std::min(scan_brick + 1, scan.count[axis] - box.first[axis]);
    }
    const ToDensity to_density(scan);
    DensityRange range{0xFFFF, 0};
    std::visit(
        [&](const auto& all) {
            visit_rows(box, [&](int y, int z) {
                const auto first = index_of(scan, box.first[0], y, z);
                for (const auto sample : all.subspan(first, static_cast<std::size_t>(box.count[0]))) {
                    const auto density = to_density(sample);
                    range.low = std::min(range.low, density);
                    range.high = std::max(range.high, density);
                }
            });
        },
        scan.samples);
    return range;
}

std::vector<ScanBox> changed_bricks(const Scan& scan, std::vector<std::uint32_t>& sent) {
    const auto count = bricks_of(scan.count);
    const auto& current = scan.brick_versions;
    if (current.size() != number(count) || sent.size() != current.size()) {
        sent.assign(current.begin(), current.end());
        return {{{0, 0, 0}, count}};
    }
    std::vector<ScanBox> runs;
    for (std::size_t i = 0; i < current.size(); ++i) {
        if (current[i] == sent[i]) continue;
        sent[i] = current[i];
        const auto nx = static_cast<std::size_t>(count[0]), ny = static_cast<std::size_t>(count[1]);
        const std::array at{static_cast<int>(i % nx), static_cast<int>(i / nx % ny),
                            static_cast<int>(i / nx / ny)};
        const bool follows = !runs.empty() && runs.back().first[2] == at[2] &&
                             runs.back().first[1] == at[1] &&
                             runs.back().first[0] + runs.back().count[0] == at[0];
        if (follows)
            ++runs.back().count[0];
        else
            runs.push_back({at, {1, 1, 1}});
    }
    return runs;
}

void find_shown(const Scan& scan, const std::vector<DensityRange>& ranges, std::vector<std::uint8_t>& shown) {
    shown.resize(ranges.size());
    if (scan.look == ScanLook::surface) {
        const float level = full * scan.level;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            // A brick that is dense everywhere counts as visible too, because a face of the scan may cut it.
            shown[i] = static_cast<float>(ranges[i].high) >= level ? 1 : 0;
        }
        return;
    }
    // For each entry of the table of opacities by density, the number of entries before it that have an
    // opacity above 0.
    std::array<int, 257> before{};
    for (std::size_t i = 0; i < 256; ++i) before[i + 1] = before[i] + ((*scan.table)[i].opacity > 0 ? 1 : 0);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const std::size_t low = ranges[i].low / 257U, high = (ranges[i].high + 256U) / 257U;
        shown[i] = before[high + 1] > before[low] ? 1 : 0;
    }
}

void find_distances(const std::vector<std::uint8_t>& shown, const std::array<int, 3>& count,
                    std::vector<std::uint8_t>& distance) {
    distance.resize(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) distance[i] = shown[i] != 0 ? 0 : 255;
    // The axes are treated one after another. Along a line, a brick gets the minimum, over all bricks of the
    // line, of max(distance along the line, distance that the other brick has so far).
    std::vector<std::uint8_t> line;
    std::size_t stride = 1;
    for (const int length : count) {
        const auto n = static_cast<std::size_t>(length);
        line.resize(n);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (i / stride % n != 0) continue;  // this brick is not the first one of a line
            for (std::size_t k = 0; k < n; ++k) line[k] = distance[i + k * stride];
            for (std::size_t k = 0; k < n; ++k) distance[i + k * stride] = nearest_on_line(line, k);
        }
        stride *= n;
    }
}

}  // namespace thaum::render::detail
