#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/data/teams.h"
#include "game/picture/force_colour.h"
#include "game/scene/arena_parts.h"
#include "game/scene/figures.h"

namespace thaum::game::inline scene {

using render::Instance;

namespace {

constexpr double min_share = 0.02;      ///< smallest force that is drawn, as a share of the strongest force
constexpr double ribbon_length = 0.25;  ///< length of the ribbon that shows a force, at the strongest one (m)
/// Greatest shown displacement of a wand by its hand (m); beyond it hand and wand would leave the picture.
constexpr double max_reach = 0.22;
constexpr double max_lower = 0.06;  ///< greatest shown displacement of a wand downwards (m)
/// Growth of the glow at a wand's tip up to full charge: in the other player's view, and in the player's own
/// view, where the glow is near and must not hide the target.
constexpr double foe_growth = 3.5, own_growth = 1.2;
/// A carried ingredient: its position above the player's own wand hand, visible at every aspect ratio (eye
/// frame), its position in the free hand as the other player sees it (frame of the feet), and its scales.
constexpr fvec3 carried_at{0.27F, -0.14F, -0.6F}, foe_carried_at{-0.42F, 1.0F, -0.27F};
constexpr float carried_scale = 0.15F, foe_carried_scale = 0.45F;

/// Displacement with which a player's own wand is drawn, from the actual displacement by the hand (m, eye
/// frame). The hand rests near the lower edge of the picture, so a lowered hand is drawn only a little lower.
/// A hand that is drawn back comes nearer along the ray from the eye through the hand.
vec3 drawn_reach(vec3 reach) {
    const double lower = std::max(0.0, -reach.y);
    if (lower > 0) reach.y = -max_lower * lower / (max_lower + lower);
    const vec3 shown = limited(reach, max_reach);
    const vec3 hand(own_hand);
    return shown - std::max(0.0, shown.z) * vec3(hand.x, hand.y, 0) / -hand.z;
}

/// Place of a player's own wand's tip as it is drawn (m, eye frame).
vec3 own_tip(const PlayerPicture& p) { return wand_tip + drawn_reach(p.wand.reach); }

}  // namespace

namespace {

/// Rotation of the wand and the hand about the wand's tip, following the stylus, the pen that the device's
/// user holds (eye frame). The angle is limited, because at larger angles the hand would separate from the
/// arm.
fmat4 stylus_turned(const PlayerPicture& p) {
    constexpr double most = 0.7;  // largest angle that is drawn (rad)
    const vec3 by = limited(p.wand.turn, most);
    const double angle = glm::length(by);
    if (!(angle > 1e-6)) return fmat4(1);
    return render::translated(fvec3(wand_tip)) * glm::mat4_cast(fquat(rotation(by / angle, angle))) *
           render::translated(-fvec3(wand_tip));
}

}  // namespace

void add_figure(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                std::vector<Instance>& out) {
    const auto& team = arena_scene.teams[number];
    const auto first = out.size();
    const fvec3 feet(p.vitals.centre - vec3(0, arena_scene.wizard_height / 2, 0));
    const auto standing = render::translated(feet) * looking(p.vitals.yaw, 0);
    out.push_back({.mesh = p.vitals.dead ? team.fallen : team.figure, .model = standing});
    if (!p.vitals.dead) {
        const auto arm = render::translated(fvec3(p.vitals.eye)) * looking(p.vitals.yaw, 0) *
                         render::translated(shoulder) * looking(0, p.vitals.pitch);
        out.push_back({.mesh = team.arm, .model = arm});
        if (!p.wand.name.empty() && !p.stations.stirs)
            out.push_back({.mesh = arena_scene.wands[p.wand.number],
                           .model = arm * render::translated(-shoulder) * stylus_turned(p) * wand_in_hand()});
    }
    set_sun(arena_scene, p.vitals.centre, std::span(out).subspan(first));
}

namespace {

/// The glow at a wand's tip. At full charge its radius is 1 + `growth` times that without charge.
Instance spark_at(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                  const fmat4& tip, double growth) {
    const auto size = static_cast<float>(1 + growth * p.wand.readiness);
    return {.mesh = arena_scene.teams[number].spark, .model = glm::scale(tip, fvec3(size)), .glow = 1};
}

}  // namespace

void add_glow(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p, double time,
              std::vector<Instance>& out) {
    if (p.vitals.dead) return;
    const auto& team = arena_scene.teams[number];
    const auto arm = render::translated(fvec3(p.vitals.eye)) * looking(p.vitals.yaw, 0) *
                     render::translated(shoulder) * looking(0, p.vitals.pitch);
    if (!p.wand.name.empty())
        out.push_back(spark_at(arena_scene, number, p, arm * render::translated(fvec3(wand_tip) - shoulder),
                               foe_growth));
    if (!p.stations.carries.empty()) {
        const fvec3 feet(p.vitals.centre - vec3(0, arena_scene.wizard_height / 2, 0));
        add_ingredient(
            arena_scene,
            render::translated(feet) * looking(p.vitals.yaw, 0) * render::translated(foe_carried_at),
            foe_carried_scale, p.stations.carried_shape, p.stations.carried_colour, out);
    }
    if (p.vitals.shielded) {
        const auto slowly = looking(0.8 * time, 0);
        out.push_back({.mesh = team.shield,
                       .model = render::translated(fvec3(p.vitals.centre)) * slowly,
                       .glow = 0.9F});
    }
}

void add_own_arm(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                 std::vector<Instance>& out) {
    const auto first = out.size();
    const auto eye = render::translated(fvec3(p.vitals.eye)) * looking(p.vitals.yaw, p.vitals.pitch) *
                     render::translated(fvec3(drawn_reach(p.wand.reach))) * stylus_turned(p);
    if (p.stations.works()) return;  // the view of a player at a station shows only the ladle or the tip
    out.push_back({.mesh = arena_scene.teams[number].own_arm, .model = eye});
    if (!p.wand.name.empty()) {
        out.push_back({.mesh = arena_scene.wands[p.wand.number], .model = eye * wand_in_own_hand()});
        out.push_back(
            spark_at(arena_scene, number, p, eye * render::translated(fvec3(wand_tip)), own_growth));
    }
    set_sun(arena_scene, p.vitals.eye, std::span(out).subspan(first));
    if (!p.stations.carries.empty())
        add_ingredient(arena_scene, eye * render::translated(carried_at), carried_scale,
                       p.stations.carried_shape, p.stations.carried_colour, out);
}

void add_beam(const ArenaScene& arena_scene, vec3 from, vec3 to, double thick, fvec3 tint,
              std::vector<Instance>& out) {
    const vec3 way = to - from;
    const double length = glm::length(way);
    if (length < 1e-6) return;
    const auto yaw = std::atan2(-way.x, -way.z), pitch = std::atan2(way.y, std::hypot(way.x, way.z));
    const fvec3 size(vec3(thick, thick, length));
    out.push_back({.mesh = arena_scene.beam,
                   .model = glm::scale(render::translated(fvec3(from)) * looking(yaw, pitch), size),
                   .tint = tint,
                   .glow = 0.7F});
}

namespace {

/// Colour of the present force on the hand, by its share of the largest force allowed (linear light).
fvec3 tint_of(const ForcePicture& force) {
    const fvec3 shown = force_colour(force.share());
    return shown * shown;  // converts screen colours to linear light
}

/// Adds a coil spring from a point along a vector. The shorter the spring, the closer its turns.
void add_coil(const ArenaScene& arena_scene, vec3 from, vec3 way, fvec3 tint, std::vector<Instance>& out) {
    constexpr int turns = 5, steps = 8 * turns;
    constexpr double radius = 0.022;  // radius of the coil (m)
    constexpr double thick = 0.004;   // radius of the wire (m)
    const double length = glm::length(way);
    if (length < 0.01) return;
    const vec3 along = way / length;
    const vec3 side = perpendicular_to(along);
    const vec3 up = glm::cross(side, along);
    const auto point = [&](int i) {
        const double share = static_cast<double>(i) / steps, angle = 2 * pi * turns * share;
        return from + share * way + radius * (std::cos(angle) * side + std::sin(angle) * up);
    };
    for (int i = 0; i < steps; ++i) add_beam(arena_scene, point(i), point(i + 1), thick, tint, out);
}

}  // namespace

void add_drawn_shot(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                    std::vector<Instance>& out) {
    const fvec3 light = team_colours(number).light;
    for (std::uint32_t i = 0; i < p.wand.arc_points; ++i) {
        const bool last = i + 1 == p.wand.arc_points;
        const float size = last ? 0.12F : 0.035F + 0.002F * static_cast<float>(i);
        out.push_back(bead_at(arena_scene, p.wand.arc.at(i), size, light, 0.8F));
    }
    if (!p.wand.spring) return;
    const auto view = look_rotation(p.vitals.yaw, p.vitals.pitch);
    const vec3 from = wand_tip + drawn_reach(*p.wand.spring), way = own_tip(p) - from;
    add_coil(arena_scene, p.vitals.eye + view * from, view * way, tint_of(p.senses.force), out);
}

void add_forces(const ArenaScene& arena_scene, const PlayerPicture& p, bool own, std::vector<Instance>& out) {
    if (p.vitals.dead) return;
    const auto view = look_rotation(p.vitals.yaw, p.vitals.pitch);
    const vec3 tip = p.vitals.eye + view * (own ? own_tip(p) : wand_tip);
    const fvec3 tint = tint_of(p.senses.force);
    if (p.wand.held) add_beam(arena_scene, tip, *p.wand.held, 0.012, tint, out);
    if (!own || p.senses.force.share() < min_share) return;
    add_beam(arena_scene, tip, tip + view * p.senses.force.current / p.senses.force.cap * ribbon_length,
             0.006, tint, out);
    out.push_back(bead_at(arena_scene, tip, 0.02F, tint, 0.7F));
}

}  // namespace thaum::game::inline scene
