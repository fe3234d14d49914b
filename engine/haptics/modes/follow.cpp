// Mode `follow`: the hand slides along the field's vector and meets resistance across it, by a line through
// the proxy (Lundin and others 2007, eq. 12).
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "follow",
    .about = "free along the flow, held across it, like a bead on a wire",
    .property = "length of the vector",
    .reads = FieldKind::vector,
    .primitives = 1,
    .passive = true,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const Direction along = direction_of(field.vector(input.proxy).value);
            const double strength = along.length > 0 ? strength_at(settings.strength, along.length) : 0;
            add_or_rest(set, {PrimitiveKind::line, input.proxy, along.unit, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
