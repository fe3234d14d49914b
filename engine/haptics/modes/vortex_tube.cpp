// Mode `vortex_tube`: leaving the core of a vortex meets resistance, as of a wall round it (Lundin and others
// 2007, eq. 13). The vector (curl V) x V points to the core of a vortex. Eq. 2 puts a minus before it, which
// would push away from the core.
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "vortex_tube",
    .about = "tubes round vortices: free towards the core and along it, held on the way out",
    .property = "length of (curl V) x V",
    .reads = FieldKind::vector,
    .derivatives = true,
    .primitives = 1,
    .passive = true,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const Direction inward = towards_core(field.vector(input.proxy));
            const double strength = inward.length > 0 ? strength_at(settings.strength, inward.length) : 0;
            add_turned(set, {PrimitiveKind::plane, input.proxy, inward.unit, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
