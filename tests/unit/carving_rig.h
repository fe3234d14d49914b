// Bodies, tools and comparisons that the tests of carving share.
#pragma once
#include <bit>

#include "core/random.h"
#include "field/carving.h"
#include "field/voxel_state.h"

namespace thaum::field {

inline Extent round_extent(ExtentShape shape, double radius) {
    return {.shape = shape, .half = vec3(radius)};
}

/// A tool with one operation: it moves the density around a place towards a constant, at a rate (1/s).
inline Tool density_filter(double radius, double constant, double rate = 12) {
    return {"filter",
            {{.method = Method::filter,
              .extent = round_extent(ExtentShape::gaussian, radius),
              .changes = {.density = true},
              .rate = rate,
              .density = constant}}};
}

/// A tool that sets the density within an extent to a constant.
inline Tool density_constant(const Extent& extent, double constant) {
    return {"constant", {{.extent = extent, .changes = {.density = true}, .density = constant}}};
}

/// A body of uniform density with cubic voxels.
inline Voxels block(std::array<int, 3> count, float density, double spacing = 0.01) {
    Voxels body = make_voxels(count, vec3(spacing));
    std::ranges::fill(body.density, density);
    return body;
}

/// A body with random densities, colours and materials.
inline Voxels random_block(std::array<int, 3> count, std::uint64_t seed) {
    Voxels body = block(count, 0);
    Random random = random_stream(seed, 7);
    for (float& density : body.density) density = static_cast<float>(random.uniform());
    for (Rgb8& c : body.colour) {
        const std::uint64_t bits = random.next();
        c = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
             static_cast<std::uint8_t>(bits >> 16U)};
    }
    for (auto& material : body.material) material = static_cast<std::uint8_t>(random.below(6));
    return body;
}

/// Place of a voxel, or of a point between voxels (m).
inline vec3 place_of(Voxels& body, vec3 voxel) { return body.view().first_place() + voxel * body.spacing; }

inline std::uint64_t hash_of(Voxels& body) {
    BrickHashes none;
    return voxel_hash(body.view(), none);
}

/// Returns true if any bit of this voxel differs between two bodies.
inline bool differs(const Voxels& a, const Voxels& b, std::size_t voxel) {
    const auto bits = [voxel](const Voxels& body) {
        return std::bit_cast<std::uint32_t>(body.density[voxel]);
    };
    return bits(a) != bits(b) || a.colour[voxel] != b.colour[voxel] || a.material[voxel] != b.material[voxel];
}

/// Sum of the densities, which have no unit, times the volume of a voxel (m^3).
inline double mass_of(Voxels& body) {
    double sum = 0;
    for (const float density : body.density) sum += static_cast<double>(density);
    return sum * body.view().voxel_volume();
}

/// A tool with one to three random operations.
inline Tool random_tool(Random& random) {
    Tool tool{"random", {}};
    for (int property = 0; property < 3; ++property) {
        if (random.below(2) == 0 && property > 0) continue;
        Operation o;
        o.method = property == 2 ? Method::constant : static_cast<Method>(random.below(2));
        o.extent.shape = static_cast<ExtentShape>(random.below(4));
        o.extent.half = {random.uniform(0.3, 6), random.uniform(0.3, 6), random.uniform(0.3, 6)};
        if (o.extent.shape == ExtentShape::sphere || o.extent.shape == ExtentShape::gaussian)
            o.extent.half = vec3(o.extent.half.x);
        o.changes = {property == 0, property == 1, property == 2};
        o.rate = random.uniform(0, 30);
        o.density = random.uniform();
        o.colour = {static_cast<std::uint8_t>(random.below(256)), 0, 255};
        o.material = static_cast<std::uint8_t>(random.below(6));
        tool.operations.push_back(o);
    }
    return tool;
}

/// A dab (one use of a tool) in or near a body of about 25 voxels along each axis.
inline Dab random_dab(Voxels& body, Random& random) {
    const vec3 voxel{random.uniform(-5, 30), random.uniform(-5, 30), random.uniform(-5, 30)};
    const vec3 axis = glm::normalize(vec3{random.uniform(-1, 1), random.uniform(-1, 1), 0.7});
    return {.place = place_of(body, voxel),
            .motion = 0.05 * vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
            .turn = glm::mat3_cast(rotation(axis, random.uniform(0, 6))),
            .seconds = random.uniform(0, 0.1),
            .seed = random.next()};
}

}  // namespace thaum::field
