#include "game/scene/baked_light.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline scene {
namespace {

constexpr double corner_reach = 2;  // distance beyond which stone does not darken a point (m)
// Largest share of the sky's light that nearby stone takes away. Less than 1, because a dark corner still
// gets light reflected by other stone.
constexpr double corner_strength = 0.9;
constexpr float lamp_from_wall = 0.35F;  // distance of a lamp from its wall (m)
const fvec3 lamp_glow = fvec3(5.2F, 2.5F, 0.85F);

/// The part of a block within reach of a point.
render::Block near_part(const render::Block& block, vec3 point) {
    return {glm::max(block.low, point - corner_reach), glm::min(block.high, point + corner_reach)};
}

/// Share of the sky that nearby blocks leave open. The shares of two blocks are multiplied, which is exact
/// for blocks at right angles.
double open_sky(const Shade& shade, vec3 point, vec3 normal) {
    // The point is moved off the surface, so that a block that touches the surface counts.
    const vec3 start = point + 0.03 * normal;
    double open = 1;
    for (const auto& block : shade.blocks) {
        const auto near = near_part(block, start);
        if (glm::any(glm::greaterThanEqual(near.low, near.high))) continue;
        open *= 1 - corner_strength * render::form_factor(near, start, normal);
    }
    return open;
}

/// Light of the wall lamps, which falls with the square of the distance.
fvec3 lamp_light(const Shade& shade, vec3 point, fvec3 normal) {
    fvec3 light(0);
    for (const fvec3 lamp : shade.lamps) {
        const fvec3 to = lamp - fvec3(point);
        const float square = glm::dot(to, to);
        if (square > 80) continue;
        const float facing = std::max(0.0F, glm::dot(normal, to) / std::sqrt(square + 0.01F) + 0.15F);
        light += lamp_glow * (facing / (0.7F + square));
    }
    return light;
}

}  // namespace

namespace {

/// Lamps along the four walls, at equal shares of their length.
void add_wall_lamps(const ArenaLook& look, Shade& shade) {
    const fvec2 middle((shade.low + shade.high) / 2.0), half((shade.high - shade.low) / 2.0);
    const auto height = static_cast<float>(look.lamp_height);
    for (const float share : {-0.75F, -0.25F, 0.25F, 0.75F}) {
        for (const float side : {-1.0F, 1.0F}) {
            const fvec2 along = middle + share * half, in = middle + side * (half - lamp_from_wall);
            shade.lamps.push_back({along.x, height, in.y});
            shade.lamps.push_back({in.x, height, along.y});
        }
    }
}

}  // namespace

Shade make_shade(const Arena& arena, const ArenaLook& look) {
    const auto ground = ground_bounds(arena);
    Shade shade{.blocks = {},
                .lamps = {},
                .sun = glm::normalize(fvec3(look.towards_sun)),
                .low = {ground.low.x, ground.low.z},
                .high = {ground.high.x, ground.high.z},
                .wall_top = 0,
                .depth = std::max(0.0, -ground.low.y)};
    for (const auto& thing : arena.things) {
        if (thing.prop || thing.body.shape != physics::Shape::box) continue;
        shade.blocks.push_back({thing.position - thing.body.size, thing.position + thing.body.size});
    }
    for (const auto& block : shade.blocks) shade.wall_top = std::max(shade.wall_top, block.high.y);
    add_wall_lamps(look, shade);
    for (const vec3 lamp : look.lamps) shade.lamps.push_back(fvec3(lamp));
    return shade;
}

bool is_inside(const Shade& shade, vec3 point, double margin) {
    return point.x >= shade.low.x - margin && point.x <= shade.high.x + margin &&
           point.z >= shade.low.y - margin && point.z <= shade.high.y + margin;
}

bool sees_sun(const Shade& shade, vec3 point) {
    return std::none_of(shade.blocks.begin(), shade.blocks.end(), [&](const render::Block& block) {
        return render::meets(block, point, vec3(shade.sun));
    });
}

BakedLight baked_light(const Shade& shade, vec3 point, fvec3 normal) {
    double open = open_sky(shade, point, vec3(normal));
    if (point.y < 0 && shade.depth > 0) open *= 1 - 0.65 * std::min(1.0, -point.y / shade.depth);
    const bool faces_sun = glm::dot(normal, shade.sun) > 0.02F;
    return {static_cast<float>(open) * lamp_light(shade, point, normal), static_cast<float>(open),
            faces_sun && sees_sun(shade, point + 0.06 * vec3(normal))};
}

void bake(const Shade& shade, vec3 position, render::MeshData& mesh) {
    for (auto& v : mesh.vertices) {
        const auto light = baked_light(shade, position + vec3(v.position), v.normal);
        v.lamps = light.lamps;
        v.open = light.open;
        v.sun = light.sunny ? 1.0F : 0.0F;
    }
}

}  // namespace thaum::game::inline scene
