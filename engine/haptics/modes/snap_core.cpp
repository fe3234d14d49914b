// Mode `snap_core`: the hand snaps to the core of a vortex, by a line along the curl at the nearest place
// where nothing flows across the line.
//
// The place is found by one Newton step in the plane across the curl, from the gradient at the proxy. In a
// core that turns like a solid body the step is exact. Elsewhere it improves as the proxy comes nearer.
#include <algorithm>

#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

/// Vector from the place where the field was read to the axis of the vortex's core (m); not finite if there
/// is no core.
vec3 to_core(const field::Vector& here, vec3 axis) {
    const vec3 a = perpendicular_to(axis), b = glm::cross(axis, a);
    const auto change = [&](vec3 across, vec3 along) {  // derivative along `along` of the component `across`
        return glm::dot(across, vec3(glm::dot(here.gradient[0], along), glm::dot(here.gradient[1], along),
                                     glm::dot(here.gradient[2], along)));
    };
    const double aa = change(a, a), ab = change(a, b), ba = change(b, a), bb = change(b, b);
    const double va = glm::dot(here.value, a), vb = glm::dot(here.value, b);
    const double area = aa * bb - ab * ba;
    return ((ab * vb - bb * va) * a + (ba * va - aa * vb) * b) / area;
}

void add_snap(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
              PrimitiveSet& set) {
    const field::Vector here = field.vector(input.proxy);
    const Direction axis = direction_of(curl(here));
    const vec3 off = axis.length > 0 ? to_core(here, axis.unit) : vec3(0);
    const bool near = axis.length > 0 && is_finite(off) && glm::length(off) <= settings.reach;
    const double strength = near ? std::min(max_pull, strength_at(settings.strength, axis.length)) : 0;
    add_or_rest(set, {PrimitiveKind::line, near ? input.proxy + off : vec3(0), axis.unit, strength});
}

const ModeRegistration registration({
    .name = "snap_core",
    .about = "draws the hand to the axis of a vortex and lets it slide there",
    .property = "length of the curl (1/s)",
    .reads = FieldKind::vector,
    .derivatives = true,
    .primitives = 1,
    .passive = false,
    .add = add_snap,
});

}  // namespace
}  // namespace thaum::haptics
