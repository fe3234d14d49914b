#include "physics/detail/checks.h"

#include <cmath>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::physics::detail {
namespace {

bool is_finite(const quat& q) {
    return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

void check_material(Key key, const BodyDesc& d) {
    for (const double value : {d.friction, d.restitution, d.rolling_friction}) {
        THAUM_ASSERT(std::isfinite(value) && value >= 0,
                     about(key, "friction or restitution is not a number >= 0"));
    }
    for (const double value : {d.linear_damping, d.angular_damping}) {
        THAUM_ASSERT(value >= 0 && value < 1, about(key, "damping is not in [0, 1)"));
    }
}

}  // namespace

std::string about(Key key, const char* what) { return text("body ", key, ": ", what); }

void check_state(Key key, const BodyState& s) {
    THAUM_ASSERT(thaum::is_finite(s.position), about(key, "position is not finite"));
    THAUM_ASSERT(is_finite(s.orientation), about(key, "orientation is not finite"));
    THAUM_ASSERT(std::abs(glm::dot(s.orientation, s.orientation) - 1) < 1e-6,
                 about(key, "orientation is not a unit quaternion"));
    THAUM_ASSERT(thaum::is_finite(s.velocity), about(key, "velocity is not finite"));
    THAUM_ASSERT(thaum::is_finite(s.spin), about(key, "spin is not finite"));
    THAUM_ASSERT(std::isfinite(s.idle_s), about(key, "idle time is not finite"));
}

void check_desc(Key key, const BodyDesc& d, std::size_t meshes) {
    THAUM_ASSERT(std::isfinite(d.mass) && d.mass >= 0, about(key, "mass is not a number >= 0"));
    check_material(key, d);
    if (d.shape == Shape::mesh) {
        THAUM_ASSERT(d.mass == 0, about(key, "a mesh must be static: set its mass to 0"));
        THAUM_ASSERT(d.mesh < meshes, about(key, "unknown mesh; give it to the constructor of Physics"));
        return;
    }
    THAUM_ASSERT(thaum::is_finite(d.size) && d.size.x > 0, about(key, "size is not positive"));
    if (d.shape == Shape::box || d.shape == Shape::cylinder)
        THAUM_ASSERT(d.size.y > 0, about(key, "a half extent or half length is not positive"));
    if (d.shape == Shape::box)
        THAUM_ASSERT(d.size.z > 0, about(key, "a half extent or half length is not positive"));
    if (d.shape == Shape::capsule) THAUM_ASSERT(d.size.y >= 0, about(key, "half length is negative"));
}

double reach_of(const BodyDesc& d) {
    switch (d.shape) {
        case Shape::box: return glm::length(d.size);
        case Shape::sphere: return d.size.x;
        case Shape::capsule: return d.size.x + d.size.y;
        case Shape::cylinder: return std::sqrt(d.size.x * d.size.x + d.size.y * d.size.y);
        case Shape::mesh: break;
    }
    return HUGE_VAL;
}

}  // namespace thaum::physics::detail
