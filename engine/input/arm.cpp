#include "input/arm.h"

#include <algorithm>
#include <cmath>

namespace thaum::input {

std::int32_t quantised(double value) {
    constexpr double most = 1e9;
    return static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most)));
}

vec3 rotation_vector(const mat3& rotation) {
    constexpr double no_turn = 1e-9;
    auto q = glm::quat_cast(rotation);
    if (q.w < 0) q = -q;
    const vec3 axis(q.x, q.y, q.z);
    const double sine = glm::length(axis);  // of half the angle
    return sine < no_turn ? 2.0 * axis : axis * (2 * det::atan2(sine, q.w) / sine);
}

}  // namespace thaum::input
