// A haptic mode that only these tests have: it pulls the hand to the origin, with a strength that depends on
// the field's value.
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "homing",
    .about = "draws the hand home",
    .property = "value of the field",
    .reads = FieldKind::scalar,
    .primitives = 1,
    .passive = false,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const double strength = strength_at(settings.strength, field.scalar(input.proxy).value);
            add_or_rest(set, {PrimitiveKind::point, vec3(0), {}, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
