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
    const bool bytes = volume.samples.visit([](const auto& all) {
        return std::ranges::all_of(all, [](auto stored) {
            const auto sample = static_cast<float>(stored);
            return sample >= 0 && sample <= 255 && sample == std::floor(sample);
        });
    });
    if (!bytes)
        return fail(text("the volume of ", what, " has a sample that is no whole number from 0 to 255"));
    return {};
}

std::uint8_t byte_of(float sample) { return static_cast<std::uint8_t>(sample); }

/// The body of a volume, still without voxels.
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
                .bricks = make_bricks(volume.count),
                .placement = volume.placement};
    body.empty = used.empty;
    body.full = used.full;
    // Computed in double precision, because the sum of two floats may be too large for a float.
    body.surface = static_cast<float>(0.5 * (double{used.empty} + double{used.full}));
    return body;
}

/// Gives a body its voxels, which are white and of material 0.
void fill_voxels(Voxels& body, std::vector<float> density) {
    body.colour.assign(density.size(), Rgb8{255, 255, 255});
    body.material.assign(density.size(), 0);
    body.density = std::move(density);
}

}  // namespace

Expected<Voxels> voxels_of(const Volume& volume, std::optional<DensityRange> range) {
    auto body = body_of(volume, range);
    if (body) fill_voxels(*body, volume.samples.as_floats());
    return body;
}

Expected<Voxels> voxels_of(Volume&& volume, std::optional<DensityRange> range) {
    auto body = body_of(volume, range);
    if (body) fill_voxels(*body, std::move(volume.samples.floats()));
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
    std::vector<std::uint8_t> parts;
    parts.reserve(3 * body.colour.size());
    for (const Rgb8 c : body.colour) parts.insert(parts.end(), {c.r, c.g, c.b});
    volume.samples = std::move(parts);
    return volume;
}

Volume material_volume(const Voxels& body) {
    Volume volume = volume_for(body, "material", 1, SampleType::uint8);
    volume.samples = body.material;
    return volume;
}

Expected<void> set_colours(Voxels& body, const Volume& volume) {
    if (auto good = check_bytes(body, volume, 3, "colours"); !good) return good;
    for (std::size_t i = 0; i < body.colour.size(); ++i) {
        const auto part = [&](std::size_t c) { return byte_of(volume.samples[3 * i + c]); };
        body.colour[i] = {part(0), part(1), part(2)};
    }
    mark_changed(body.bricks, {{}, body.count});
    return {};
}

Expected<void> set_materials(Voxels& body, const Volume& volume) {
    if (auto good = check_bytes(body, volume, 1, "materials"); !good) return good;
    for (std::size_t i = 0; i < body.material.size(); ++i) body.material[i] = byte_of(volume.samples[i]);
    mark_changed(body.bricks, {{}, body.count});
    return {};
}

}  // namespace thaum::field
