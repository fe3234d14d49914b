#include "haptics/surface/surface.h"

#include <algorithm>

#include "haptics/surface/detail/feel.h"
#include "haptics/surface/detail/motion.h"
#include "haptics/surface/detail/slide.h"

namespace thaum::haptics {
namespace {

void remember(const Scene& scene, SurfaceState& state, const SlideState& slide, const Shares& shares) {
    const auto& walls = slide.walls;
    state = {.proxy = slide.x, .begun = 1};
    state.contacts = static_cast<std::uint32_t>(std::min<std::size_t>(walls.count, 3));
    for (std::uint32_t i = 0; i < state.contacts; ++i) {
        const std::uint32_t s = walls.items[i].surface;
        state.touched[i] = {scene.body_of(s).key, scene.surface(s).part, shares[i].force};
    }
    state.sliding = state.contacts != 0 && slide.slid ? 1 : 0;
    state.limited = slide.limited ? 1 : 0;
}

}  // namespace

SurfacePatch moved_on(SurfacePatch patch, double seconds) {
    std::array<BodyMotion, surface_body_capacity> motions;
    const auto bodies = std::min<std::size_t>(patch.body_count, surface_body_capacity);
    for (std::size_t i = 0; i < bodies; ++i) {
        SurfaceBody& body = patch.bodies[i];
        const vec3 before = body.position;
        body.position += seconds * body.velocity;
        motions[i] = motion_of(body, seconds);
        motions[i].pivot_before = before;
        body.orientation = motions[i].turning
                               ? glm::normalize(glm::quat_cast(motions[i].turn) * body.orientation)
                               : body.orientation;
    }
    const auto count = std::min<std::size_t>(patch.count, surface_capacity);
    for (std::size_t i = 0; i < count; ++i) {
        Surface& surface = patch.surfaces[i];
        if (surface.body >= bodies || !motions[surface.body].moving) continue;
        const BodyMotion& motion = motions[surface.body];
        surface.a = motion.moved(surface.a);
        if (surface.kind == SurfaceKind::plane)
            surface.b = motion.turning ? motion.turn * surface.b : surface.b;
        if (!is_triangle(surface.kind)) continue;
        surface.b = motion.moved(surface.b);
        surface.c = motion.moved(surface.c);
    }
    return patch;
}

[[gnu::flatten]] ContactResult touch(const SurfacePatch& patch, SurfaceState& state, const SurfaceTip& tip,
                                     double dt) noexcept {
    if (!is_finite(tip.position)) {
        state = {};
        return {.proxy = tip.position};
    }
    if (patch.count == 0) {
        state = {.proxy = tip.position, .begun = 1};
        return {.proxy = tip.position};
    }
    Scene scene;
    set_scene(scene, patch, dt);
    if (state.begun == 0) state.proxy = tip.position;
    const vec3 start = pushed_out(scene, state, carried(scene, state));
    SlideState slide = slide_to(scene, start, tip.position, state.sliding != 0);
    most_loaded_first(slide.walls);
    Shares shares{};
    const vec3 force = force_of(scene, slide, tip, shares);
    if (!is_finite(slide.x) || !is_finite(force)) {
        state = {};
        return {.proxy = tip.position};
    }
    vec3 push(0);
    for (std::size_t i = 0; i < slide.walls.count; ++i)
        push += slide.walls.items[i].depth * slide.walls.items[i].normal;
    remember(scene, state, slide, shares);
    return {force, slide.walls.count == 0 ? tip.position : slide.x, push, state.contacts};
}

}  // namespace thaum::haptics
