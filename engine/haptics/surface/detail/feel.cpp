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
    const double depth = wall.depth - top;  // depth of the tip beneath the surface (m)
    if (texture.kind == TextureKind::impact) return {depth >= 0 ? depth + relief.height : 0.0, wall.normal};
    const vec3 slope = body.orientation * relief.slope;
    const vec3 way = wall.normal - (slope - glm::dot(slope, wall.normal) * wall.normal);
    const double length = texture.kind == TextureKind::vibration ? glm::length(way) : 1;
    return {std::max(0.0, depth + relief.height), way / length};
}

vec3 force_of(const Scene& scene, const SlideState& slide, const SurfaceTip& tip, Shares& shares) {
    double depth = 0, stiffness = 0, damping = 0;
    vec3 push(0), velocity(0), spring = slide.x - tip.position;
    for (std::size_t i = 0; i < slide.walls.count; ++i) {
        const Wall& wall = slide.walls.items[i];
        const SurfaceBody& body = scene.body_of(wall.surface);
        const TexturedPush here = textured_push(scene, wall, slide.x);
        depth += here.depth;
        stiffness += here.depth * body.material.stiffness;
        damping += here.depth * body.material.damping;
        push += here.depth * here.direction;
        spring += here.depth * here.direction - wall.depth * wall.normal;
        shares[i] = {here.depth * here.direction, here.depth};
        velocity += here.depth * (body.velocity + glm::cross(body.spin, slide.x - body.position));
    }
    const double length = glm::length(push);
    if (!(depth > 0) || !(length > 0)) return vec3(0);
    const vec3 normal = push / length;
    const double inward = std::max(0.0, -glm::dot(tip.velocity - velocity / depth, normal));
    const vec3 force = stiffness / depth * spring + damping / depth * inward * normal;
    for (std::size_t i = 0; i < slide.walls.count; ++i) {
        Share& share = shares[i];
        share.force =
            stiffness / depth * share.force + share.depth / depth * (force - stiffness / depth * push);
    }
    return force;
}

}  // namespace thaum::haptics
