// Adds the orb and the crystals to the picture of the arena.
#include <algorithm>
#include <array>

#include "game/data/teams.h"
#include "game/scene/arena_parts.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

/// Position of an eye that is near nothing, for a camera that belongs to no player.
constexpr vec3 far_away(1e6);

/// The rod from a wizard's hand to the tip: position of the hand (m, eye frame), radius, and distance from
/// the tip at which the rod ends.
constexpr vec3 hand{0.25, -0.35, -0.3};
constexpr double beam_radius = 0.006, beam_ends = 0.02;

vec3 eye_of_viewer(const Picture& picture, std::uint32_t viewer) {
    return viewer < players ? picture.wizards.at(viewer).vitals.eye : far_away;
}

/// The tip that a wizard's hand moves; null if there is none.
const TipPicture* tip_of(const Picture& picture, std::uint32_t player) {
    const auto& probe = picture.orb.probes.at(player);
    if (picture.orb.there && probe) return &*probe;
    const auto& p = picture.wizards.at(player);
    return p.stations.carving.carves ? &p.stations.carving.tip : nullptr;
}

/// Colour and shape of a tool, by its effect on how well the crystal would match its key: green with a plus
/// sign (better), red with a times sign (worse), or white without a sign. So the effect is not shown by
/// colour alone.
struct WorthLook {
    fvec3 light{};
    double turn{};  ///< rotation of the sign in the view (rad)
    bool cross{};
};

WorthLook look_of(DabWorth worth) {
    switch (worth) {
        case DabWorth::helps: return {render::colour(0x40FF60), 0, true};
        case DabWorth::spoils: return {render::colour(0xFF3020), pi / 4, true};
        case DabWorth::nothing: break;
    }
    return {fvec3(1), 0, false};
}

/// Adds the sign for a tool's effect, and a line from the tool down to the plinth, which shows the tool's
/// depth.
void add_tool(const ArenaScene& arena_scene, const Picture& picture, const PlayerPicture& p,
              std::vector<render::Instance>& out) {
    // half length of the sign's bars; radii of bars, line and the line's foot (m)
    constexpr double sign = 0.05, thick = 0.005, line = 0.003, foot = 0.02;
    const auto& tip = p.stations.carving.tip;
    const auto look = look_of(tip.worth);
    out.push_back(bead_at(arena_scene, tip.place, tip.works ? 0.026F : 0.022F, look.light, 0.95F));
    const quat view = look_rotation(p.vitals.yaw, p.vitals.pitch) * rotation({0, 0, 1}, look.turn);
    for (const vec3 arm : {vec3(sign, 0, 0), vec3(0, sign, 0)}) {
        if (!look.cross) break;
        add_beam(arena_scene, tip.place - view * arm, tip.place + view * arm, thick, look.light, out);
    }
    if (p.stations.carving.crystal >= picture.crystals.size()) return;
    const auto& crystal = picture.crystals[p.stations.carving.crystal];
    vec3 below = tip.place;
    below.y = crystal.middle.y - crystal.edge / 2;
    if (!(below.y < tip.place.y)) return;
    add_beam(arena_scene, tip.place, below, line, look.light, out);
    out.push_back(bead_at(arena_scene, below, static_cast<float>(foot), look.light, 0.8F));
}

/// Adds a thin beam of light above the orb or a crystal, so that players find it from behind walls. Players
/// near it do not see the beam.
void add_light_over(const ArenaScene& arena_scene, vec3 middle, vec3 eye, fvec3 light,
                    std::vector<render::Instance>& out) {
    // distance below which the beam is hidden; heights of its ends; its radius (m)
    constexpr double near = 7, from = 1.5, to = 13, thick = 0.035;
    if (glm::distance(eye, middle) < near) return;
    add_beam(arena_scene, middle + vec3(0, from, 0), middle + vec3(0, to, 0), thick, light, out);
}

/// Adds the beams above orb (violet) and crystals (blue).
void add_lights_over(const ArenaScene& arena_scene, const Picture& picture, vec3 eye,
                     std::vector<render::Instance>& out) {
    for (const auto& crystal : picture.crystals)
        add_light_over(arena_scene, crystal.middle, eye, render::colour(0x70C8FF), out);
    if (picture.orb.there)
        add_light_over(arena_scene, picture.orb.middle, eye, render::colour(0xC080FF), out);
}

std::size_t crystals_in(const ArenaScene& arena_scene, const Picture& picture) {
    return std::min(arena_scene.crystals.size(), picture.crystals.size());
}

}  // namespace

void show_stations(const ArenaScene& arena_scene, const Picture& picture) {
    const std::array eyes{picture.wizards[0].vitals.eye, picture.wizards[1].vitals.eye};
    if (arena_scene.orb != nullptr) show_orb(picture.orb, eyes, *arena_scene.orb);
    for (std::size_t i = 0; i < crystals_in(arena_scene, picture); ++i) {
        auto& look = *arena_scene.crystals[i];
        const auto& crystal = picture.crystals[i];
        show_crystal(crystal, look);
        look.body.sun = sees_sun(arena_scene.shade, crystal.middle) ? 1.0F : 0.0F;
    }
}

void add_crystals(const ArenaScene& arena_scene, const Picture& picture, vec3 eye,
                  std::vector<render::Scan>& out) {
    for (std::size_t i = 0; i < crystals_in(arena_scene, picture); ++i) {
        if (!sees_voxels(picture.crystals[i], eye)) continue;
        out.push_back(arena_scene.crystals[i]->body);
        out.push_back(arena_scene.crystals[i]->key);
    }
}

void add_mesh_changes(const ArenaScene& arena_scene, std::vector<render::MeshChange>& out) {
    if (arena_scene.orb != nullptr)
        out.insert(out.end(), arena_scene.orb->changes.begin(), arena_scene.orb->changes.end());
    for (const auto& crystal : arena_scene.crystals) out.push_back(crystal->mesh.change());
}

void add_stations(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                  std::vector<render::Instance>& out) {
    add_cauldron(arena_scene, picture, viewer, out);
    const vec3 eye = eye_of_viewer(picture, viewer);
    add_lights_over(arena_scene, picture, eye, out);
    for (std::size_t i = 0; i < crystals_in(arena_scene, picture); ++i)
        if (!sees_voxels(picture.crystals[i], eye))
            add_crystal(picture.crystals[i], *arena_scene.crystals[i], out);
    if (arena_scene.orb == nullptr) return;
    add_orb(*arena_scene.orb, picture.orb, viewer, eye, out);
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& p = picture.wizards.at(player);
        if (p.vitals.dead) continue;
        if (p.stations.carving.carves) {
            add_force(*arena_scene.orb, p.stations.carving.tip, out);
            add_tool(arena_scene, picture, p, out);
        }
        const auto* tip = tip_of(picture, player);
        if (tip == nullptr) continue;
        const vec3 from = p.vitals.eye + look_rotation(p.vitals.yaw, 0) * hand;
        const vec3 way = glm::normalize(tip->place - from);
        add_beam(arena_scene, from, tip->place - beam_ends * way, beam_radius, team_colours(player).light,
                 out);
    }
}

void add_tool_mists(const ArenaScene& arena_scene, const Picture& picture,
                    std::vector<render::Instance>& out) {
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& p = picture.wizards.at(player);
        if (!p.stations.carving.carves || p.vitals.dead) continue;
        const auto& tip = p.stations.carving.tip;
        out.push_back(bead_at(arena_scene, tip.place, static_cast<float>(tip.radius),
                              (tip.works ? 1.2F : 0.6F) * team_colours(player).light,
                              tip.works ? 0.6F : 0.4F));
    }
}

}  // namespace thaum::game::inline scene
