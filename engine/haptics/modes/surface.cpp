// Mode `surface`: the hand feels a surface at every place of the field. A plane through the proxy resists
// motion towards smaller values, and a line across the plane gives friction (Lundin and others 2007, eq. 14).
// The friction needs the normal force, which is known only after the balance of spring and primitives. So the
// normal force of the last tick is used, at most the surface's strength.
#include <algorithm>

#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

void add_surface(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
                 PrimitiveSet& set) {
    const field::Scalar here = field.scalar(input.proxy);
    Direction up = direction_of(here.gradient);
    double strength = up.length > 0 ? strength_at(settings.strength, here.value) : 0;
    if (strength < 0) {
        up.unit = -up.unit;
        strength = -strength;
    }
    const double pressed = std::clamp(glm::dot(up.unit, input.pull()), 0.0, strength);
    add_or_rest(set, {PrimitiveKind::plane, input.proxy, up.unit, strength});
    const double friction = strength_at(settings.friction, here.value) * pressed;
    add_or_rest(set, {PrimitiveKind::line, input.proxy, up.unit, std::min(friction, primitive_limit)});
}

const ModeRegistration registration({
    .name = "surface",
    .about = "a skin at every depth: free towards larger values, held on the way back, with friction",
    .property = "value of the field",
    .reads = FieldKind::scalar,
    .derivatives = true,
    .primitives = 2,
    .passive = true,
    .add = add_surface,
});

}  // namespace
}  // namespace thaum::haptics
