// A wall on the surface where the field has one value: a bone in a scan, or an implicit object (haptics/implicit.h).
//
// Up to three planes hold the proxy at the true surface (haptics/level_contact.h). They give way at their strength,
// and a proxy that was pressed in deeper than the reach is through. Friction grows with the depth of the tip (paper
// 004, 3.1): its coefficient is a function of the depth, and it acts on the normal force of the last tick. A magnetic
// surface also holds a proxy that lies in front of it, by a plane that faces inward.
#include <algorithm>

#include "haptics/level_contact.h"
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

void add_friction(const ContactPlane& plane, double strength, const ModeSettings& settings,
                  const ModeInput& input, PrimitiveSet& set) {
    const double pressed = std::clamp(glm::dot(plane.normal, input.pull()), 0.0, strength);
    const double depth = std::max(0.0, glm::dot(plane.place - input.tip, plane.normal));
    const double friction = strength_at(settings.friction, depth) * pressed;
    add_or_rest(set, {PrimitiveKind::line, input.proxy, plane.normal, std::min(friction, primitive_limit)});
}

/// Strength of a plane (N).
double strength_of(const LevelContact& contact, const ContactPlane& plane, const ModeSettings& settings) {
    const double strength = std::max(0.0, strength_at(settings.strength, plane.gradient));
    return contact.behind ? std::min(strength, most_pull) : strength;
}

void add_isosurface(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
                    PrimitiveSet& set) {
    const LevelContact contact =
        find_contact({field.scalar, settings.level, settings.solid_below, settings.reach}, input.proxy,
                     input.tip + input.step);
    for (std::size_t i = 0; i < contact.planes.size(); ++i) {
        const ContactPlane& plane = contact.planes[i];
        const bool used = i < contact.count;
        add_or_rest(set, {PrimitiveKind::plane, plane.place, used ? plane.normal : vec3(1, 0, 0),
                          used ? strength_of(contact, plane, settings) : 0});
    }
    if (contact.count == 0) {
        add_or_rest(set, {.kind = PrimitiveKind::point});
        add_or_rest(set, {.kind = PrimitiveKind::point});
        return;
    }
    const ContactPlane& first = contact.planes[0];
    const double height = glm::dot(input.proxy - first.place, first.normal);
    const double magnet =
        !contact.behind && height <= settings.reach ? std::min(settings.magnet, most_pull) : 0;
    add_or_rest(set, {PrimitiveKind::plane, first.place, -first.normal, magnet});
    add_friction(first, strength_of(contact, first, settings), settings, input, set);
}

const ModeRegistration registration({
    .name = "isosurface",
    .about = "a wall where the field has one value, with friction; a strong push gets through",
    .property = "length of the gradient on the surface (per m)",
    .reads = FieldKind::scalar,
    .slope = true,
    .derivatives = true,
    .primitives = 5,
    .passive = true,
    .add = add_isosurface,
});

}  // namespace
}  // namespace thaum::haptics
