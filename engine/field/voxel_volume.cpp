#include "field/voxel_volume.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"

namespace thaum::field {
namespace {

Volume volume_for(const Voxels& body, std::string_view name, int components, SampleType type) {
    Volume volume{.count = body.count, .spacing = body.spacing, .placement = body.placement};
    volume.components = components;
    volume.stored_as = type;
    volume.name = name;
    volume.samples.reserve(body.density.size() * static_cast<std::size_t>(components));
    return volume;
}

DensityRange usual_range(const Volume& volume) {
    const SampleRange range = range_of(volume);
    // If all samples are equal, the density of solid material is 1 larger. For a large number, adding 1 may
    // give the same float, so the next larger float is used.
    const float above = std::max(range.low + 1, std::nextafter(range.low, HUGE_VALF));
    return {range.low, range.high > range.low ? range.high : above};
}

Expected<void> check_bytes(const Voxels& body, const Volume& volume, int components, std::string_view what) {
    const std::size_t samples = body.density.size() * static_cast<std::size_t>(components);
    if (volume.count != body.count || volume.components != components || volume.samples.size() != samples) {
        return fail(text("the volume of ", what, " needs ", body.count[0], " x ", body.count[1], " x ",
                         body.count[2], " samples of ", components, " components, as the body has"));
    }
    for (const float sample : volume.samples) {
        if (!(sample >= 0 && sample <= 255) || sample != std::floor(sample))
            return fail(text("the volume of ", what, " has a sample that is no whole number from 0 to 255"));
    }
    return {};
}

std::uint8_t byte_of(float sample) { return static_cast<std::uint8_t>(sample); }

/// The body of a volume, still without densities.
Expected<Voxels> body_of(const Volume& volume, std::optional<DensityRange> range) {
    if (volume.components != 1)
        return fail("only a volume of one component can be carved; this one holds vectors");
    std::size_t total = 1;
    for (const int n : volume.count) {
        if (n < 1 || static_cast<std::size_t>(n) > max_voxels / total)
            return fail("the volume has too few or too many samples to be carved");
        total *= static_cast<std::size_t>(n);
    }
    const vec3 spacing = volume.spacing;
    if (volume.samples.size() != total || !is_finite(spacing) ||
        !(spacing.x > 0 && spacing.y > 0 && spacing.z > 0))
        return fail("the volume's samples do not fit its count and spacing");
    const DensityRange used = range.value_or(usual_range(volume));
    if (!std::isfinite(used.empty) || !std::isfinite(used.full) || !(used.full > used.empty))
        return fail("the density of solid material must be above that of nothing");
    Voxels body{.count = volume.count,
                .spacing = spacing,
                .colour = std::vector(total, Rgb8{255, 255, 255}),
                .material = std::vector<std::uint8_t>(total),
                .bricks = make_bricks(volume.count),
                .placement = volume.placement};
    body.empty = used.empty;
    body.full = used.full;
    // Computed in double precision, because the sum of two floats may be too large for a float.
    body.surface = static_cast<float>(0.5 * (double{used.empty} + double{used.full}));
    return body;
}

}  // namespace

Expected<Voxels> voxels_of(const Volume& volume, std::optional<DensityRange> range) {
    auto body = body_of(volume, range);
    if (body) body->density = volume.samples;
    return body;
}

Expected<Voxels> voxels_of(Volume&& volume, std::optional<DensityRange> range) {
    auto body = body_of(volume, range);
    if (body) body->density = std::move(volume.samples);
    return body;
}

Volume density_volume(const Voxels& body) {
    Volume volume = volume_for(body, "density", 1, SampleType::float32);
    volume.samples = body.density;
    return volume;
}

Volume colour_volume(const Voxels& body) {
    Volume volume = volume_for(body, "colour", 3, SampleType::uint8);
    volume.is_colour = true;
    for (const Rgb8 c : body.colour) {
        for (const std::uint8_t part : {c.r, c.g, c.b}) volume.samples.push_back(part);
    }
    return volume;
}

Volume material_volume(const Voxels& body) {
    Volume volume = volume_for(body, "material", 1, SampleType::uint8);
    for (const std::uint8_t material : body.material) volume.samples.push_back(material);
    return volume;
}

Expected<void> set_colours(Voxels& body, const Volume& volume) {
    if (auto good = check_bytes(body, volume, 3, "colours"); !good) return good;
    for (std::size_t i = 0; i < body.colour.size(); ++i) {
        const float* sample = &volume.samples[3 * i];
        body.colour[i] = {byte_of(sample[0]), byte_of(sample[1]), byte_of(sample[2])};
    }
    mark_changed(body.bricks, {{}, body.count});
    return {};
}

Expected<void> set_materials(Voxels& body, const Volume& volume) {
    if (auto good = check_bytes(body, volume, 1, "materials"); !good) return good;
    std::ranges::transform(volume.samples, body.material.begin(), byte_of);
    mark_changed(body.bricks, {{}, body.count});
    return {};
}

}  // namespace thaum::field
