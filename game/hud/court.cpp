#include "game/hud/court.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/hud/figures.h"
#include "game/hud/furniture.h"

namespace thaum::game {
namespace {

using render::colour;
using render::Instance;
using render::MeshData;
using render::PointLight;

constexpr int embers = 28, bubbles = 9;
constexpr double shadow_reach = 4;  // m above the ground, where it is gone

// Making ---------------------------------------------------------------------------------------------------------------

std::optional<render::MeshId> upload(render::Renderer& renderer, const MeshData& mesh) {
    if (mesh.indices.empty()) return {};
    return renderer.upload(mesh);
}

Court::Meshes upload(render::Renderer& renderer, const FurnitureMesh& mesh) {
    return {upload(renderer, mesh.lit), upload(renderer, mesh.glowing)};
}

ShapeKey key_of(const Thing& thing) {
    return {thing.surface, thing.body.shape, thing.body.mesh, thing.body.size};
}

/// What never moves and is made of stone.
bool is_masonry(const Thing& thing) {
    return !thing.prop && thing.body.shape == physics::Shape::box && thing.surface != Surface::crystal;
}

Court::Solid make_solid(render::Renderer& renderer, const Shade& shade, const Arena& arena,
                        const Thing& thing) {
    Court::Solid solid{key_of(thing), thing.position, {}};
    if (thing.surface == Surface::bowl) {
        solid.meshes = upload(renderer, cauldron(arena.meshes[thing.body.mesh]));
    } else if (thing.body.shape == physics::Shape::mesh) {
        solid.meshes.lit = upload(renderer, masonry_ramp(shade, thing, arena.meshes[thing.body.mesh]));
    } else if (is_masonry(thing)) {
        solid.meshes.lit = upload(renderer, masonry_box(shade, thing));
    } else {
        auto mesh = furniture(solid.key);
        bake(shade, thing.position, mesh.lit);
        solid.meshes = upload(renderer, mesh);
    }
    return solid;
}

void add_kind(render::Renderer& renderer, const ShapeKey& key, Court& court) {
    const auto known = [&](const Court::Kind& kind) { return kind.key == key; };
    if (std::none_of(court.kinds.begin(), court.kinds.end(), known))
        court.kinds.push_back({key, upload(renderer, furniture(key))});
}

Court::Team make_team(render::Renderer& renderer, std::uint32_t team) {
    return {.figure = renderer.upload(wizard_figure(team)),
            .fallen = renderer.upload(fallen_wizard(team)),
            .arm = renderer.upload(wizard_arm(team)),
            .own_arm = renderer.upload(own_arm(team)),
            .spark = renderer.upload(wand_spark(team)),
            .bolt = renderer.upload(bolt_needle(team)),
            .shield = renderer.upload(shield_rings(team)),
            .plate = upload(renderer, start_plate(team))};
}

/// What stands there gives light of its own.
void add_light_of(const Thing& thing, Court& court) {
    const fvec3 at(thing.position);
    if (thing.surface == Surface::bowl) {
        court.bowl = thing.position;
        court.lights.insert(court.lights.begin(), {at + fvec3(0, 1.6F, 0), 4.4F * colour(0xFF8C3C), 24});
    }
    if (thing.surface == Surface::orb)
        court.lights.push_back({at + fvec3(0.8F, 0.2F, 0), 2.2F * colour(0x8A6AFF), 8});
    if (thing.surface == Surface::crystal)
        court.lights.push_back({at + fvec3(0, 0.6F, 0), 1.8F * colour(0x50D0F0), 7});
}

render::Environment dusk() {
    render::Environment e;
    // Walls of 12 m keep the low sun out of the court: where it does come in is baked into the stones. What is left is a
    // soft rim on whoever turns to it.
    e.sun.colour *= 0.22F;
    e.sky.zenith = colour(0x2A1E58);
    e.sky.horizon = colour(0xA0608C);
    e.sky.sun_glow = 1.3F * colour(0xE07A40);
    e.fog.colour = colour(0x5A4274);
    e.fog.density = 0.0105F;
    e.ambient.above = 1.0F * colour(0x8A80C8);
    e.ambient.below = 0.9F * colour(0x5A4252);
    return e;
}

}  // namespace

Court make_court(render::Renderer& renderer, const Arena& arena, const WizardRules& rules) {
    Court court;
    court.environment = dusk();
    court.wizard_height = rules.height;
    const auto shade = make_shade(arena, court.environment.sun.direction);
    for (const auto& thing : arena.things) {
        if (thing.prop)
            add_kind(renderer, key_of(thing), court);
        else
            court.solids.push_back(make_solid(renderer, shade, arena, thing));
        add_light_of(thing, court);
        const bool ground = thing.surface == Surface::floor || thing.surface == Surface::pit;
        if (ground && thing.body.shape == physics::Shape::box)
            court.grounds.push_back({thing.position - thing.body.size, thing.position + thing.body.size});
    }
    for (std::uint32_t team = 0; team < players; ++team) court.teams[team] = make_team(renderer, team);
    court.power_ups = make_power_up_meshes(renderer);
    court.anchor = upload(renderer, anchor());
    court.neutral_plate = upload(renderer, start_plate(no_player));
    court.decoration = {upload(renderer, decoration(shade)), upload(renderer, lamps(shade))};
    court.runes = renderer.upload(rune_circle(2.1F));
    court.bubble = renderer.upload(render::sphere(1, 8, colour(0xFFB048)));
    court.ember = renderer.upload(render::sphere(1, 5, colour(0xFFA040)));
    court.shadow = renderer.upload(shadow_spot(0.30F * colour(0x666A7C), 0.96F * colour(0x6A6C80)));
    const fvec3 grey = colour(0x807890);
    court.unit_shapes = {renderer.upload(render::box(fvec3(1), grey, 0.06F)),
                         renderer.upload(render::sphere(1, 14, grey)),
                         renderer.upload(render::capsule(0.5F, 1, 12, grey)),
                         renderer.upload(render::cylinder(1, 2, 16, grey))};
    return court;
}

// Showing --------------------------------------------------------------------------------------------------------------

namespace {

fmat4 placed(vec3 position, quat orientation) {
    fmat4 m = glm::mat4_cast(fquat(orientation));
    m[3] = fvec4(fvec3(position), 1);
    return m;
}

void add(const Court::Meshes& meshes, const fmat4& model, std::vector<Instance>& out) {
    if (meshes.lit) out.push_back({.mesh = *meshes.lit, .model = model});
    if (meshes.glowing) out.push_back({.mesh = *meshes.glowing, .model = model, .glow = 0.85F});
}

const Court::Meshes* find_meshes(const Court& court, const ThingPicture& thing) {
    for (const auto& solid : court.solids) {
        if (thing.fixed && solid.key == thing.key && solid.position == thing.position) return &solid.meshes;
    }
    for (const auto& kind : court.kinds) {
        if (kind.key == thing.key) return &kind.meshes;
    }
    return nullptr;
}

/// A thing that the arena does not have, such as a scenario's: its bare shape.
void add_unknown(const Court& court, const ThingPicture& thing, std::vector<Instance>& out) {
    const auto shape = static_cast<std::size_t>(thing.key.shape);
    if (shape >= court.unit_shapes.size()) return;
    const fvec3 size(thing.key.size);
    const bool round = thing.key.shape == physics::Shape::sphere;
    const fvec3 scale = thing.key.shape == physics::Shape::box ? size
                        : round                                ? fvec3(size.x)
                                                               : fvec3(size.x, size.y, size.x);
    out.push_back({.mesh = court.unit_shapes[shape],
                   .model = glm::scale(placed(thing.position, thing.orientation), scale)});
}

/// The ground below, where there is any near.
std::optional<double> ground_below(const Court& court, vec3 at) {
    std::optional<double> best;
    for (const auto& g : court.grounds) {
        const bool over = at.x > g.low.x && at.x < g.high.x && at.z > g.low.z && at.z < g.high.z;
        if (over && g.high.y <= at.y + 0.1 && (!best || g.high.y > *best)) best = g.high.y;
    }
    return best;
}

void add_shadow(const Court& court, vec3 centre, double radius, double half_height,
                std::vector<Instance>& out) {
    const auto ground = ground_below(court, centre - vec3(0, 0.9 * half_height, 0));
    if (!ground) return;
    const double above = std::max(0.0, centre.y - half_height - *ground);
    if (above > shadow_reach) return;
    const auto size = static_cast<float>(radius * (1 - above / shadow_reach));
    fmat4 m = render::translated(fvec3(vec3(centre.x, *ground + 0.008, centre.z)));
    out.push_back({.mesh = court.shadow, .model = glm::scale(m, fvec3(size, 1, size))});
}

void add_thing(const Court& court, const ThingPicture& thing, std::vector<Instance>& out) {
    const auto model = placed(thing.position, thing.orientation);
    if (thing.key.surface == Surface::pad)
        return add(thing.team < players ? court.teams[thing.team].plate : court.neutral_plate, model, out);
    if (thing.key.surface == Surface::anchor)
        return add(court.anchor, glm::scale(model, fvec3(fvec3(thing.key.size).x)), out);
    if (const auto* meshes = find_meshes(court, thing))
        add(*meshes, model, out);
    else
        add_unknown(court, thing, out);
}

fmat4 turned(double yaw, double pitch) { return glm::mat4_cast(fquat(look_rotation(yaw, pitch))); }

void add_wizard(const Court& court, std::uint32_t number, const PlayerPicture& p, double time,
                std::vector<Instance>& out) {
    const auto& team = court.teams[number];
    const fvec3 feet(p.centre - vec3(0, court.wizard_height / 2, 0));
    const auto standing = render::translated(feet) * turned(p.yaw, 0);
    if (p.dead) {
        out.push_back({.mesh = team.fallen, .model = standing});
        return;
    }
    out.push_back({.mesh = team.figure, .model = standing});
    const auto arm = render::translated(fvec3(p.eye)) * turned(p.yaw, 0) * render::translated(shoulder) *
                     turned(0, p.pitch);
    out.push_back({.mesh = team.arm, .model = arm});
    if (!p.wand.empty())
        out.push_back(
            {.mesh = team.spark, .model = arm * render::translated(fvec3(wand_tip) - shoulder), .glow = 1});
    if (p.shielded) {
        const auto slowly = turned(0.8 * time, 0);
        out.push_back(
            {.mesh = team.shield, .model = render::translated(fvec3(p.centre)) * slowly, .glow = 0.9F});
    }
}

void add_own_arm(const Court& court, std::uint32_t number, const PlayerPicture& p,
                 std::vector<Instance>& out) {
    if (p.dead) return;
    const auto eye = render::translated(fvec3(p.eye)) * turned(p.yaw, p.pitch);
    out.push_back({.mesh = court.teams[number].own_arm, .model = eye});
    if (!p.wand.empty())
        out.push_back({.mesh = court.teams[number].spark,
                       .model = eye * render::translated(fvec3(wand_tip)),
                       .glow = 1});
}

/// Turns -z into the direction of flight.
fmat4 flying(const MissilePicture& missile) {
    const vec3 v = missile.velocity;
    const double flat = std::hypot(v.x, v.z);
    return render::translated(fvec3(missile.position)) *
           turned(std::atan2(-v.x, -v.z), std::atan2(v.y, flat));
}

/// What one has just shot oneself would fill the view, so it grows on its way.
float size_of(const Picture& picture, const MissilePicture& missile, std::uint32_t viewer) {
    if (missile.player != viewer || viewer >= players) return 1;
    const double distance = glm::length(missile.position - picture.wizards[viewer].eye);
    return static_cast<float>(std::clamp(distance / 6, 0.2, 1.0));
}

/// Sparks that rise from the brew, each on a way of its own.
void add_embers(const Court& court, double time, std::vector<Instance>& out) {
    if (!court.bowl) return;
    for (int i = 0; i < embers; ++i) {
        const double number = i;
        const double life = time * (0.10 + 0.013 * (i % 7)) + number * 0.618;
        const double age = life - std::floor(life);
        const double angle = number * 2.4 + 1.6 * age;
        const double radius = (0.25 + 0.8 * std::fmod(number * 0.37, 1.0)) * (1 + 0.9 * age);
        const vec3 at =
            *court.bowl + vec3(radius * std::cos(angle), 0.4 + 5.5 * age, radius * std::sin(angle));
        const auto size = static_cast<float>(0.035 * std::sin(pi * age) * (0.6 + 0.1 * (i % 5)));
        out.push_back({.mesh = court.ember,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(std::max(size, 1e-4F))),
                       .glow = 1});
    }
}

/// Bubbles that swell in the brew and sink again, each at its own place and time.
void add_bubbles(const Court& court, double time, std::vector<Instance>& out) {
    if (!court.bowl) return;
    for (int i = 0; i < bubbles; ++i) {
        const double life = time * (0.35 + 0.05 * (i % 4)) + i * 0.381;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 3 * round),
                     radius = 0.25 + 0.75 * std::fmod(0.618 * (i + round), 1.0);
        const vec3 at =
            *court.bowl + vec3(radius * std::cos(angle), 0.62 - 0.06 * radius, radius * std::sin(angle));
        const auto size = static_cast<float>(0.02 + 0.13 * std::sin(pi * age));
        out.push_back({.mesh = court.bubble,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(size)),
                       .glow = 1});
    }
}

void add_shadows(const Court& court, const Picture& picture, std::vector<Instance>& out) {
    for (const auto& thing : picture.things) {
        if (thing.fixed || thing.key.shape == physics::Shape::mesh) continue;
        const bool box = thing.key.shape == physics::Shape::box;
        const vec3 size = box ? thing.key.size : vec3(thing.key.size.x, thing.key.size.y, thing.key.size.x);
        // A long plank is no disc.
        if (std::max(size.x, size.z) > 2) continue;
        const double height = thing.key.shape == physics::Shape::sphere ? size.x : size.y;
        add_shadow(court, thing.position, 1.35 * std::hypot(size.x, size.z), height, out);
    }
    for (const auto& p : picture.wizards) {
        if (!p.dead) add_shadow(court, p.centre, 0.8, court.wizard_height / 2, out);
    }
}

}  // namespace

void add_instances(const Court& court, const Picture& picture, std::uint32_t viewer,
                   std::vector<Instance>& out) {
    add(court.decoration, fmat4(1), out);
    if (court.bowl) {
        const auto ground = ground_below(court, *court.bowl);
        const fvec3 at(vec3(court.bowl->x, ground.value_or(0), court.bowl->z));
        out.push_back({.mesh = court.runes, .model = render::translated(at), .glow = 0.35F});
    }
    for (const auto& thing : picture.things) add_thing(court, thing, out);
    add_shadows(court, picture, out);
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& wizard = picture.wizards[player];
        if (player != viewer || wizard.dead)
            add_wizard(court, player, wizard, picture.played_s, out);
        else
            add_own_arm(court, player, wizard, out);
    }
    for (const auto& missile : picture.missiles) {
        const fvec3 size(size_of(picture, missile, viewer));
        const auto mesh = court.teams[missile.player % players].bolt;
        out.push_back({.mesh = mesh, .model = glm::scale(flying(missile), size), .glow = 1});
    }
    add_embers(court, picture.played_s, out);
    add_bubbles(court, picture.played_s, out);
}

void choose_lights(const Court& court, const Picture& picture, vec3 eye, std::vector<PointLight>& out) {
    out = court.lights;
    for (const auto& m : picture.missiles)
        out.push_back({fvec3(m.position), 2.6F * team_colours(m.player % players).glow, 6});
    // How far beyond its own reach the viewer is: what is near and wide comes first.
    const auto distance = [&](const PointLight& l) {
        return glm::length(l.position - fvec3(eye)) - 2 * l.radius;
    };
    std::sort(out.begin(), out.end(),
              [&](const PointLight& a, const PointLight& b) { return distance(a) < distance(b); });
    if (out.size() > render::max_lights) out.resize(render::max_lights);
}

}  // namespace thaum::game
