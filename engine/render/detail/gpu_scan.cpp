#include "render/detail/gpu_scan.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"

namespace thaum::render::detail {
namespace {

constexpr std::size_t entries = 256;

void set_filter(GLenum target, GLint filter) {
    for (const GLenum name : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
        glTexParameteri(target, name, filter);
    for (const GLenum name :
         {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}, GLenum{GL_TEXTURE_WRAP_R}})
        glTexParameteri(target, name, GL_CLAMP_TO_EDGE);
}

Texture made_texture(GLenum target, GLint filter) {
    auto out = make_texture();
    glBindTexture(target, out.get());
    set_filter(target, filter);
    return out;
}

GLenum type_of(std::size_t bytes) { return bytes == 1 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT; }

void allocate(const Scan& scan, GpuScan& gpu) {
    gpu.count = scan.count;
    gpu.bytes = density_bytes(scan);
    gpu.painted = !scan.colours.empty() || !scan.materials.empty();
    const auto [x, y, z] = scan.count;
    glBindTexture(GL_TEXTURE_3D, gpu.density.get());
    glTexImage3D(GL_TEXTURE_3D, 0, gpu.bytes == 1 ? GL_R8 : GL_R16, x, y, z, 0, GL_RED, type_of(gpu.bytes),
                 nullptr);
    glBindTexture(GL_TEXTURE_3D, gpu.paint.get());
    if (gpu.painted)
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, x, y, z, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    else
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const auto bricks = bricks_of(scan.count);
    glBindTexture(GL_TEXTURE_3D, gpu.bricks.get());
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, bricks[0], bricks[1], bricks[2], 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    const auto number = static_cast<std::size_t>(bricks[0]) * static_cast<std::size_t>(bricks[1]) *
                        static_cast<std::size_t>(bricks[2]);
    gpu.ranges.assign(number, {});
    gpu.shown.clear();
    gpu.brick_versions.clear();
}

/// Sends the samples of a box of bricks (cubes of 8^3 samples) to the scan's textures.
void send_box(const Scan& scan, const GpuScan& gpu, const ScanBox& bricks,
              std::vector<std::uint8_t>& scratch) {
    ScanBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.first[axis] = scan_brick * bricks.first[axis];
        box.count[axis] = std::min(scan_brick * bricks.count[axis], scan.count[axis] - box.first[axis]);
    }
    const auto put = [&](const Texture& texture, GLenum format, GLenum type) {
        glBindTexture(GL_TEXTURE_3D, texture.get());
        glTexSubImage3D(GL_TEXTURE_3D, 0, box.first[0], box.first[1], box.first[2], box.count[0],
                        box.count[1], box.count[2], format, type, scratch.data());
    };
    pack_density(scan, box, scratch);
    put(gpu.density, GL_RED, type_of(gpu.bytes));
    if (!gpu.painted) return;
    pack_paint(scan, box, scratch);
    put(gpu.paint, GL_RGBA, GL_UNSIGNED_BYTE);
}

/// Sends new samples to the scan's textures and returns the number of bricks (cubes of 8^3 samples) sent.
std::size_t send_samples(const Scan& scan, GpuScan& gpu, std::vector<std::uint8_t>& scratch) {
    const bool painted = !scan.colours.empty() || !scan.materials.empty();
    const bool fits =
        gpu.filled && gpu.count == scan.count && gpu.bytes == density_bytes(scan) && gpu.painted == painted;
    if (fits && gpu.version == scan.version) return 0;
    if (!fits) allocate(scan, gpu);
    const auto count = bricks_of(scan.count);
    std::size_t sent = 0;
    for (const auto& run : changed_bricks(scan, gpu.brick_versions)) {
        send_box(scan, gpu, run, scratch);
        sent += static_cast<std::size_t>(run.count[0]) * static_cast<std::size_t>(run.count[1]) *
                static_cast<std::size_t>(run.count[2]);
        visit_sharing(run, count, [&](const std::array<int, 3>& brick, std::size_t i) {
            gpu.ranges[i] = density_range(scan, brick);
        });
    }
    gpu.version = scan.version;
    gpu.filled = true;
    return sent;
}

/// Absorption coefficient with which a layer of thickness `unit` (m) has this opacity (1/m). For opacity 1 it
/// would be infinite, so the opacity is limited.
float absorption(float opacity, float unit) {
    constexpr float most = 0.99999F;
    return opacity > 0 ? -std::log(1 - std::min(opacity, most)) / unit : 0.0F;
}

void send_table(const Texture& texture, const std::array<fvec4, entries>& values) {
    glBindTexture(GL_TEXTURE_1D, texture.get());
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA32F, entries, 0, GL_RGBA, GL_FLOAT, &values[0].x);
}

void send_colours(const Scan& scan, GpuScan& gpu) {
    const auto current = hash_combine(hash_colours(scan), hash_value(scan.unit));
    if (gpu.colours == current) return;
    gpu.colours = current;
    std::array<fvec4, entries> values{};
    if (scan.table != nullptr) {
        for (std::size_t i = 0; i < entries; ++i) {
            const auto& entry = (*scan.table)[i];
            values[i] = fvec4(entry.colour, absorption(entry.opacity, scan.unit));
        }
    }
    send_table(gpu.table, values);
    values.fill(fvec4(1));
    for (std::size_t i = 0; i < std::min(entries, scan.material_table.size()); ++i)
        values[i] = fvec4(scan.material_table[i].colour, scan.material_table[i].opacity);
    send_table(gpu.materials, values);
}

/// Finds again which bricks (cubes of 8^3 samples) have a visible density, and sends the result if it has
/// changed.
void send_bricks(const Scan& scan, GpuScan& gpu) {
    std::vector<std::uint8_t> before;
    before.swap(gpu.shown);
    find_shown(scan, gpu.ranges, gpu.shown);
    if (before == gpu.shown) return;
    const auto count = bricks_of(scan.count);
    find_distances(gpu.shown, count, gpu.distances);
    gpu.shows = std::find(gpu.shown.begin(), gpu.shown.end(), 1) != gpu.shown.end();
    glBindTexture(GL_TEXTURE_3D, gpu.bricks.get());
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, count[0], count[1], count[2], GL_RED, GL_UNSIGNED_BYTE,
                    gpu.distances.data());
}

}  // namespace

GpuScan make_gpu_scan() {
    GpuScan gpu;
    glActiveTexture(GL_TEXTURE0);
    gpu.density = made_texture(GL_TEXTURE_3D, GL_LINEAR);
    gpu.paint = made_texture(GL_TEXTURE_3D, GL_LINEAR);
    gpu.bricks = made_texture(GL_TEXTURE_3D, GL_NEAREST);
    gpu.table = made_texture(GL_TEXTURE_1D, GL_LINEAR);
    gpu.materials = made_texture(GL_TEXTURE_1D, GL_NEAREST);
    return gpu;
}

std::uint64_t hash_colours(const Scan& scan) {
    const std::span<const ScanEntry> table =
        scan.table != nullptr ? std::span<const ScanEntry>(*scan.table) : std::span<const ScanEntry>();
    return hash_combine(hash_bytes(std::as_bytes(table)), hash_bytes(std::as_bytes(scan.material_table)));
}

std::size_t send(const Scan& scan, GpuScan& gpu, std::vector<std::uint8_t>& scratch) {
    glActiveTexture(GL_TEXTURE0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto sent = send_samples(scan, gpu, scratch);
    const auto before = gpu.colours;
    send_colours(scan, gpu);
    const auto look = hash_combine(static_cast<std::uint64_t>(scan.look), hash_value(scan.level));
    if (sent > 0 || gpu.look != look || gpu.colours != before) send_bricks(scan, gpu);
    gpu.look = look;
    return sent;
}

}  // namespace thaum::render::detail
