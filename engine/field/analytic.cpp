#include "field/analytic.h"

#include <cmath>

#include "core/random.h"

namespace thaum::field {
namespace {

/// Sine and cosine of each component of a vector.
struct Waves {
    vec3 sine, cosine;
};

Waves waves_of(vec3 x) {
    return {{det::sin(x.x), det::sin(x.y), det::sin(x.z)}, {det::cos(x.x), det::cos(x.y), det::cos(x.z)}};
}

vec3 random_unit(Random& random) {
    for (;;) {
        vec3 v;
        // Draws one component after the other, because compilers evaluate the arguments of a call in
        // different orders.
        for (int axis = 2; axis >= 0; --axis) v[axis] = random.uniform(-1, 1);
        const double square = glm::dot(v, v);
        if (square > 0.01 && square <= 1) return v / std::sqrt(square);
    }
}

void add(Vector& sum, const Vector& one) {
    sum.value += one.value;
    for (std::size_t i = 0; i < 3; ++i) sum.gradient[i] += one.gradient[i];
}

}  // namespace

Scalar Sphere::operator()(vec3 place) const {
    const vec3 off = place - middle;
    const double distance = glm::length(off);
    return {radius - distance, distance > 0 ? off / -distance : vec3(0)};
}

Scalar Plane::operator()(vec3 place) const { return {glm::dot(through - place, normal), -normal}; }

Scalar Gyroid::operator()(vec3 place) const {
    const double k = 2 * pi / period;
    const auto [s, c] = waves_of(k * (place - phase));
    return {s.x * c.y + s.y * c.z + s.z * c.x,
            k * vec3(c.x * c.y - s.z * s.x, c.y * c.z - s.x * s.y, c.z * c.x - s.y * s.z)};
}

Vector RankineVortex::operator()(vec3 place) const {
    const vec3 off = place - middle;
    const vec3 out = off - glm::dot(off, axis) * axis;
    const double square = glm::dot(out, out);
    const bool inside = square <= radius * radius;
    // The velocity is `turn` times (axis x out), where `out` leads from the axis to the place. `fall` is the
    // derivative of `turn` with respect to the squared distance from the axis.
    const double turn = inside ? speed / radius : speed * radius / square;
    const double fall = inside ? 0 : -turn / square;
    const vec3 round = glm::cross(axis, out);
    const std::array<vec3, 3> across{// Rows of the matrix that takes `out` to axis x out.
                                     vec3{0, -axis.z, axis.y},
                                     {axis.z, 0, -axis.x},
                                     {-axis.y, axis.x, 0}};
    Vector result{turn * round, {}};
    for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        result.gradient[row] = turn * across[row] + (2 * fall * round[i]) * out;
    }
    return result;
}

Vector BeltramiFlow::operator()(vec3 place) const {
    const auto [s, c] = waves_of(wave * place);
    const double a = strength.x, b = strength.y, d = strength.z;
    return {{a * s.z + d * c.y, b * s.x + a * c.z, d * s.y + b * c.x},
            {vec3{0, -wave * d * s.y, wave * a * c.z},
             {wave * b * c.x, 0, -wave * a * s.z},
             {-wave * b * s.x, wave * d * c.y, 0}}};
}

Vector FlowWave::operator()(vec3 place) const {
    const double x = glm::dot(wave, place) + phase, slope = -det::sin(x);
    Vector result{det::cos(x) * velocity, {}};
    for (int i = 0; i < 3; ++i) result.gradient[static_cast<std::size_t>(i)] = slope * velocity[i] * wave;
    return result;
}

Vector VortexFlow::operator()(vec3 place) const {
    Vector sum;
    for (const RankineVortex& vortex : vortices) add(sum, vortex(place));
    for (const FlowWave& wave : noise) add(sum, wave(place));
    return sum;
}

VortexFlow make_vortex_flow(double extent, std::uint64_t seed) {
    Random random = random_stream(seed, 0x766f7274);
    VortexFlow flow;
    double speed = 1;
    for (RankineVortex& vortex : flow.vortices) {
        vortex.axis = random_unit(random);
        const vec3 way = random_unit(random);
        vortex.middle = 0.3 * extent * random.uniform() * way;
        vortex.radius = extent * random.uniform(0.08, 0.14);
        vortex.speed = speed * (random.below(2) == 0 ? 1 : -1);
        speed *= random.uniform(0.5, 0.8);
    }
    for (FlowWave& wave : flow.noise) {
        const vec3 direction = random_unit(random);
        wave.wave = 2 * pi * random.uniform(1, 3) / extent * direction;
        wave.velocity = 0.03 * glm::normalize(glm::cross(direction, perpendicular_to(direction) +
                                                                        random.uniform(-1, 1) * direction));
        wave.phase = random.uniform(0, 2 * pi);
    }
    return flow;
}

}  // namespace thaum::field
