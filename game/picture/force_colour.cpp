#include "game/picture/force_colour.h"

#include <algorithm>

namespace thaum::game::inline picture {

fvec3 force_colour(double share) {
    const fvec3 green(0.25F, 0.85F, 0.35F), yellow(0.95F, 0.85F, 0.25F), crimson(1.0F, 0.29F, 0.23F);
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    return s < 0.5F ? glm::mix(green, yellow, 2 * s) : glm::mix(yellow, crimson, 2 * s - 1);
}

}  // namespace thaum::game::inline picture
