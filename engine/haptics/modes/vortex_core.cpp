// Mode `vortex_core`: the hand is pulled towards the core of a vortex, along (curl V) x V (Lundin and others
// 2007, eq. 2 with a positive factor).
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "vortex_core",
    .about = "pulls the hand into the core of a vortex",
    .property = "length of (curl V) x V",
    .reads = FieldKind::vector,
    .derivatives = true,
    .primitives = 1,
    .passive = false,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const Direction inward = towards_core(field.vector(input.proxy));
            const double strength = inward.length > 0 ? strength_at(settings.strength, inward.length) : 0;
            add_turned(set, {PrimitiveKind::directed, {}, inward.unit, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
