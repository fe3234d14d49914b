// Mode `force`: the hand is pushed along the field's vector, as by a wind (Lundin and others 2007, eq. 11).
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "force",
    .about = "pushes the hand along the flow",
    .property = "length of the vector",
    .reads = FieldKind::vector,
    .primitives = 1,
    .passive = false,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const Direction along = direction_of(field.vector(input.proxy).value);
            const double strength = along.length > 0 ? strength_at(settings.strength, along.length) : 0;
            add_turned(set, {PrimitiveKind::directed, {}, along.unit, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
