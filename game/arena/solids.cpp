#include "game/arena/solids.h"

namespace thaum::game::inline arena {
namespace {

constexpr std::size_t bowl_sides = 32;

void quad(physics::TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// A wedge that rises along x.
physics::TriangleMesh ramp_along_x(vec3 size, bool rises_east) {
    const vec3 h = size * 0.5;
    const double high = rises_east ? h.x : -h.x;
    physics::TriangleMesh mesh;
    // Vertices 0 to 3 are the base, counter-clockwise from above, starting at the low edge. 4 and 5 are the
    // high edge.
    mesh.vertices = {{-high, -h.y, -h.z}, {-high, -h.y, h.z}, {high, -h.y, h.z},
                     {high, -h.y, -h.z},  {high, h.y, h.z},   {high, h.y, -h.z}};
    quad(mesh, 0, 3, 2, 1);  // base of the ramp, whose front side faces down
    quad(mesh, 0, 1, 4, 5);  // slope of the ramp
    quad(mesh, 3, 5, 4, 2);  // upright back of the ramp
    mesh.triangles.push_back({1, 2, 4});
    mesh.triangles.push_back({0, 5, 3});
    if (!rises_east) {  // mirroring along x has turned counter-clockwise triangles clockwise
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    }
    return mesh;
}

}  // namespace

physics::TriangleMesh ramp(vec3 size, Rise rise) {
    if (rise == Rise::east || rise == Rise::west) return ramp_along_x(size, rise == Rise::east);
    // A ramp along z is a ramp along x after a quarter turn about y, which takes east to north and west to
    // south.
    auto mesh = ramp_along_x({size.z, size.y, size.x}, rise == Rise::north);
    for (auto& v : mesh.vertices) v = {v.z, v.y, -v.x};
    return mesh;
}

std::vector<vec2> bowl_profile(const BowlSize& size) {
    const double r = size.radius;
    const double h = size.height;
    const double t = size.thickness;
    const double bottom = -h / 2;
    return {{0, bottom},
            {0.55 * r, bottom},
            {0.62 * r, bottom + 0.08 * h},
            {0.9 * r, bottom + 0.3 * h},
            {r, bottom + 0.6 * h},
            {0.94 * r, bottom + 0.9 * h},
            {r, h / 2},
            {r - t, h / 2},
            {0.94 * r - t, bottom + 0.9 * h},
            {r - t, bottom + 0.6 * h},
            {0.9 * r - t, bottom + 0.3 * h + 0.5 * t},
            {0.5 * r, bottom + 0.08 * h + t},
            {0, bottom + 0.05 * h + t}};
}

physics::TriangleMesh bowl(const BowlSize& size) {
    const auto profile = bowl_profile(size);
    physics::TriangleMesh mesh;
    // A point of the profile (the outline that is turned about the axis) becomes one vertex if it lies on the
    // axis, otherwise a ring of vertices.
    std::vector<std::uint32_t> first;
    for (const auto& p : profile) {
        first.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        const std::size_t n = p.x == 0 ? 1 : bowl_sides;
        for (std::size_t s = 0; s < n; ++s) {
            const double angle = 2 * pi * static_cast<double>(s) / static_cast<double>(bowl_sides);
            mesh.vertices.push_back({p.x * det::cos(angle), p.y, p.x * det::sin(angle)});
        }
    }
    const auto at = [&](std::size_t ring, std::size_t side) {
        return profile[ring].x == 0 ? first[ring]
                                    : first[ring] + static_cast<std::uint32_t>(side % bowl_sides);
    };
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::size_t s = 0; s < bowl_sides; ++s) {
            const auto a = at(ring, s), b = at(ring, s + 1), c = at(ring + 1, s + 1), d = at(ring + 1, s);
            if (a != b) mesh.triangles.push_back({a, d, b});
            if (c != d) mesh.triangles.push_back({b, d, c});
        }
    }
    return mesh;
}

}  // namespace thaum::game::inline arena
