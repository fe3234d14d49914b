#include "haptics/surface/detail/scene.h"

#include <algorithm>

#include "haptics/surface/detail/texture.h"

namespace thaum::haptics {
namespace {

/// Adds a flat surface, unless it is a triangle without area.
void add_flat(Scene& scene, std::uint32_t i) {
    const Surface& s = scene.surface(i);
    const vec3 normal = s.kind == SurfaceKind::plane ? s.b : glm::cross(s.b - s.a, s.c - s.a);
    const double length2 = glm::dot(normal, normal);
    if (!(length2 > 0) || !std::isfinite(length2)) return;
    const vec3 unit = normal * (1 / std::sqrt(length2));
    scene.normal[i] = unit;
    scene.flats[scene.flat_count++] = {unit, glm::dot(unit, s.a), scene.gap[i], i, s.kind};
}

Distance from_core(vec3 out, double radius) {
    const double length = glm::length(out);
    return {length - radius, length > 0 ? out / length : vec3(0, 1, 0)};
}

Distance to_box(vec3 p, vec3 half) {
    const vec3 beyond = glm::abs(p) - half;
    const vec3 sign(p.x < 0 ? -1 : 1, p.y < 0 ? -1 : 1, p.z < 0 ? -1 : 1);
    if (beyond.x <= 0 && beyond.y <= 0 && beyond.z <= 0) {
        const int axis = beyond.x >= beyond.y && beyond.x >= beyond.z ? 0 : beyond.y >= beyond.z ? 1 : 2;
        vec3 normal(0);
        normal[axis] = sign[axis];
        return {beyond[axis], normal};
    }
    return from_core(sign * glm::max(beyond, vec3(0)), 0);
}

Distance to_cylinder(vec3 p, double radius, double half) {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const vec3 out = across > 0 ? vec3(p.x / across, 0, p.z / across) : vec3(1, 0, 0);
    const vec3 up(0, p.y < 0 ? -1 : 1, 0);
    const double beside = across - radius, above = std::abs(p.y) - half;
    if (beside <= 0 && above <= 0) return beside >= above ? Distance{beside, out} : Distance{above, up};
    return from_core(std::max(beside, 0.0) * out + std::max(above, 0.0) * up, 0);
}

}  // namespace

BodyMotion motion_of(const SurfaceBody& body, double dt) {
    BodyMotion motion;
    motion.moving = body.velocity != vec3(0) || body.spin != vec3(0);
    if (!motion.moving) return motion;
    motion.pivot = body.position;
    motion.pivot_before = body.position - dt * body.velocity;
    const double speed = glm::length(body.spin);
    motion.turning = speed > 0;
    if (motion.turning) motion.turn = glm::mat3_cast(rotation(body.spin / speed, speed * dt));
    return motion;
}

void set_scene(Scene& scene, const SurfacePatch& patch, double dt) {
    scene.patch = &patch;
    scene.flat_count = scene.solid_count = 0;
    scene.body_count =
        static_cast<std::uint32_t>(std::min<std::size_t>(patch.body_count, surface_body_capacity));
    std::array<double, surface_body_capacity> gaps{};
    for (std::uint32_t i = 0; i < scene.body_count; ++i) {
        scene.motions[i] = motion_of(patch.bodies[i], dt);
        gaps[i] = surface_gap + top_of(patch.bodies[i].material.texture);
    }
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(patch.count, surface_capacity));
    for (std::uint32_t i = 0; i < count; ++i) {
        if (patch.surfaces[i].body >= scene.body_count) continue;
        scene.gap[i] = gaps[patch.surfaces[i].body];
        if (is_flat(patch.surfaces[i].kind)) {
            add_flat(scene, i);
        } else {
            const vec3 size = glm::abs(patch.surfaces[i].b);
            scene.extent[i] = size.x + size.y + size.z + 2 * scene.gap[i];
            scene.solids[scene.solid_count++] = i;
        }
    }
}

Distance to_solid(const Surface& s, quat orientation, vec3 p) {
    const vec3 arm = p - s.a;
    if (s.kind == SurfaceKind::sphere) return from_core(arm, s.b.x);
    const vec3 local = glm::conjugate(orientation) * arm;
    Distance d{};
    if (s.kind == SurfaceKind::box)
        d = to_box(local, s.b);
    else if (s.kind == SurfaceKind::cylinder)
        d = to_cylinder(local, s.b.x, s.b.y);
    else
        d = from_core({local.x, local.y - std::clamp(local.y, -s.b.y, std::max(s.b.y, -s.b.y)), local.z},
                      s.b.x);
    d.normal = orientation * d.normal;
    return d;
}

bool over_triangle(const Surface& s, vec3 normal, vec3 p, double slack) {
    const std::array corners{s.a, s.b, s.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3 from = corners[i], edge = corners[(i + 1) % 3] - from;
        // Distance of p from the edge, towards the inside, times the edge's length.
        const double inward = glm::dot(glm::cross(normal, edge), p - from);
        if (inward < 0 && inward * inward > slack * slack * glm::dot(edge, edge)) return false;
    }
    return true;
}

}  // namespace thaum::haptics
