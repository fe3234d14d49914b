// core/maths.h: vectors, and elementary functions with the same bits on every processor.
//
// The simulation uses double (vec3, quat); the picture uses float (fvec3, fmat4). The world frame is
// right-handed with +y up; a player looks along -z. Units are SI.
//
// glibc selects its sin, exp and so on by processor, so a match must not call them. The functions in
// namespace `det` use only +, -, *, / and sqrt, which IEEE 754 rounds in exactly one way.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace thaum {

/// @{
/// Vectors, rotations and matrices: of doubles for the simulation, and (f...) of floats for pictures.
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using quat = glm::dquat;
using mat3 = glm::dmat3;
using fvec2 = glm::vec2;
using fvec3 = glm::vec3;
using fvec4 = glm::vec4;
using fquat = glm::quat;
using fmat4 = glm::mat4;
/// @}

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double radians_per_degree = pi / 180.0;

/// Returns `v`, shortened to the length `most` if it is longer.
inline vec3 limited(vec3 v, double most) {
    const double length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

namespace det {

/// @{
/// Sine, cosine and tangent (rad). The error is within 1 ulp (tan: 3) for every finite angle, however large.
/// The result is NaN if x is not finite. core/sin_cos.h computes sine and cosine together. The physics
/// library Bullet uses these functions, too (physics/bullet_maths.h).
double sin(double x);
double cos(double x);
double tan(double x);
/// Angle of the point (x, y) (rad). The error is within 3 ulp. Zeros and infinities give the same results as
/// in C.
double atan2(double y, double x);
/// Arc sine and arc cosine (rad). The error is within 4 ulp. The result is NaN outside [-1, 1].
double asin(double x);
double acos(double x);
/// Exponential function. The error is within 2 ulp. The result is 0 below -745.2 and infinity above 709.78.
double exp(double x);
/// Natural logarithm. The error is within 2 ulp of the larger of |log x| and 1. The result is NaN for x < 0
/// and -infinity at 0.
double log(double x);
/// The power x^y. The error is within 1 ulp (2 for subnormal results). Zeros, infinities and NaN give the
/// same results as in C. A power that is representable as a double is exact.
double pow(double x, double y);

}  // namespace det

/// Rotation by `angle` (rad) about a unit axis.
inline quat rotation(vec3 axis, double angle) { return {det::cos(angle / 2), axis * det::sin(angle / 2)}; }

/// Rotation of a wizard that turned left by `yaw` and looks up by `pitch` (rad). With both 0 the wizard looks
/// along -z.
inline quat look_rotation(double yaw, double pitch) {
    return rotation({0, 1, 0}, yaw) * rotation({1, 0, 0}, pitch);
}

/// A unit vector at a right angle to a unit vector.
inline vec3 perpendicular_to(vec3 unit) {
    return glm::normalize(glm::cross(unit, std::abs(unit.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
}

/// Whether all three coordinates are finite.
inline bool is_finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace thaum
