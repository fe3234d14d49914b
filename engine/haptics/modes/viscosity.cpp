// Mode `viscosity`: the space resists motion of the proxy, by a point primitive at the proxy's place of the
// last tick (Lundin and others 2007, eq. 9).
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "viscosity",
    .about = "thick where the field is strong; holds the hand back in every direction",
    .property = "value of the field",
    .reads = FieldKind::scalar,
    .primitives = 1,
    .passive = true,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const double strength = strength_at(settings.strength, field.scalar(input.proxy).value);
            add_or_rest(set, {PrimitiveKind::point, input.proxy, {}, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
