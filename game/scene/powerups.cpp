#include "game/scene/powerups.h"

#include <cmath>

namespace thaum::game::inline scene {
namespace {

using render::append;
using render::colour;
using render::MeshData;
using render::rotated;
using render::scaled;
using render::translated;

constexpr float height = 0.85F;  // height of a power-up's shape above the ground (m)
constexpr float ring_radius = 0.5F;
constexpr float half_turn = 3.1415927F;

fvec3 colour_of(PowerUpKind kind) {
    switch (kind) {
        case PowerUpKind::vial: return colour(0x58E88A);
        case PowerUpKind::heart: return colour(0xFF4C86);
        case PowerUpKind::spark: return colour(0xFFE45C);
    }
    return fvec3(1);
}

MeshData vial(fvec3 paint) {
    const std::array<fvec2, 10> profile{fvec2{0, -0.26F}, {0.13F, -0.26F}, {0.21F, -0.16F}, {0.21F, -0.04F},
                                        {0.14F, 0.06F},   {0.07F, 0.11F},  {0.07F, 0.24F},  {0.10F, 0.25F},
                                        {0.10F, 0.29F},   {0, 0.29F}};
    auto mesh = render::revolve(profile, 16, paint);
    append(mesh, render::cylinder(0.05F, 0.1F, 10, colour(0x9A6A3C)), translated({0, 0.33F, 0}));
    return mesh;
}

MeshData heart(fvec3 paint) {
    MeshData mesh;
    for (const float side : {-1.0F, 1.0F}) {
        append(mesh, render::sphere(0.17F, 14, paint), translated({0.13F * side, 0.1F, 0}));
    }
    append(mesh, render::cone(0.01F, 0.27F, 0.36F, 18, paint), translated({0, -0.14F, 0}));
    return render::transformed(std::move(mesh), scaled({1, 1, 0.6F}));
}

MeshData star(fvec3 paint) {
    MeshData mesh;
    const std::array<float, 4> lengths{0.36F, 0.24F, 0.36F, 0.24F};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const auto turn = rotated({0, 0, 1}, static_cast<float>(i) * half_turn / 2);
        append(mesh, render::cone(0.1F, 0, lengths[i], 4, paint), turn * translated({0, lengths[i] / 2, 0}));
    }
    return mesh;
}

MeshData ring(fvec3 paint) {
    // The ring has no underside, since no player sees it.
    const std::array<fvec2, 4> profile{
        fvec2{ring_radius, 0}, {ring_radius, 0.03F}, {0.9F * ring_radius, 0.03F}, {0.9F * ring_radius, 0}};
    return render::revolve(profile, 24, paint);
}

fmat4 facing(vec3 place, vec3 eye) {
    const vec3 to = eye - place;
    return rotated({0, 1, 0}, static_cast<float>(std::atan2(to.x, to.z)));
}

}  // namespace

MeshData power_up_mesh(PowerUpKind kind) {
    const auto paint = colour_of(kind);
    switch (kind) {
        case PowerUpKind::vial: return vial(paint);
        case PowerUpKind::heart: return heart(paint);
        case PowerUpKind::spark: return star(paint);
    }
    return {};
}

PowerUpMeshes make_power_up_meshes(render::Renderer& renderer) {
    PowerUpMeshes meshes;
    for (std::size_t i = 0; i < meshes.kinds.size(); ++i) {
        const auto kind = static_cast<PowerUpKind>(i);
        const auto paint = colour_of(kind);
        meshes.kinds[i] = {.shape = renderer.upload_with_copies(power_up_mesh(kind)),
                           .ring = renderer.upload_with_copies(ring(paint)),
                           .disc = renderer.upload_with_copies(
                               render::cylinder(0.85F * ring_radius, 0.02F, 24, 0.5F * paint))};
    }
    return meshes;
}

void add_power_ups(const PowerUpMeshes& meshes, const Picture& picture, vec3 eye,
                   std::vector<render::Instance>& out) {
    for (const auto& p : picture.power_ups) {
        const auto& kind = meshes.kinds[static_cast<std::size_t>(p.kind)];
        const bool there = p.returned >= 1;
        const auto ground = translated(fvec3(p.position));
        out.push_back({.mesh = kind.ring, .model = ground, .glow = there ? 0.9F : 0.2F});
        if (there) {
            const auto above =
                ground * translated({0, height, 0}) * facing(p.position, eye) * scaled(fvec3(1.3F));
            out.push_back({.mesh = kind.shape, .model = above, .glow = 0.7F});
        } else if (p.returned > 0) {
            const auto size = static_cast<float>(p.returned);
            out.push_back({.mesh = kind.disc, .model = ground * scaled({size, 1, size}), .glow = 0.5F});
        }
    }
}

}  // namespace thaum::game::inline scene
