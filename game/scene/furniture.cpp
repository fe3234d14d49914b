#include "game/scene/furniture.h"

#include <array>
#include <cmath>

#include "game/data/teams.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

using physics::Shape;
using render::append;
using render::colour;
using render::MeshData;
using render::rotated;
using render::translated;

constexpr float quarter = 1.5707963F;
constexpr float whole = 6.2831853F;
const fvec3 iron = colour(0x4A4650), plank = colour(0xA87444), dark_plank = colour(0x7A5030);

float part(double v) { return static_cast<float>(v); }

/// A body's shape in one colour, with a soft bevel.
MeshData plain(const ShapeKey& key, fvec3 paint) {
    const fvec3 size(key.size);
    const float least = std::min({size.x, size.y, size.z});
    switch (key.shape) {
        case Shape::box: return render::box(size, paint, std::min(0.06F, 0.3F * least));
        case Shape::cylinder: return render::cylinder(size.x, 2 * size.y, 16, paint);
        case Shape::capsule: return render::capsule(size.x, 2 * size.y, 12, paint);
        default: return render::sphere(std::max(size.x, 0.05F), 14, paint);
    }
}

/// Boards with a frame around each face.
MeshData crate(fvec3 half) {
    MeshData mesh = render::box(0.94F * half, dark_plank);
    const float thick = 0.06F * std::min({half.x, half.y, half.z}) + 0.01F;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        // The four edges parallel to this axis.
        for (const float a : {-1.0F, 1.0F}) {
            for (const float b : {-1.0F, 1.0F}) {
                fvec3 size(0), at(0);
                size[axis] = half[axis];
                size[u] = size[v] = 0.13F * half[u];
                at[u] = a * (half[u] - size[u]);
                at[v] = b * (half[v] - size[v]);
                append(mesh, render::box(size, plank, 0.25F * size[u]), translated(at));
            }
        }
        // Two boards on both faces perpendicular to this axis.
        for (const float side : {-1.0F, 1.0F}) {
            for (const float row : {-0.38F, 0.38F}) {
                fvec3 size(0), at(0);
                size[axis] = thick;
                size[u] = 0.8F * half[u];
                size[v] = 0.34F * half[v];
                at[axis] = side * (0.95F * half[axis] - thick / 2);
                at[v] = row * half[v];
                append(mesh, render::box(size, row < 0 ? plank * 0.85F : plank), translated(at));
            }
        }
    }
    return mesh;
}

MeshData barrel(float radius, float half_height) {
    const std::array<fvec2, 7> outline{fvec2(0, -half_height),
                                       {0.82F * radius, -half_height},
                                       {0.95F * radius, -0.5F * half_height},
                                       {radius, 0},
                                       {0.95F * radius, 0.5F * half_height},
                                       {0.82F * radius, half_height},
                                       {0, half_height}};
    auto mesh = render::flat_shaded(render::revolve(outline, 14, plank));
    for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3) {
        const auto& p =
            mesh.vertices[i].position + mesh.vertices[i + 1].position + mesh.vertices[i + 2].position;
        const int stave = static_cast<int>(std::floor((std::atan2(p.z, p.x) / whole + 1) * 14));
        for (std::size_t k = 0; k < 3; ++k)
            mesh.vertices[i + k].colour = stave % 2 == 0 ? colour(0x9A6038) : colour(0x7E4A2A);
    }
    const float thick = 0.07F * half_height;
    for (const float at : {-0.72F, -0.3F, 0.3F, 0.72F}) {
        const float r = radius * (1.03F - 0.2F * at * at);
        // The rings have no top or bottom, since wood fills them.
        append(mesh, render::revolve(std::array{fvec2(r, -thick), fvec2(r, thick)}, 14, iron),
               translated({0, at * half_height, 0}));
    }
    return mesh;
}

/// Planks along the longer side, held together by battens.
MeshData table(fvec3 half) {
    const bool along_x = half.x > half.z;
    const float wide = along_x ? half.z : half.x, length = along_x ? half.x : half.z;
    constexpr int boards = 4;
    MeshData mesh;
    const auto put = [&](fvec3 size, fvec3 at, fvec3 paint, float bevel) {
        if (!along_x) std::swap(size.x, size.z), std::swap(at.x, at.z);
        append(mesh, render::box(size, paint, bevel), translated(at));
    };
    for (int i = 0; i < boards; ++i) {
        const float step = 2 * wide / boards;
        const float at = -wide + (static_cast<float>(i) + 0.5F) * step;
        const fvec3 paint = i % 2 == 0 ? colour(0xB07A46) : colour(0x96643A);
        put({length, 0.7F * half.y, 0.48F * step}, {0, 0.3F * half.y, at}, paint, 0.015F);
    }
    for (const float at : {-0.8F, 0.0F, 0.8F})
        put({0.12F, 0.35F * half.y, 0.95F * wide}, {at * length, -0.65F * half.y, 0}, dark_plank, 0.01F);
    return mesh;
}

MeshData boulder(fvec3 half) {
    MeshData mesh = render::box(half, colour(0x86818F), 0.16F * std::min({half.x, half.y, half.z}));
    // A band of carved signs makes rotation visible.
    append(mesh, render::box({1.005F * half.x, 0.1F * half.y, 1.005F * half.z}, colour(0x5C5868)));
    return mesh;
}

MeshData ball(float radius) {
    MeshData mesh = render::sphere(radius, 14, colour(0xC8A060));
    append(mesh, render::cylinder(1.01F * radius, 0.22F * radius, 14, colour(0x7A3A3A)));
    return mesh;
}

MeshData plinth(float radius, float half_height) {
    const float r = radius, h = half_height;
    const std::array<fvec2, 9> outline{fvec2(0, -h),
                                       {r, -h},
                                       {r, -0.75F * h},
                                       {0.82F * r, -0.6F * h},
                                       {0.78F * r, 0.55F * h},
                                       {0.95F * r, 0.75F * h},
                                       {r, 0.8F * h},
                                       {r, h},
                                       {0, h}};
    return render::revolve(outline, 12, colour(0x8A8496));
}

/// Rough crystal: a cluster of six-sided points inside the box.
MeshData crystal(fvec3 half) {
    MeshData mesh;
    const auto point = [&](fvec3 foot, float radius, float height, fvec3 lean, fvec3 paint) {
        const std::array<fvec2, 4> outline{
            fvec2(0, 0), {0.8F * radius, 0}, {radius, 0.7F * height}, {0, height}};
        const float angle = glm::length(lean);
        const fmat4 turned = angle > 0 ? rotated(lean / angle, angle) : fmat4(1);
        append(mesh, render::flat_shaded(render::revolve(outline, 6, paint)), translated(foot) * turned);
    };
    const float h = 2 * half.y;
    point({0, -half.y, 0}, 0.5F * half.x, h, fvec3(0), colour(0x7CE8F0));
    point({0.4F * half.x, -half.y, 0.2F * half.z}, 0.32F * half.x, 0.75F * h, {0.1F, 0, -0.35F},
          colour(0x58C0E8));
    point({-0.4F * half.x, -half.y, 0.1F * half.z}, 0.34F * half.x, 0.68F * h, {0.1F, 0, 0.4F},
          colour(0x9AF0E0));
    point({0, -half.y, -0.42F * half.z}, 0.3F * half.x, 0.6F * h, {-0.4F, 0, 0}, colour(0x4CA8E0));
    return mesh;
}

FurnitureMesh orb(float radius) {
    FurnitureMesh out;
    out.glowing = render::sphere(0.9F * radius, 18, colour(0x8A6AE0));
    for (auto& v : out.glowing.vertices) {
        // A fixed pattern of swirling clouds.
        const fvec3 p = v.position / radius;
        const float swirl = 0.5F + 0.5F * std::sin(7 * p.y + 3 * std::atan2(p.z, p.x) + 2 * p.x);
        v.colour = glm::mix(colour(0x4A2EA8), colour(0xB8A0FF), swirl);
    }
    out.lit = render::transformed(render::frame(32, 1.05F * radius, 0.97F * radius, 0.06F, colour(0xC89A4A)),
                                  rotated({0, 1, 0}, quarter));
    // A collar on the plinth, low enough that nothing covers the ball for a wizard in front of it.
    append(out.lit, render::frame(24, 0.72F * radius, 0.5F * radius, 0.2F * radius, colour(0xC89A4A)),
           translated({0, -0.82F * radius, 0}) * rotated({1, 0, 0}, quarter));
    return out;
}

/// Profile (radius, y) of a solid of revolution, from its vertices at angle 0.
std::vector<fvec2> profile_of(const physics::TriangleMesh& solid) {
    std::vector<fvec2> profile;
    for (const auto& v : solid.vertices) {
        if (v.z == 0 && v.x >= 0) profile.emplace_back(part(v.x), part(v.y));
    }
    return profile;
}

/// Size of the cauldron (m, body frame).
struct CauldronExtent {
    float rim = 0, top = -1e9F, bottom = 1e9F;  ///< radius of the rim, and heights of top and bottom
    float height_at(float share) const { return bottom + share * (top - bottom); }
};

CauldronExtent extent_of(const std::vector<fvec2>& profile) {
    CauldronExtent extent;
    for (const auto& p : profile) {
        extent.rim = std::max(extent.rim, p.x);
        extent.top = std::max(extent.top, p.y);
        extent.bottom = std::min(extent.bottom, p.y);
    }
    return extent;
}

/// A copper band around the cauldron, from y - high to y + high.
MeshData band(float radius, float y, float high) {
    const std::array<fvec2, 5> ring{fvec2(radius, y - high),
                                    {radius + 0.045F, y - 0.6F * high},
                                    {radius + 0.045F, y + 0.6F * high},
                                    {radius - 0.02F, y + high},
                                    {radius - 0.1F, y + high}};
    return render::revolve(ring, 28, colour(0xC87A3A));
}

/// Adds eight rivets on the lower band.
void add_rivets(const CauldronExtent& extent, MeshData& mesh) {
    for (int i = 0; i < 8; ++i) {
        const float angle = whole * (static_cast<float>(i) + 0.5F) / 8;
        const fvec3 at(1.015F * extent.rim * std::cos(angle), extent.height_at(0.6F),
                       1.015F * extent.rim * std::sin(angle));
        append(mesh, render::sphere(0.09F, 8, colour(0xE0A050)), translated(at));
    }
}

/// The painted brew for a bowl without a simulated one: brightest in the middle, with the arms of a swirl.
MeshData painted_brew(const CauldronExtent& extent) {
    const float level = extent.height_at(0.97F);
    const float radius = 0.885F * extent.rim;
    std::vector<fvec2> surface;
    for (int i = 0; i <= 10; ++i) {
        const float share = 1 - static_cast<float>(i) / 10;
        surface.emplace_back(share * radius,
                             level + 0.30F * (1 - share * share) + 0.02F * std::sin(9 * share));
    }
    auto brew = render::revolve(surface, 36, fvec3(1), 3);
    for (auto& v : brew.vertices) {
        const float share = glm::length(fvec2(v.position.x, v.position.z)) / radius;
        const float arm = 0.5F + 0.5F * std::sin(3 * std::atan2(v.position.z, v.position.x) + 7 * share);
        const fvec3 hot = colour(0xFFD060), warm = colour(0xFF7A18), deep = colour(0xC82A30);
        v.colour = glm::mix(glm::mix(hot, warm, share), deep, 0.75F * arm * share);
    }
    return brew;
}

}  // namespace

FurnitureMesh furniture(const ShapeKey& key) {
    const fvec3 size(key.size);
    const bool is_box = key.shape == Shape::box;
    const bool is_cylinder = key.shape == Shape::cylinder;
    switch (key.surface) {
        case Surface::crate:
            if (is_box) return {crate(size), {}};
            break;
        case Surface::barrel:
            if (is_cylinder) return {barrel(size.x, size.y), {}};
            break;
        case Surface::table:
            if (is_box) return {table(size), {}};
            break;
        case Surface::stone:
            if (is_box) return {boulder(size), {}};
            break;
        case Surface::ball: return {ball(size.x), {}};
        case Surface::plinth:
            if (is_cylinder) return {plinth(size.x, size.y), {}};
            break;
        case Surface::crystal:
            if (is_box) return {{}, crystal(size)};
            break;
        case Surface::orb: return orb(size.x);
        default: break;
    }
    return {plain(key, colour(0x807890)), {}};
}

FurnitureMesh cauldron(const physics::TriangleMesh& solid) {
    FurnitureMesh out;
    const auto profile = profile_of(solid);
    if (profile.size() < 3) return out;
    const CauldronExtent extent = extent_of(profile);
    out.lit = render::revolve(profile, 28, colour(0x5E4A50), 1.0F);
    append(out.lit, render::cylinder(1.015F * extent.rim, 0.001F, 28, colour(0x70442A)),
           translated({0, extent.bottom, 0}));
    append(out.lit, band(extent.rim, extent.top - 0.05F, 0.06F));
    append(out.lit, band(extent.rim, extent.height_at(0.6F), 0.05F));
    add_rivets(extent, out.lit);
    out.glowing = painted_brew(extent);
    return out;
}

FurnitureMesh anchor() {
    FurnitureMesh out;
    out.lit = render::frame(10, 2.2F, 1.7F, 0.5F, iron);
    append(out.lit, render::frame(10, 2.2F, 1.7F, 0.5F, iron), rotated({0, 1, 0}, quarter));
    out.glowing = render::sphere(0.9F, 8, colour(0xFFD860));
    return out;
}

FurnitureMesh start_plate(std::uint32_t team) {
    FurnitureMesh out;
    const auto lying = translated({0, 0.065F, 0}) * rotated({1, 0, 0}, -quarter);
    const fvec3 stone = colour(0x8A8698);
    append(out.lit, render::cone(1.15F, 1.08F, 0.06F, 18, 0.7F * stone), translated({0, 0.02F, 0}));
    if (team >= players) {
        append(out.glowing, render::flat_frame(18, 0.95F, 0.86F, colour(0x9A90B0)), lying);
        return out;
    }
    const auto& colours = team_colours(team);
    append(out.glowing, render::flat_frame(18, 1.0F, 0.9F, colours.glow), lying);
    const auto mark = team == 0 ? render::flat_frame(14, 0.55F, 0.38F, colours.glow)
                                : render::flat_frame(3, 0.75F, 0.4F, colours.glow);
    append(out.glowing, mark, lying);
    return out;
}

MeshData rune_circle(float radius) {
    const auto flat = rotated({1, 0, 0}, -quarter);
    const fvec3 ember = colour(0xD87028);
    constexpr float above = 0.017F;  // height of the signs above the ground (m)
    MeshData mesh;
    append(mesh, render::flat_frame(28, radius, radius - 0.05F, ember), translated({0, above, 0}) * flat);
    append(mesh, render::flat_frame(28, radius + 0.75F, radius + 0.7F, ember),
           translated({0, above, 0}) * flat);
    for (int i = 0; i < 12; ++i) {
        const float angle = whole * static_cast<float>(i) / 12;
        const fmat4 place = rotated({0, 1, 0}, angle) * translated({radius + 0.36F, above, 0}) * flat;
        append(mesh, render::flat_frame(3 + i % 3, 0.24F, 0.15F, ember), place);
    }
    return mesh;
}

MeshData contact_shade(float darkest) {
    constexpr std::uint32_t sides = 12, rings = 3;
    MeshData mesh;
    mesh.vertices.push_back({fvec3(0), {0, 1, 0}, fvec3(darkest)});
    for (std::uint32_t ring = 1; ring <= rings; ++ring) {
        const float radius = static_cast<float>(ring) / rings;
        // Smooth at both ends, so that no edge is visible.
        const float light = radius * radius * (3 - 2 * radius);
        for (std::uint32_t i = 0; i < sides; ++i) {
            const float angle = whole * static_cast<float>(i) / static_cast<float>(sides);
            mesh.vertices.push_back({{radius * std::cos(angle), 0, -radius * std::sin(angle)},
                                     {0, 1, 0},
                                     fvec3(glm::mix(darkest, 1.0F, light))});
        }
    }
    const auto at = [](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * sides + i % sides; };
    for (std::uint32_t i = 0; i < sides; ++i) {
        mesh.indices.insert(mesh.indices.end(), {0, at(1, i), at(1, i + 1)});
        for (std::uint32_t ring = 1; ring < rings; ++ring) {
            mesh.indices.insert(mesh.indices.end(), {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
            mesh.indices.insert(mesh.indices.end(), {at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
        }
    }
    return mesh;
}

}  // namespace thaum::game::inline scene
