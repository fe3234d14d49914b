#include "game/scene/decoration.h"

#include <array>
#include <cmath>
#include <span>

#include "game/scene/masonry.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

using render::colour;
using render::MeshData;

/// One of the four walls: the middle of its base, the direction along it, the direction into the arena, and
/// half its length (m).
struct Wall {
    fvec3 middle, along, inwards;
    float half;
};

/// The four walls in the order of WallSide.
std::array<Wall, 4> walls(const Shade& shade) {
    const fvec2 low(shade.low), high(shade.high), middle = (low + high) / 2.0F, half = (high - low) / 2.0F;
    return {Wall{{middle.x, 0, high.y}, {1, 0, 0}, {0, 0, -1}, half.x},
            Wall{{middle.x, 0, low.y}, {1, 0, 0}, {0, 0, 1}, half.x},
            Wall{{high.x, 0, middle.y}, {0, 0, 1}, {-1, 0, 0}, half.y},
            Wall{{low.x, 0, middle.y}, {0, 0, 1}, {1, 0, 0}, half.y}};
}

fvec3 half_along(const Wall& wall, float along, float up, float deep) {
    return glm::abs(wall.along) * along + fvec3(0, up, 0) + glm::abs(wall.inwards) * deep;
}

/// Turns a mesh that faces +z towards the inside of the arena.
fmat4 facing(const Wall& wall) {
    return render::rotated({0, 1, 0}, std::atan2(wall.inwards.x, wall.inwards.z));
}

/// Adds merlons, the teeth of a battlement. They are plain boxes, since no player comes near enough to see a
/// bevel.
void add_merlons(const Shade& shade, const Wall& wall, float top, render::Patchwork& out) {
    for (float at = 1 - wall.half; at < wall.half; at += 2.5F) {
        const fvec3 place = wall.middle + at * wall.along + fvec3(0, top + 0.5F, 0) - 0.5F * wall.inwards;
        add_lit_patch(shade, vec3(place),
                      {.full = render::box(half_along(wall, 0.7F, 0.55F, 0.5F), colour(0x6E5662))}, out);
    }
}

/// Adds a bevelled box.
void add_ashlar(const Shade& shade, fvec3 place, fvec3 half, fvec3 paint, float bevel,
                render::Patchwork& out) {
    add_lit_patch(
        shade, vec3(place),
        {.full = render::box(half, paint, bevel), .plain = render::box(half, paint), .detail = bevel}, out);
}

void add_pilasters(const Shade& shade, const Wall& wall, float top, render::Patchwork& out) {
    for (const float share : {-0.75F, -0.25F, 0.25F, 0.75F}) {
        const fvec3 foot = wall.middle + share * wall.half * wall.along + 0.06F * wall.inwards;
        add_ashlar(shade, foot + fvec3(0, top / 2, 0), half_along(wall, 0.55F, top / 2, 0.12F),
                   colour(0x5E566C), 0.05F, out);
        add_ashlar(shade, foot + fvec3(0, 0.8F * top, 0), half_along(wall, 0.75F, 0.25F, 0.22F),
                   colour(0x746A7C), 0.06F, out);
    }
}

/// Adds a team's banner with its mark, so that the ends of the arena look different.
void add_banner(const Shade& shade, const Wall& wall, const BannerLook& look, render::Patchwork& out) {
    const fvec3 cloth = look.team == 0 ? colour(0xB8481A) : colour(0x1E5FA8);
    const fvec3 light = look.team == 0 ? colour(0xFFC27A) : colour(0x9ED4FF);
    const fvec3 place = wall.middle + static_cast<float>(look.along) * wall.along +
                        fvec3(0, static_cast<float>(look.height), 0) + 0.1F * wall.inwards;
    MeshData banner = render::box({1.1F, 2.3F, 0.04F}, cloth);
    render::append(banner, render::box({1.1F, 0.12F, 0.05F}, light), render::translated({0, -2.0F, 0}));
    render::append(banner, render::box({1.25F, 0.08F, 0.08F}, colour(0x4A3A30)),
                   render::translated({0, 2.35F, 0}));
    const auto mark =
        look.team == 0 ? render::frame(14, 0.75F, 0.51F, 0.1F, light) : render::triangle_mark(0.85F, light);
    render::append(banner, mark, render::translated({0, 0.35F, 0.06F}));
    add_lit_patch(shade, vec3(place), {.full = render::transformed(std::move(banner), facing(wall))}, out);
}

/// Adds a tower in separate pieces, one above the other, so that pieces hidden by the arena's walls need not
/// be drawn.
void add_tower(const TowerLook& look, render::Patchwork& out) {
    const fvec3 foot(look.foot);
    const auto radius = static_cast<float>(look.radius), height = static_cast<float>(look.height);
    const fvec3 stone = colour(0x4E4466), roof = colour(0x3A2C58);
    const auto add = [&](std::span<const fvec2> profile, fvec3 paint) {
        MeshData mesh;
        render::append(mesh, render::revolve(profile, 10, paint), render::translated(foot));
        out.push_back({.full = std::move(mesh)});
    };
    constexpr int pieces = 4;
    const auto shaft = [&](int i) {
        const float up = static_cast<float>(i) / pieces;
        return fvec2(glm::mix(1.0F, 0.9F, up) * radius, up * height);
    };
    for (int i = 0; i < pieces; ++i) add(std::array{shaft(i), shaft(i + 1)}, stone);
    add(std::array{fvec2(0.9F * radius, height), fvec2(1.15F * radius, height),
                   fvec2(1.15F * radius, height + 2)},
        stone);
    add(std::array{fvec2(0, height + 2), fvec2(1.35F * radius, height + 2), fvec2(0.5F * radius, height + 6),
                   fvec2(0, height + 13)},
        roof);
}

}  // namespace

void add_decoration(const Shade& shade, const ArenaLook& look, render::Patchwork& out) {
    const auto top = static_cast<float>(shade.wall_top);
    const auto all = walls(shade);
    for (const auto& wall : all) {
        if (look.merlons) add_merlons(shade, wall, top, out);
        if (look.pilasters) add_pilasters(shade, wall, top, out);
    }
    for (const auto& banner : look.banners)
        add_banner(shade, all[static_cast<std::size_t>(banner.wall)], banner, out);
}

render::Patchwork skyline(const ArenaLook& look) {
    render::Patchwork out;
    for (const auto& tower : look.towers) add_tower(tower, out);
    return out;
}

namespace {

/// Adds two lit windows on the side of a tower that faces the arena.
void add_windows(const TowerLook& tower, render::Patchwork& out) {
    const fvec3 foot(tower.foot), window = colour(0xFFC878);
    const auto radius = static_cast<float>(tower.radius), height = static_cast<float>(tower.height);
    const float distance = std::hypot(foot.x, foot.z);
    const fvec3 in = distance > 0 ? fvec3(-foot.x, 0, -foot.z) / distance : fvec3(0, 0, 1);
    const fmat4 turn = render::rotated({0, 1, 0}, std::atan2(in.x, in.z));
    for (const float up : {-2.5F, -7.0F}) {
        const fvec3 place = foot + (radius - 0.1F) * in + fvec3(0, height + up, 0);
        out.push_back({.full = render::transformed(render::box({0.35F, 0.7F, 0.3F}, window),
                                                   render::translated(place) * turn)});
    }
}

}  // namespace

render::Patchwork lamps(const Shade& shade, const ArenaLook& look) {
    render::Patchwork out;
    const fvec3 flame = colour(0xFFB45A);
    for (const fvec3 place : shade.lamps) {
        MeshData lamp;
        render::append(lamp, render::cone(0.05F, 0.16F, 0.3F, 6, colour(0x803A14)),
                       render::translated(place));
        render::append(lamp, render::cone(0.13F, 0, 0.5F, 6, flame),
                       render::translated(place + fvec3(0, 0.38F, 0)));
        out.push_back({.full = std::move(lamp)});
    }
    for (const auto& tower : look.towers) add_windows(tower, out);
    return out;
}

}  // namespace thaum::game::inline scene
