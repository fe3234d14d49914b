#include "game/scene/figures.h"
#include "game/data/teams.h"

#include <array>
#include <cmath>

#include "game/data/teams.h"
#include "game/data/wand.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

using render::append;
using render::colour;
using render::MeshData;
using render::rotated;
using render::translated;

const fvec3 skin = colour(0xE0B08C);
const fvec3 wood = colour(0x5A3A26);
const fvec3 gold = colour(0xE8C060);

constexpr fvec3 to_the_right{1, 0, 0};
constexpr fvec3 up{0, 1, 0};

/// A cone or cylinder from one point to another.
MeshData limb(fvec3 from, fvec3 to, float thick, float thin, int segments, fvec3 paint) {
    const fvec3 along = to - from;
    const float length = glm::length(along);
    const fvec3 way = along / length;
    const fvec3 axis = glm::cross(up, way);
    const float sine = glm::length(axis);
    const float angle = std::atan2(sine, way.y);
    const fmat4 turned = sine > 1e-5F ? rotated(axis / sine, angle)
                                      : (way.y < 0 ? rotated(to_the_right, 3.14159265F) : fmat4(1));
    return render::transformed(render::cone(thick, thin, length, segments, paint),
                               translated((from + to) / 2.0F) * turned);
}

MeshData mark(std::uint32_t team, float radius, fvec3 paint) {
    return team == 0 ? render::ring_mark(radius, paint) : render::triangle_mark(1.15F * radius, paint);
}

/// The robe of team ember: level bands.
void add_banded_robe(MeshData& mesh, const TeamColours& team) {
    const std::array<fvec2, 6> outline{fvec2(0.46F, 0.0F), {0.42F, 0.16F}, {0.34F, 0.55F},
                                       {0.26F, 0.98F},     {0.30F, 1.28F}, {0.12F, 1.47F}};
    const std::array paints{team.light, team.cloth, team.dark, team.cloth, team.cloth};
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        append(mesh, render::revolve(std::array{outline[i], outline[i + 1]}, 20, paints[i]));
    }
}

/// The robe of team tide: vertical stripes in alternating colours.
void add_gored_robe(MeshData& mesh, const TeamColours& team) {
    const std::array<fvec2, 6> outline{fvec2(0.46F, 0.0F), {0.42F, 0.16F}, {0.34F, 0.55F},
                                       {0.26F, 0.98F},     {0.30F, 1.28F}, {0.12F, 1.47F}};
    auto robe = render::flat_shaded(render::revolve(outline, 14, team.cloth));
    for (std::size_t i = 0; i + 2 < robe.vertices.size(); i += 3) {
        const fvec3 middle =
            (robe.vertices[i].position + robe.vertices[i + 1].position + robe.vertices[i + 2].position) /
            3.0F;
        const float turn = (std::atan2(middle.z, middle.x) / 6.2831853F + 1) * 14;
        const bool odd = static_cast<int>(std::floor(turn)) % 2 != 0;
        const fvec3 paint = middle.y < 0.14F ? team.light : (odd && middle.y < 1.0F ? team.dark : team.cloth);
        for (std::size_t k = 0; k < 3; ++k) robe.vertices[i + k].colour = paint;
    }
    append(mesh, robe);
}

MeshData hat(std::uint32_t number) {
    const auto& team = team_colours(number);
    MeshData mesh = render::revolve(
        std::array{fvec2(0, 0.02F), fvec2(0.4F, 0.0F), fvec2(0.41F, 0.03F), fvec2(0.2F, 0.07F)}, 20,
        team.dark);
    append(mesh, render::revolve(std::array{fvec2(0.2F, 0.06F), fvec2(0.185F, 0.17F)}, 12, team.light));
    append(mesh, render::revolve(std::array{fvec2(0.185F, 0.17F), fvec2(0.12F, 0.4F)}, 12, team.cloth));
    // The tip of the hat is bent back like that of an old hat.
    const fmat4 bent = translated({0, 0.4F, 0}) * rotated(to_the_right, 0.5F);
    append(mesh,
           render::revolve(std::array{fvec2(0.12F, -0.02F), fvec2(0.055F, 0.2F), fvec2(0, 0.24F)}, 10,
                           team.cloth),
           bent);
    append(mesh, mark(number, 0.1F, gold), translated({0, 0.22F, -0.19F}) * rotated(up, 3.14159265F));
    append(mesh, mark(number, 0.1F, gold), translated({0, 0.22F, 0.19F}));
    return mesh;
}

void add_head(MeshData& mesh, const TeamColours& team) {
    append(mesh, render::sphere(0.155F, 12, skin), translated({0, 1.58F, 0}));
    for (const float side : {-1.0F, 1.0F})
        append(mesh, render::sphere(0.026F, 6, colour(0x201820)), translated({side * 0.06F, 1.61F, -0.138F}));
    append(mesh, render::sphere(0.034F, 6, skin), translated({0, 1.57F, -0.16F}));
    // Beard and collar.
    append(mesh, render::cone(0.02F, 0.12F, 0.3F, 8, colour(0xD8D4DC)),
           translated({0, 1.42F, -0.13F}) * rotated(to_the_right, 0.25F));
    append(mesh, render::cone(0.25F, 0.17F, 0.12F, 12, team.light), translated({0, 1.43F, 0}));
}

/// Adds sleeve and hand (eye frame). `start` is the shoulder or a point beyond the edge of the picture.
void add_hand(MeshData& mesh, const TeamColours& team, fvec3 start, fvec3 hand) {
    const fvec3 tip(wand_tip);
    const fvec3 back = glm::normalize(start - hand);
    append(mesh, limb(start, hand + 0.07F * back, 0.10F, 0.085F, 10, team.cloth));
    append(mesh, limb(hand + 0.11F * back, hand + 0.05F * back, 0.095F, 0.09F, 10, team.light));
    const fvec3 way = glm::normalize(tip - hand);
    append(mesh, limb(hand + 0.06F * back, hand, 0.03F, 0.034F, 8, skin));
    append(mesh, render::sphere(0.04F, 10, skin), translated(hand + fvec3(0.008F, -0.008F, 0)));
    // Knuckles of a fist around the handle, and the thumb along it.
    for (const float along : {-0.03F, -0.008F, 0.014F, 0.036F})
        append(mesh, render::sphere(0.0175F, 6, 0.93F * skin),
               translated(hand + along * way + fvec3(-0.022F, 0.012F, 0)));
    append(mesh, limb(hand - 0.01F * way, hand + 0.055F * way, 0.014F, 0.01F, 6, skin),
           translated({0.006F, 0.026F, 0}));
}

/// The hand as the other player sees it (eye frame): farther back, so that more of the wand is visible.
const fvec3 foe_hand = fvec3(wand_tip) + fvec3(0.04F, -0.10F, 0.44F);

/// Rotates and stretches a mesh along -z so that it reaches from the hand to wand_tip.
fmat4 held(fvec3 hand) {
    const fvec3 along = fvec3(wand_tip) - hand;
    const fvec3 z = -glm::normalize(along);
    const fvec3 x = glm::normalize(glm::cross(up, z));
    const fmat4 turned(fvec4(x, 0), fvec4(glm::cross(z, x), 0), fvec4(z, 0), fvec4(hand, 1));
    return turned * render::scaled(fvec3(glm::length(along) / wand_length));
}

/// Position in the mesh of a point of a WandLook, whose z axis points ahead.
fvec3 mesh_place(vec3 p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), -static_cast<float>(p.z)};
}

fvec3 ahead(float z) { return {0, 0, -z}; }

void add_hand_state(MeshData& mesh) {
    append(mesh, limb(ahead(-0.09F), ahead(0.08F), 0.024F, 0.026F, 8, wood));
    append(mesh, limb(ahead(0.08F), ahead(0.115F), 0.037F, 0.029F, 8, gold));
}

fvec3 paint_of(const LookPart& part, std::uint32_t team) {
    switch (part.paint) {
        case LookPaint::fixed: return colour(part.colour);
        case LookPaint::glow: return team_colours(team).glow;
        case LookPaint::core: return glm::mix(team_colours(team).glow, fvec3(1), 0.6F);
    }
    return fvec3(1);
}

void add_rod(MeshData& mesh, const LookPart& part, fvec3 paint) {
    const auto thick = static_cast<float>(part.radius), thin = static_cast<float>(part.radius_end);
    append(mesh, limb(mesh_place(part.from), mesh_place(part.to), thick, thin, part.sides, paint));
    if (part.capped) append(mesh, render::sphere(thin, part.sides, paint), translated(mesh_place(part.to)));
}

void add_ball(MeshData& mesh, const LookPart& part, fvec3 paint) {
    const auto ball = render::sphere(static_cast<float>(part.radius), part.sides, paint);
    append(mesh, render::transformed(ball, render::scaled(fvec3(part.stretch))),
           translated(mesh_place(part.from)));
}

void add_ring(MeshData& mesh, const LookPart& part, std::uint32_t team, fvec3 paint) {
    constexpr float quarter = 1.5707963F;
    const int sides = part.sides > 0 ? part.sides : (team == 0 ? 12 : 3);
    const auto ring =
        render::frame(sides, static_cast<float>(part.radius), static_cast<float>(part.radius_end),
                      static_cast<float>(part.thickness), paint);
    const fmat4 turned = part.axis == 0   ? rotated(up, quarter)
                         : part.axis == 1 ? rotated(to_the_right, quarter)
                                          : fmat4(1);
    append(mesh, ring,
           translated(mesh_place(part.from)) * turned * rotated({0, 0, 1}, static_cast<float>(part.turn)));
}

/// Adds a rod that is bent in an arc, as short straight rods.
void add_crook(MeshData& mesh, const LookPart& part, fvec3 paint) {
    constexpr int steps = 7;
    const auto point = [&](int i) {
        const double angle = part.turn * i / steps;
        return part.from + part.bend * vec3(0, 1 - std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < steps; ++i) {
        auto rod = part;
        rod.from = point(i), rod.to = point(i + 1);
        rod.radius = glm::mix(part.radius, part.radius_end, static_cast<double>(i) / steps);
        rod.radius_end = glm::mix(part.radius, part.radius_end, static_cast<double>(i + 1) / steps);
        rod.capped = true;
        add_rod(mesh, rod, paint);
    }
}

/// Adds the team's mark perpendicular to each axis: rings, or triangles of the same width.
void add_cage(MeshData& mesh, std::uint32_t number, float radius, float thick, fvec3 paint) {
    constexpr float quarter = 1.5707963F;
    const int sides = number == 0 ? 16 : 3;
    const float size = number == 0 ? radius : 1.4F * radius;
    for (const fmat4& way : {fmat4(1), rotated(to_the_right, quarter), rotated(up, quarter)})
        append(mesh, render::frame(sides, size, size - thick, thick, paint), way);
}

void add_part(MeshData& mesh, LookPart part, std::uint32_t team) {
    const fvec3 paint = paint_of(part, team);
    for (int side = 0; side < (part.mirrored ? 2 : 1); ++side) {
        switch (part.shape) {
            case LookShape::rod: add_rod(mesh, part, paint); break;
            case LookShape::ball: add_ball(mesh, part, paint); break;
            case LookShape::ring: add_ring(mesh, part, team, paint); break;
            case LookShape::crook: add_crook(mesh, part, paint); break;
            case LookShape::cage:
                add_cage(mesh, team, static_cast<float>(part.radius), static_cast<float>(part.thickness),
                         paint);
                break;
        }
        part.from.x = -part.from.x;
        part.to.x = -part.to.x;
    }
}

}  // namespace

MeshData wizard_figure(std::uint32_t number) {
    const auto& team = team_colours(number);
    MeshData mesh;
    if (number == 0)
        add_banded_robe(mesh, team);
    else
        add_gored_robe(mesh, team);
    append(mesh, render::cylinder(0.275F, 0.07F, 14, gold), translated({0, 0.98F, 0}));
    append(mesh, mark(number, 0.13F, gold), translated({0, 1.2F, -0.29F}) * rotated(up, 3.14159265F));
    append(mesh, mark(number, 0.17F, gold), translated({0, 1.15F, 0.29F}));
    add_head(mesh, team);
    // The free arm.
    append(mesh, limb({-0.25F, 1.36F, 0}, {-0.36F, 0.95F, -0.1F}, 0.09F, 0.12F, 10, team.cloth));
    append(mesh, render::sphere(0.05F, 8, skin), translated({-0.37F, 0.9F, -0.11F}));
    append(mesh, hat(number), translated({0, 1.66F, 0.01F}) * rotated(to_the_right, 0.1F));
    return mesh;
}

MeshData fallen_wizard(std::uint32_t number) {
    const auto& team = team_colours(number);
    MeshData mesh = render::revolve(
        std::array{fvec2(0.75F, 0.0F), fvec2(0.55F, 0.1F), fvec2(0.3F, 0.13F), fvec2(0, 0.2F)}, 11,
        team.cloth);
    append(mesh, render::revolve(std::array{fvec2(0.8F, 0.0F), fvec2(0.7F, 0.05F)}, 11, team.light));
    append(mesh, hat(number), translated({0.1F, 0.16F, 0}) * rotated({0, 0, 1}, 0.35F));
    return mesh;
}

MeshData wizard_arm(std::uint32_t number) {
    MeshData mesh;
    add_hand(mesh, team_colours(number), shoulder, foe_hand);
    return render::transformed(mesh, translated(-shoulder));
}

MeshData own_arm(std::uint32_t number) {
    MeshData mesh;
    add_hand(mesh, team_colours(number), {0.72F, -0.52F, -0.22F}, own_hand);
    return mesh;
}

MeshData wand_mesh(const WandLook& look) {
    MeshData mesh, parts;
    add_hand_state(mesh);
    for (const auto& part : look.wand) add_part(parts, part, 0);
    append(mesh, parts, look.flat ? rotated({0, 0, 1}, 0.7F) : fmat4(1));
    return mesh;
}

MeshData missile_mesh(const WandLook& look, std::uint32_t team) {
    MeshData mesh;
    for (const auto& part : look.missile) add_part(mesh, part, team);
    if (look.missile.empty()) mesh = wand_spark(team);
    return mesh;
}

fmat4 wand_in_hand() { return held(foe_hand); }
fmat4 wand_in_own_hand() { return held(own_hand); }

MeshData wand_spark(std::uint32_t number) {
    return render::sphere(0.014F, 8, glm::mix(team_colours(number).glow, fvec3(1), 0.35F));
}

MeshData beam_of_light() {
    return render::transformed(render::cylinder(1, 1, 6, fvec3(1)),
                               translated({0, 0, -0.5F}) * rotated(to_the_right, 1.5707963F));
}

MeshData burst_shell(std::uint32_t number) {
    MeshData mesh;
    add_cage(mesh, number, 1, 0.06F, team_colours(number).glow);
    return mesh;
}

MeshData shield_rings(std::uint32_t number) {
    const auto& team = team_colours(number);
    const int sides = number == 0 ? 28 : 3;
    const float size = number == 0 ? 0.75F : 1.1F;
    MeshData mesh;
    for (const float height : {-0.75F, 0.0F, 0.75F}) {
        append(mesh, render::transformed(render::frame(sides, size, size - 0.05F, 0.03F, team.light),
                                         translated({0, height, 0}) * rotated(to_the_right, 1.5707963F)));
    }
    return mesh;
}

}  // namespace thaum::game::inline scene
