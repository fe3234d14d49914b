#include "game/context/aim.h"

#include <cmath>

namespace thaum::game::inline context {

Aim aim_at(vec3 eye, vec3 target) {
    const vec3 d = target - eye;
    return {det::atan2(-d.x, -d.z), det::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z))};
}

double angle_between(double from, double to) {
    double d = std::fmod(to - from, 2 * pi);
    if (d > pi) d -= 2 * pi;
    if (d < -pi) d += 2 * pi;
    return d;
}

}  // namespace thaum::game::inline context
