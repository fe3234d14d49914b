// Mode `isosurface`: a wall on the surface where the field has one value, such as a bone in a scan or an
// implicit object (haptics/volume/implicit.h).
//
// A plane holds the proxy at the surface (haptics/volume/level_contact.h); in a field of samples, at the
// surface that the picture shows. The plane gives way to a force above its strength, and a proxy that was
// pressed in deeper than ModeSettings::reach has got through. Friction grows with the depth of the tip
// (paper 004, on a haptic jacket, section 3.1): its coefficient is a function of the depth, times the normal
// force of the last tick. A magnetic surface also holds a proxy that lies in front of it, by a plane that
// faces inward. The strength of that plane depends on the height of the tip above the surface. It does not
// depend on the height of the proxy: a proxy that is let go moves away, so its height would end the force in
// one tick.
#include <algorithm>

#include "haptics/modes.h"
#include "haptics/volume/level_contact.h"

namespace thaum::haptics {
namespace {

/// Width of the layer, at the largest distance at which a magnetic surface still pulls, in which its pull
/// fades to zero (m).
constexpr double magnet_fade = 1e-4;

/// Largest friction on the plane that holds the proxy (N).
double friction_on(const ContactPlane& plane, double strength, const ModeSettings& settings,
                   const ModeInput& input) {
    const double pressed = pressing_force(plane, input.next_tip(), input.pull(), strength);
    const double depth = std::max(0.0, glm::dot(plane.place - input.tip, plane.normal));
    return std::clamp(strength_at(settings.friction, depth) * pressed, 0.0, primitive_limit);
}

/// Force up to which the plane at the surface holds the proxy (N).
double strength_of(const LevelContact& contact, const ModeSettings& settings) {
    const double strength = std::max(0.0, strength_at(settings.strength, contact.planes[0].gradient));
    return contact.behind ? std::min(strength, max_pull) : strength;
}

/// Strength with which a magnetic surface holds the proxy (N). It fades to zero at the largest distance at
/// which the surface acts (ModeSettings::reach).
double magnet_of(const LevelContact& contact, const ModeSettings& settings, const ModeInput& input) {
    if (contact.behind) return 0;
    const ContactPlane& first = contact.planes[0];
    const double height = glm::dot(input.next_tip() - first.place, first.normal);
    const double share = (settings.reach - height) / std::min(magnet_fade, settings.reach);
    return std::min(settings.magnet, max_pull) * std::clamp(share, 0.0, 1.0);
}

void add_isosurface(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
                    PrimitiveSet& set) {
    const LevelSurface surface{.field = field.scalar,
                               .level = settings.level,
                               .solid_below = settings.solid_below,
                               .reach = settings.reach,
                               .motion = input.motion};
    const LevelContact contact =
        find_contact(surface, input.proxy, input.next_tip(), input.stiffness,
                     [&](const LevelContact& found) { return strength_of(found, settings); });
    if (contact.count == 0) {
        for (int i = 0; i < 3; ++i) add_or_rest(set, {.kind = PrimitiveKind::point});
        return;
    }
    const ContactPlane& first = contact.planes[0];
    const double strength = strength_of(contact, settings);
    const ContactPlane held =
        holding_plane(contact, held_back(input, first.normal, friction_on(first, strength, settings, input)));
    add_or_rest(set, {PrimitiveKind::plane, held.place, held.normal, strength});
    add_or_rest(set, {PrimitiveKind::plane, first.place, -first.normal, magnet_of(contact, settings, input)});
    add_or_rest(
        set, {PrimitiveKind::line, input.proxy, held.normal, friction_on(held, strength, settings, input)});
}

const ModeRegistration registration({
    .name = "isosurface",
    .about = "a wall where the field has one value, with friction; a strong push gets through",
    .property = "length of the gradient on the surface (per m)",
    .reads = FieldKind::scalar,
    .slope = true,
    .derivatives = true,
    .primitives = 3,
    .passive = true,
    .ends_at_box = true,
    .add = add_isosurface,
});

}  // namespace
}  // namespace thaum::haptics
