// Mode `gradient`: the hand is pushed towards larger values of the field, or smaller ones if the strength is
// negative (Lundin and others 2007, eq. 10).
#include <cmath>

#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

const ModeRegistration registration({
    .name = "gradient",
    .about = "pushes the hand towards larger values, like a slope",
    .property = "length of the gradient (per m)",
    .reads = FieldKind::scalar,
    .slope = true,
    .derivatives = true,
    .primitives = 1,
    .passive = false,
    .add =
        [](const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
           PrimitiveSet& set) {
            const field::Scalar here = field.scalar(input.proxy);
            const Direction up = direction_of(here.gradient);
            const bool sound = up.length > 0 && std::isfinite(here.value);
            const double strength = sound ? strength_at(settings.strength, up.length) : 0;
            add_turned(set, {PrimitiveKind::directed, {}, up.unit, strength});
        },
});

}  // namespace
}  // namespace thaum::haptics
