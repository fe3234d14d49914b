// core/maths.h: vectors and the deterministic elementary functions.
//
// The simulation uses double (vec3, quat); the picture uses float (fvec3, fmat4). World frame: right-handed, +y up;
// a player looks along -z. Units are SI.
//
// glibc picks other variants of sin, exp, ... by processor, so a match must not call them. The functions in
// namespace `det` are made of +, -, *, / and sqrt alone, each of which IEEE 754 rounds in one way only.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace thaum {

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using quat = glm::dquat;
using mat3 = glm::dmat3;
using fvec2 = glm::vec2;
using fvec3 = glm::vec3;
using fvec4 = glm::vec4;
using fquat = glm::quat;
using fmat4 = glm::mat4;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double radians_per_degree = pi / 180.0;

/// The vector, shortened where it is longer than `most`.
inline vec3 limited(vec3 v, double most) {
    const double length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

namespace det {

/// Within 1 ulp (tan: 3) for every finite angle (rad), however large; NaN for what is not finite. core/sin_cos.h gives
/// both at once. Bullet computes with these, too (physics/bullet_maths.h).
double sin(double x);
double cos(double x);
double tan(double x);
/// Within 3 ulp; zeros and infinities as in C.
double atan2(double y, double x);
/// Within 4 ulp; NaN outside [-1, 1].
double asin(double x);
double acos(double x);
/// Within 2 ulp; 0 below -745.2, infinity above 709.78.
double exp(double x);
/// Within 2 ulp of the larger of |log x| and 1; NaN for x < 0, -infinity at 0.
double log(double x);
/// Within 1 ulp (2 among the subnormals); zeros, infinities and NaN as in C. A power that is a double comes out exactly.
double pow(double x, double y);

}  // namespace det

/// Rotation by `angle` rad about a unit axis.
inline quat rotation(vec3 axis, double angle) { return {det::cos(angle / 2), axis * det::sin(angle / 2)}; }

/// Rotation of a player who turned left by `yaw` and looks up by `pitch` (rad); zero looks along -z.
inline quat look_rotation(double yaw, double pitch) {
    return rotation({0, 1, 0}, yaw) * rotation({1, 0, 0}, pitch);
}

inline bool is_finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace thaum
