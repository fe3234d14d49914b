#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "game/data/teams.h"
#include "game/scene/arena_parts.h"
#include "game/scene/furniture.h"

namespace thaum::game::inline scene {

using render::Instance;
using render::PointLight;

fmat4 placed(vec3 position, quat orientation) {
    fmat4 m = glm::mat4_cast(fquat(orientation));
    m[3] = fvec4(fvec3(position), 1);
    return m;
}

fmat4 looking(double yaw, double pitch) { return glm::mat4_cast(fquat(look_rotation(yaw, pitch))); }

void set_sun(const ArenaScene& arena_scene, vec3 at, std::span<Instance> of) {
    const float sun = sees_sun(arena_scene.shade, at) ? 1.0F : 0.0F;
    for (auto& instance : of) instance.sun = sun;
}

Instance bead_at(const ArenaScene& arena_scene, vec3 place, float radius, fvec3 tint, float glow) {
    return {.mesh = arena_scene.bead,
            .model = glm::scale(render::translated(fvec3(place)), fvec3(radius)),
            .tint = tint,
            .glow = glow};
}

namespace {

// height above the ground at which the soft contact shade below a thing ends (m)
constexpr double shade_reach = 2.5;

void add(const ArenaScene::Meshes& meshes, const fmat4& model, std::vector<Instance>& out) {
    if (meshes.lit) out.push_back({.mesh = *meshes.lit, .model = model});
    if (meshes.glowing)
        out.push_back(
            {.mesh = *meshes.glowing, .model = model, .tint = fvec3(meshes.glow), .glow = glow_share});
}

const ArenaScene::Meshes* find_solid(const ArenaScene& arena_scene, const ThingPicture& thing) {
    for (const auto& solid : arena_scene.solids) {
        if (thing.fixed && solid.key == thing.key && solid.position == thing.position) return &solid.meshes;
    }
    return nullptr;
}

const ArenaScene::Meshes* find_kind(const ArenaScene& arena_scene, const ThingPicture& thing) {
    for (const auto& kind : arena_scene.kinds) {
        if (kind.key == thing.key) return &kind.meshes;
    }
    return nullptr;
}

/// Adds a thing that is not in the arena's file, such as one added by a scenario, as its plain shape.
void add_unknown(const ArenaScene& arena_scene, const ThingPicture& thing, std::vector<Instance>& out) {
    const auto shape = static_cast<std::size_t>(thing.key.shape);
    if (shape >= arena_scene.unit_shapes.size()) return;
    const fvec3 size(thing.key.size);
    const bool round = thing.key.shape == physics::Shape::sphere;
    const fvec3 scale = thing.key.shape == physics::Shape::box ? size
                        : round                                ? fvec3(size.x)
                                                               : fvec3(size.x, size.y, size.x);
    out.push_back({.mesh = arena_scene.unit_shapes[shape],
                   .model = glm::scale(placed(thing.position, thing.orientation), scale)});
}

/// Returns the highest ground below a position, or null.
const ArenaScene::Ground* ground_below(const ArenaScene& arena_scene, vec3 at) {
    const ArenaScene::Ground* best = nullptr;
    for (const auto& g : arena_scene.grounds) {
        const bool over = at.x >= g.low.x && at.x <= g.high.x && at.z >= g.low.z && at.z <= g.high.z;
        if (over && g.height_at(at) <= at.y + 0.1 &&
            (best == nullptr || g.height_at(at) > best->height_at(at)))
            best = &g;
    }
    return best;
}

/// Whether the ground's plane lies under the whole rim of a shade, so that the shade does not extend over an
/// edge.
bool lies_flat(const ArenaScene& arena_scene, const ArenaScene::Ground& ground, vec3 centre, double radius) {
    for (const vec3 way : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
        const vec3 rim = centre + radius * way;
        const double height = ground.height_at(rim);
        const auto* there = ground_below(arena_scene, {rim.x, height + 0.2, rim.z});
        if (there == nullptr || std::abs(there->height_at(rim) - height) > 0.05) return false;
    }
    return true;
}

void add_contact_shade(const ArenaScene& arena_scene, vec3 centre, double radius, double half_height,
                       std::vector<Instance>& out) {
    const auto* ground = ground_below(arena_scene, centre - vec3(0, 0.9 * half_height, 0));
    if (ground == nullptr) return;
    const double above = std::max(0.0, centre.y - half_height - ground->height_at(centre));
    if (above > shade_reach) return;
    for (int smaller = 0; smaller < 3 && !lies_flat(arena_scene, *ground, centre, radius); ++smaller)
        radius *= 0.6;
    if (!lies_flat(arena_scene, *ground, centre, radius)) return;
    const auto size = static_cast<float>(radius);
    const vec3 at(centre.x, ground->height_at(centre) + 0.012, centre.z);
    fmat4 m = render::translated(fvec3(at));
    m[0] = fvec4(size, size * static_cast<float>(ground->slope_x), 0, 0);
    m[2] = fvec4(0, size * static_cast<float>(ground->slope_z), size, 0);
    const auto strength = static_cast<float>(1 - above / shade_reach);
    out.push_back({.mesh = arena_scene.contact, .model = m, .tint = fvec3(strength)});
}

void add_thing(const ArenaScene& arena_scene, const ThingPicture& thing, std::vector<Instance>& out) {
    const auto first = out.size();
    auto model = placed(thing.position, thing.orientation);
    if (const auto* solid = find_solid(arena_scene, thing)) return add(*solid, model, out);
    if (thing.key.surface == Surface::pad)
        add(thing.team < players ? arena_scene.teams[thing.team].plate : arena_scene.neutral_plate, model,
            out);
    else if (thing.key.surface == Surface::anchor)
        add(arena_scene.anchor, glm::scale(model, fvec3(fvec3(thing.key.size).x)), out);
    else if (const auto* kind = find_kind(arena_scene, thing))
        add(*kind, model, out);
    else
        add_unknown(arena_scene, thing, out);
    // Sunlight is tested 0.1 m above the position, because a flat thing lies inside the ground's block.
    set_sun(arena_scene, thing.position + vec3(0, 0.1, 0), std::span(out).subspan(first));
}

/// Brightens a thing that the viewer's wand would take hold of.
void light_up(std::span<Instance> of) {
    for (auto& instance : of) {
        instance.tint *= 1.3F;
        instance.glow = std::max(instance.glow, 0.35F);
    }
}

/// Whether the viewer's wand would take hold of this thing: lift it or hook a rope to it.
bool is_target(const Target& target, const ThingPicture& thing) {
    return (target.kind == TargetKind::take || target.kind == TargetKind::hook) && target.thing &&
           target.thing.index == thing.entity;
}

/// Adds a cage of rings or triangles (by the viewer's team) around a swing anchor, a point for ropes. It is
/// at least as wide as a fixed share of its distance from the eye, so that it is seen from afar.
void add_anchor_mark(const ArenaScene& arena_scene, const ThingPicture& thing, std::uint32_t viewer, vec3 eye,
                     std::vector<Instance>& out) {
    constexpr double round_anchor = 3.2, min_share = 0.04;
    const double radius =
        std::max(round_anchor * thing.key.size.x, min_share * glm::distance(thing.position, eye));
    out.push_back(
        {.mesh = arena_scene.teams[viewer].burst,
         .model = glm::scale(render::translated(fvec3(thing.position)), fvec3(static_cast<float>(radius))),
         .glow = 1});
}

}  // namespace

void add_contact_shades(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    for (const auto& thing : picture.things) {
        if (thing.fixed || thing.key.shape == physics::Shape::mesh) continue;
        const bool box = thing.key.shape == physics::Shape::box;
        const vec3 size = box ? thing.key.size : vec3(thing.key.size.x, thing.key.size.y, thing.key.size.x);
        // A round contact shade does not suit a long plank, which gets none.
        if (std::max(size.x, size.z) > 2) continue;
        const double height = thing.key.shape == physics::Shape::sphere ? size.x : size.y;
        add_contact_shade(arena_scene, thing.position, 1.35 * std::hypot(size.x, size.z), height, out);
    }
    for (const auto& niche : picture.niches) {
        const auto centre = niche.position + vec3(0, niche_height, 0);
        if (niche.there) add_contact_shade(arena_scene, centre, 0.4, 0.3, out);
    }
    for (const auto& p : picture.wizards) {
        if (!p.vitals.dead)
            add_contact_shade(arena_scene, p.vitals.centre, 0.85, arena_scene.wizard_height / 2, out);
    }
}

void add_casters(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& fixed,
                 std::vector<Instance>& moving) {
    fixed.push_back({.mesh = arena_scene.stone});
    for (const auto& thing : picture.things) add_thing(arena_scene, thing, thing.fixed ? fixed : moving);
    for (std::uint32_t player = 0; player < players; ++player)
        add_figure(arena_scene, player, picture.wizards[player], moving);
}

std::span<const render::Block> blocks_seen_from(const ArenaScene& arena_scene, vec3 eye) {
    const auto& shade = arena_scene.shade;
    const bool within = is_inside(shade, eye) && eye.y < shade.wall_top;
    return within ? std::span<const render::Block>(arena_scene.blocks) : std::span<const render::Block>();
}

/// Adds the stroke that a wizard draws, and the thing that a spell recalls.
void add_magic(const ArenaScene& arena_scene, std::uint32_t player, const PlayerPicture& wizard, bool own,
               std::vector<Instance>& out) {
    add_stroke_of(arena_scene, player, wizard, own, out);
    add_recall(arena_scene, player, wizard, out);
}

void add_instances(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                   std::vector<Instance>& out) {
    out.push_back({.mesh = arena_scene.stone});
    out.push_back({.mesh = arena_scene.lamps, .glow = glow_share});
    out.push_back({.mesh = arena_scene.skyline});
    if (arena_scene.bowl) {
        const auto* ground = ground_below(arena_scene, *arena_scene.bowl);
        const double height = ground == nullptr ? 0 : ground->height_at(*arena_scene.bowl);
        const fvec3 at(vec3(arena_scene.bowl->x, height, arena_scene.bowl->z));
        out.push_back({.mesh = arena_scene.runes, .model = render::translated(at), .glow = 0.35F});
    }
    const auto target = viewer < players ? picture.wizards[viewer].wand.target : Target{};
    for (const auto& thing : picture.things) {
        const auto first = out.size();
        add_thing(arena_scene, thing, out);
        if (!is_target(target, thing)) continue;
        light_up(std::span(out).subspan(first));
        if (target.kind == TargetKind::hook)
            add_anchor_mark(arena_scene, thing, viewer, picture.wizards[viewer].vitals.eye, out);
    }
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& wizard = picture.wizards[player];
        add_forces(arena_scene, wizard, player == viewer, out);
        add_magic(arena_scene, player, wizard, player == viewer, out);
        if (player == viewer && !wizard.vitals.dead) {
            add_own_arm(arena_scene, player, wizard, out);
            add_drawn_shot(arena_scene, player, wizard, out);
            add_ghost_stroke(arena_scene, picture, player, out);
            continue;
        }
        add_figure(arena_scene, player, wizard, out);
        add_glow(arena_scene, player, wizard, picture.played_s, out);
        add_shell(arena_scene, wizard, picture.played_s, out);
    }
    for (const auto& missile : picture.missiles) add_missile(arena_scene, picture, missile, viewer, out);
    for (std::uint32_t i = 0; i < picture.burst_count; ++i)
        add_burst(arena_scene, picture, picture.bursts[i], viewer, out);
    add_niches(arena_scene, picture, out);
    add_stations(arena_scene, picture, viewer, out);
}

void choose_lights(const ArenaScene& arena_scene, const Picture& picture, vec3 eye,
                   std::vector<PointLight>& out) {
    out = arena_scene.lights;
    for (const auto& m : picture.missiles)
        out.push_back({fvec3(m.position), 2.6F * team_colours(m.player % players).glow, 6});
    for (std::uint32_t i = 0; i < picture.burst_count; ++i) {
        const auto& b = picture.bursts[i];
        const auto left = static_cast<float>(std::max(0.0, 1 - b.age_s / burst_seconds));
        out.push_back({fvec3(b.place), 4.0F * left * team_colours(b.player % players).glow,
                       2.0F * static_cast<float>(b.radius)});
    }
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& p = picture.wizards[player];
        if (p.vitals.dead || p.wand.name.empty()) continue;
        const vec3 tip = p.vitals.eye + look_rotation(p.vitals.yaw, p.vitals.pitch) * wand_tip;
        const auto more = static_cast<float>(p.wand.readiness);
        out.push_back({fvec3(tip), (0.5F + 1.5F * more) * team_colours(player).glow, 2.5F + 2 * more});
    }
    // Sorts by the distance from the eye minus twice the light's radius, so near and wide lights come first.
    const auto distance = [&](const PointLight& l) {
        return glm::length(l.position - fvec3(eye)) - 2 * l.radius;
    };
    std::sort(out.begin(), out.end(),
              [&](const PointLight& a, const PointLight& b) { return distance(a) < distance(b); });
    if (out.size() > render::max_lights) out.resize(render::max_lights);
}

}  // namespace thaum::game::inline scene
