#include "physics/detail/gather.h"

#include <algorithm>

namespace thaum::physics::detail {

void add(NearestSurfaces& gathering, const Nearby& surface) {
    auto& [into, found] = gathering;
    if (found.count < into.size()) {
        into[found.count++] = surface;
        return;
    }
    const auto farthest = std::ranges::max_element(into, {}, &Nearby::distance);
    if (farthest == into.end() || farthest->distance <= surface.distance) {
        found.reach = std::min(found.reach, surface.distance);
        return;
    }
    found.reach = std::min(found.reach, farthest->distance);
    // Replaces the farthest surface. The order of the others is preserved.
    std::move(std::next(farthest), into.end(), farthest);
    into.back() = surface;
}

}  // namespace thaum::physics::detail
