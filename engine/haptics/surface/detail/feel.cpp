#include "haptics/surface/detail/feel.h"

#include <algorithm>

#include "haptics/surface/detail/texture.h"

namespace thaum::haptics {

TexturedPush textured_push(const Scene& scene, const Wall& wall, vec3 x) {
    const SurfaceBody& body = scene.body_of(wall.surface);
    const Texture& texture = body.material.texture;
    const double top = top_of(texture);
    if (top == 0) return {wall.depth, wall.normal};
    const vec3 place = glm::conjugate(body.orientation) * (x - body.position);
    const Relief relief = relief_at(texture, scene.patch->bumps, place);
    const double depth = wall.depth - top;  // beneath the surface
    if (texture.kind == TextureKind::impact) return {depth >= 0 ? depth + relief.height : 0.0, wall.normal};
    const vec3 slope = body.orientation * relief.slope;
    const vec3 way = wall.normal - (slope - glm::dot(slope, wall.normal) * wall.normal);
    const double length = texture.kind == TextureKind::vibration ? glm::length(way) : 1;
    return {std::max(0.0, depth + relief.height), way / length};
}

double friction_reach(const Scene& scene, const Walls& walls, vec3 x, bool sliding) {
    double reach = 0;
    for (std::size_t i = 0; i < walls.count; ++i) {
        const Wall& wall = walls.items[i];
        const SurfaceMaterial& m = scene.body_of(wall.surface).material;
        const double friction = sliding ? m.dynamic_friction : m.static_friction;
        if (!(friction > 0)) continue;
        const bool smooth = top_of(m.texture) == 0;
        reach += friction * (smooth ? wall.depth : textured_push(scene, wall, x).depth);
    }
    return reach;
}

}  // namespace thaum::haptics
