#include "physics/detail/swept.h"

#include <algorithm>
#include <cmath>

namespace thaum::physics::detail {
namespace {

// Depth below a body's surface of the spheres that represent it on a long path, as a share of its smallest
// half extent.
constexpr double skin_share = 0.05;

void add(InnerSpheres& spheres, vec3 centre) {
    if (spheres.count < spheres.centres.size()) spheres.centres[spheres.count++] = centre;
}

/// Represents a box by spheres at the corners, the centres of the faces and the centre.
void fill_box(InnerSpheres& spheres, vec3 half, double radius) {
    const vec3 inner = half - radius;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 sign{(corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1};
        add(spheres, sign * inner);
    }
    for (int axis = 0; axis < 3; ++axis) {
        vec3 face{};
        face[axis] = inner[axis];
        add(spheres, face);
        add(spheres, -face);
    }
    add(spheres, {});
}

/// Represents a capsule by spheres along the axis, at most a radius apart if the array is large enough.
void fill_capsule(InnerSpheres& spheres, double radius, double half_length) {
    const double most = static_cast<double>(spheres.centres.size() - 1);
    const double gaps = std::min(std::ceil(2 * half_length / radius), most);
    for (double i = 0; i <= gaps; ++i) add(spheres, {0, gaps > 0 ? (2 * i / gaps - 1) * half_length : 0, 0});
}

/// Represents a cylinder by spheres at both rims, the centres of the caps and the centre.
void fill_cylinder(InnerSpheres& spheres, double radius, double half_length, double ball) {
    const double y = half_length - ball, r = radius - ball;
    constexpr double diagonal = 0.70710678118654752;
    for (const double side : {-y, y}) {
        for (const double sign : {-r, r}) {
            add(spheres, {sign, side, 0});
            add(spheres, {0, side, sign});
            add(spheres, {sign * diagonal, side, sign * diagonal});
            add(spheres, {sign * diagonal, side, -sign * diagonal});
        }
        add(spheres, {0, side, 0});
    }
    add(spheres, {});
}

}  // namespace

InnerSpheres inner_spheres(const BodyDesc& desc) {
    // Radius of those spheres that are in the corners of a body, as a share of its smallest half extent.
    constexpr double corner_share = 0.25;
    InnerSpheres spheres;
    const vec3 size = desc.size;
    double least = size.x;
    if (desc.shape == Shape::box) least = std::min({size.x, size.y, size.z});
    if (desc.shape == Shape::cylinder) least = std::min(size.x, size.y);
    double ball = least;
    switch (desc.shape) {
        case Shape::box: fill_box(spheres, size, ball = corner_share * least); break;
        case Shape::sphere: add(spheres, {}); break;
        case Shape::capsule: fill_capsule(spheres, size.x, size.y); break;
        case Shape::cylinder: fill_cylinder(spheres, size.x, size.y, ball = corner_share * least); break;
        case Shape::mesh: break;
    }
    spheres.radius = ball - skin_share * least;
    spheres.min_path = least * 0.5;
    spheres.centre_gap = least * 0.25;
    return spheres;
}

}  // namespace thaum::physics::detail
