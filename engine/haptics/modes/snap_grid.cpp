// Mode `snap_grid`: the hand snaps to the nearest point of a grid, by a point primitive there (Lundin and
// others 2007, snap-drag). One point of the grid is the origin of the volume; the grid turns and moves with
// the volume. Its pitch (distance between points) is a length at the hand, whatever the volume's scale.
#include <algorithm>
#include <cmath>

#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

vec3 nearest_point(const field::Placement* placement, double pitch, vec3 place) {
    if (placement == nullptr) return pitch * glm::round(place / pitch);
    const vec3 along = (place - placement->origin) * placement->turn;
    return placement->origin + placement->turn * (pitch * glm::round(along / pitch));
}

void add_snap(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
              PrimitiveSet& set) {
    const vec3 nearest = nearest_point(field.placement, settings.pitch, input.proxy);
    const bool near = settings.pitch > 0 && glm::distance(nearest, input.proxy) <= settings.reach;
    const double strength =
        near ? std::min(max_pull, strength_at(settings.strength, field.scalar(nearest).value)) : 0;
    add_or_rest(set, {PrimitiveKind::point, near ? nearest : vec3(0), {}, strength});
}

const ModeRegistration registration({
    .name = "snap_grid",
    .about = "draws the hand to the nearest point of a grid",
    .property = "value of the field at that point",
    .reads = FieldKind::scalar,
    .primitives = 1,
    .passive = false,
    .add = add_snap,
});

}  // namespace
}  // namespace thaum::haptics
