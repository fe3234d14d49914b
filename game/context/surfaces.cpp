#include "game/context/surfaces.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace thaum::game::inline context {
namespace {

using haptics::SurfaceKind;
using haptics::SurfacePatch;
using physics::Nearby;

SurfaceKind kind_of(physics::Shape shape) {
    switch (shape) {
        case physics::Shape::box: return SurfaceKind::box;
        case physics::Shape::sphere: return SurfaceKind::sphere;
        case physics::Shape::capsule: return SurfaceKind::capsule;
        case physics::Shape::cylinder: return SurfaceKind::cylinder;
        case physics::Shape::mesh: break;
    }
    return SurfaceKind::triangle;
}

/// Angular velocity of resting things as seen from the device frame, which turns with the wizard (rad/s,
/// device frame).
vec3 spin_of(const HandFrame& frame, const HandFrame& before) {
    if (frame.turn == before.turn) return vec3(0);
    quat turned = glm::conjugate(frame.turn) * before.turn;
    if (turned.w < 0) turned = -turned;
    const vec3 axis(turned.x, turned.y, turned.z);
    const double sine = glm::length(axis);
    if (sine == 0) return vec3(0);
    return axis * (2 * det::atan2(sine, turned.w) / (sine * tick_seconds));
}

void add_body(SurfacePatch& patch, const physics::Physics& physics, physics::Key key, const HandFrame& frame,
              const HandFrame& before, vec3 frame_spin, const Feel& feel) {
    const physics::BodyState& state = physics.state(key);
    const double friction = physics.desc(key).friction;
    haptics::SurfaceBody& body = patch.bodies[patch.body_count++];
    body.position = frame.to_device(state.position);
    body.orientation = glm::conjugate(frame.turn) * state.orientation;
    // The velocity below is the mean over the tick, as seen from the device frame, which moves with the
    // wizard. It takes the body from its place in the previous device frame exactly to its place in the
    // present one.
    const vec3 was = before.to_device(state.position - tick_seconds * state.velocity);
    const bool rests = frame == before && state.velocity == vec3(0);
    body.velocity = rests ? vec3(0) : (body.position - was) / tick_seconds;
    body.spin = frame_spin + glm::conjugate(frame.turn) * state.spin;
    body.material = {.stiffness = feel.stiffness,
                     .damping = feel.damping,
                     .static_friction = feel.static_friction * friction,
                     .dynamic_friction = feel.dynamic_friction * friction};
    body.key = key;
}

/// Adds one surface to the patch, the surfaces near the hand. `to_device` turns and scales a vector from the
/// world to the device frame.
void add_surface(SurfacePatch& patch, const Nearby& near, vec3 origin, const mat3& to_device, double scale) {
    haptics::Surface& surface = patch.surfaces[patch.count++];
    surface.kind = kind_of(near.shape);
    surface.body = patch.body_count - 1;
    surface.part = near.part;
    const bool triangle = surface.kind == SurfaceKind::triangle;
    surface.a = to_device * (near.a - origin);
    surface.b = triangle ? to_device * (near.b - origin) : near.b / scale;
    surface.c = triangle ? to_device * (near.c - origin) : vec3(0);
}

}  // namespace

void clear_patch(SurfacePatch& patch) {
    std::fill_n(patch.surfaces.begin(), patch.count, haptics::Surface{});
    std::fill_n(patch.bodies.begin(), patch.body_count, haptics::SurfaceBody{});
    patch.count = patch.body_count = 0;
    patch.centre = vec3(0);
    patch.reach = HUGE_VAL;
}

void fill_patch(SurfacePatch& patch, const physics::Physics& physics, const Around& around,
                const HandFrame& frame, const HandFrame& before, const Feel& feel) {
    std::array<Nearby, haptics::surface_capacity> found{};
    const auto all = physics.nearby(around.point, around.radius, found, around.mask, around.ignore);
    const mat3 to_device = glm::mat3_cast(glm::conjugate(frame.turn)) / frame.metres_per_metre;
    const vec3 frame_spin = spin_of(frame, before);
    double reach = all.reach;
    clear_patch(patch);
    for (std::size_t i = 0; i < all.count; ++i) {
        const Nearby& near = found[i];
        // Surfaces arrive sorted by body key, so those of one body follow one another.
        const bool known = patch.body_count != 0 && patch.bodies[patch.body_count - 1].key == near.key;
        if (!known && patch.body_count == haptics::surface_body_capacity) {
            reach = std::min(reach, near.distance);
            continue;
        }
        if (!known) add_body(patch, physics, near.key, frame, before, frame_spin, feel);
        add_surface(patch, near, frame.origin, to_device, frame.metres_per_metre);
    }
    patch.centre = frame.to_device(around.point);
    patch.reach = reach / frame.metres_per_metre;
}

haptics::FrameMotion frame_motion_of(const HandFrame& frame, const HandFrame& before) {
    if (frame == before) return {};
    return {frame.to_device(before.to_world(vec3(0))) / tick_seconds, spin_of(frame, before)};
}

}  // namespace thaum::game::inline context
