#include "haptics/detail/felt_patch.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

/// Tip that touches the patch, the surfaces near it.
struct TouchingTip {
    vec3 position{}, velocity{};  ///< position and velocity of the tip (m, m/s; device frame)
    bool switched{};              ///< the patch (surfaces near the tip) is a new one, as after a teleport
};

std::size_t bodies_of(const SurfacePatch& patch) {
    return patch.count == 0 ? 0 : std::min<std::size_t>(patch.body_count, surface_body_capacity);
}

bool contains(const SurfacePatch& patch, std::uint32_t key) {
    const auto used = std::min<std::size_t>(patch.body_count, surface_body_capacity);
    return std::any_of(patch.bodies.begin(), patch.bodies.begin() + static_cast<std::ptrdiff_t>(used),
                       [key](const SurfaceBody& body) { return body.key == key; });
}

/// Returns true if a touched body is no longer in the patch (the surfaces near the tip).
bool has_lost_body(const SurfacePatch& patch, const SurfaceState& surface) {
    if (patch.count == 0) return surface.contacts != 0;
    for (std::uint32_t i = 0; i < surface.contacts; ++i)
        if (!contains(patch, surface.touched[i].key)) return true;
    return false;
}

/// Returns true if the game has marked the patch as new by another number, as after a teleport. The proxy
/// (the tip, kept outside of the surfaces) then begins anew at HapticModel::start, a place in free space.
bool detect_patch_jump(ServoState& state, const HapticModel& model) {
    const bool jumped = model.patch_number != state.patch_number;
    state.patch_number = model.patch_number;
    if (jumped) {
        state.surface = {.proxy = model.start, .begun = 1};
        state.contact_offset = {};
    }
    return jumped;
}

/// Whether the patch (the surfaces near the tip) of the last tick had this body, with the same stiffness.
bool knows(const SeenBodies& seen, const SurfaceBody& body) {
    for (std::size_t i = 0; i < seen.count; ++i)
        if (seen.keys[i] == body.key) return seen.stiffness[i] == body.material.stiffness;
    return false;
}

/// Returns true if a touched body is new in the patch or has another stiffness, so that its force may jump.
/// Bodies that are not touched may come and go, because their forces begin at zero.
bool has_new_contact(const SeenBodies& seen, const SurfacePatch& patch, const SurfaceState& surface) {
    for (std::uint32_t i = 0; i < surface.contacts; ++i)
        for (std::size_t b = 0; b < bodies_of(patch); ++b)
            if (patch.bodies[b].key == surface.touched[i].key && !knows(seen, patch.bodies[b])) return true;
    return false;
}

void remember(SeenBodies& seen, const SurfacePatch& patch) {
    seen.count = bodies_of(patch);
    for (std::size_t i = 0; i < seen.count; ++i) {
        seen.keys[i] = patch.bodies[i].key;
        seen.stiffness[i] = patch.bodies[i].material.stiffness;
    }
}

/// Motion of the touched body in the last tick, at `place` (m).
vec3 step_of_touched(const SurfacePatch& patch, const SurfaceState& surface, vec3 place) {
    for (std::uint32_t i = 0; i < std::min<std::size_t>(patch.body_count, surface_body_capacity); ++i) {
        const SurfaceBody& body = patch.bodies[i];
        if (surface.contacts != 0 && body.key == surface.touched[0].key)
            return (body.velocity + glm::cross(body.spin, place - body.position)) * tick_seconds;
    }
    return vec3(0);
}

bool has_active_texture(const SurfacePatch& patch) {
    const auto used = std::min<std::size_t>(patch.body_count, surface_body_capacity);
    return std::any_of(patch.bodies.begin(), patch.bodies.begin() + static_cast<std::ptrdiff_t>(used),
                       [](const SurfaceBody& b) { return b.material.texture.kind == TextureKind::impact; });
}

/// Computes the contact of the patch's surfaces with the tip, which is first moved by the contact offset.
/// This offset exists because a player who walks or turns carries the tip into walls, without any motion of
/// the hand. The offset grows by the depth to which the player's motion and the offset's own decay would
/// press the tip in. So the force grows only by the motion of the hand and of bodies: a player who stands
/// with the wand at a wall feels the same force after turning. In a new patch, the offset takes the whole
/// depth and the force starts at zero.
ContactResult touch_with_offset(ServoState& state, const SurfacePatch& patch, const FrameMotion& drifting,
                                const TouchingTip& probe, double dt) {
    const vec3 fading = state.contact_offset * (tick_seconds / contact_offset_decay);
    state.contact_offset -= fading;
    const vec3 tip = probe.position + state.contact_offset;
    const vec3 drift = drifting.velocity + glm::cross(drifting.spin, tip);
    const vec3 over_drift = probe.velocity + drift;
    const ContactResult touched = touch(patch, state.surface, {tip, over_drift}, dt);
    const double depth = glm::length(touched.push);
    if (depth == 0) return touched;
    const vec3 out = touched.push / depth;
    const double pressed = probe.switched ? depth : std::min(glm::dot(drift * dt + fading, out), depth);
    if (!(pressed > 0)) return touched;
    state.contact_offset += pressed * out;
    if (!is_finite(state.contact_offset)) state.contact_offset = {};
    return touch(patch, state.surface, {tip + pressed * out, over_drift}, 0);
}

SurfaceForces feel_patch(ServoState& state, const SurfacePatch& patch, const FrameMotion& drift,
                         const TouchingTip& probe, double dt) {
    const vec3 offset_before = state.contact_offset;
    const ContactResult touched = touch_with_offset(state, patch, drift, probe, dt);
    if (touched.force == vec3(0)) return {};
    const vec3 stretch = touched.proxy - (probe.position + state.contact_offset);
    return {.force = touched.force,
            .world_step =
                step_of_touched(patch, state.surface, touched.proxy) - (state.contact_offset - offset_before),
            .stored = std::max(0.0, glm::dot(touched.force, stretch) / 2),
            .stretch = glm::length(stretch),
            .active = has_active_texture(patch)};
}

/// Computes the contact with the surfaces in the haptic model. The surfaces move on by their velocity since
/// the model was made, but stand still once the model is too old; the safety stage then soon ends the force.
SurfaceForces feel_bodies(ServoState& state, const HapticModel& model, std::uint32_t age,
                          const TouchingTip& probe) {
    if (model.patch.count == 0) {
        state.contact_offset -= state.contact_offset * (tick_seconds / contact_offset_decay);
        state.surface = {};
        return {};
    }
    if (age == 0) return feel_patch(state, model.patch, model.frame_motion, probe, tick_seconds);
    const bool moves = age <= freshest_ticks;
    const auto patch = moved_on(model.patch, std::min(age, freshest_ticks) * tick_seconds);
    return feel_patch(state, patch, model.frame_motion, probe, moves ? tick_seconds : 0);
}

}  // namespace

SurfaceForces feel_surfaces(ServoState& state, const HapticModel& model, std::uint32_t age, const Tip& tip) {
    const bool lost = has_lost_body(model.patch, state.surface);
    const bool jumped = detect_patch_jump(state, model);
    SurfaceForces felt = feel_bodies(state, model, age, {tip.position, tip.velocity, jumped});
    felt.switched = lost || jumped || has_new_contact(state.seen, model.patch, state.surface);
    remember(state.seen, model.patch);
    return felt;
}

}  // namespace thaum::haptics
