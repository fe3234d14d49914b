#include "game/hud/arena_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "game/hud/figures.h"
#include "game/hud/furniture.h"

namespace thaum::game {
namespace {

using render::colour;
using render::Instance;
using render::MeshData;
using render::PointLight;

constexpr double least_share = 0.02;    ///< share of the strongest force; smaller forces are not drawn
constexpr double ribbon_length = 0.25;  ///< length of the ribbon at the strongest force (m)
constexpr int embers = 36, bubbles = 14;
/// Number of steam wisps: over a pure brew, and over the lightest brew.
constexpr double wisps_least = 9, wisps_most = 26;
constexpr float glow_share = 0.85F;  // glow of surfaces that shine and are lit as well
constexpr float brew_glow = 1.7F;    // brightness of the brew, the brightest thing in the arena
constexpr double shade_reach = 2.5;  // height above the ground at which contact shade ends (m)

// Making ----------------------------------------------------------------------------------------------------

std::optional<render::MeshId> upload(render::Renderer& renderer, const MeshData& mesh) {
    if (mesh.indices.empty()) return {};
    return renderer.upload_with_copies(mesh);
}

ArenaScene::Meshes upload(render::Renderer& renderer, const FurnitureMesh& mesh) {
    return {.lit = upload(renderer, mesh.lit), .glowing = upload(renderer, mesh.glowing)};
}

ShapeKey key_of(const Thing& thing) {
    return {thing.surface, thing.body.shape, thing.body.mesh, thing.body.size};
}

/// True for a stone thing that never moves.
bool is_masonry(const Thing& thing) {
    return !thing.prop && thing.body.shape == physics::Shape::box && thing.surface != Surface::crystal;
}

/// Makes the meshes of a fixed thing. Masonry goes into `stone` instead.
ArenaScene::Solid make_solid(render::Renderer& renderer, const Shade& shade, const Arena& arena,
                             const Thing& thing, render::Patchwork& stone) {
    ArenaScene::Solid solid{key_of(thing), thing.position, {}};
    if (thing.surface == Surface::bowl) {
        solid.meshes.lit = upload(renderer, cauldron(arena.meshes[thing.body.mesh]).lit);
    } else if (thing.body.shape == physics::Shape::mesh) {
        add_masonry_ramp(shade, thing, arena.meshes[thing.body.mesh], stone);
    } else if (is_masonry(thing)) {
        add_masonry_box(shade, thing, stone);
    } else {
        auto mesh = furniture(solid.key);
        bake(shade, thing.position, mesh.lit);
        solid.meshes = upload(renderer, mesh);
    }
    return solid;
}

void add_kind(render::Renderer& renderer, const ShapeKey& key, ArenaScene& arena_scene) {
    const auto known = [&](const ArenaScene::Kind& kind) { return kind.key == key; };
    if (std::none_of(arena_scene.kinds.begin(), arena_scene.kinds.end(), known))
        arena_scene.kinds.push_back({key, upload(renderer, furniture(key))});
}

ArenaScene::Team make_team(render::Renderer& renderer, const Presentation& shown, std::uint32_t team) {
    std::vector<render::MeshId> missiles;
    for (const auto& wand : shown.wands)
        missiles.push_back(renderer.upload_with_copies(missile_mesh(wand.look, team)));
    return {.figure = renderer.upload_with_copies(wizard_figure(team)),
            .fallen = renderer.upload_with_copies(fallen_wizard(team)),
            .arm = renderer.upload_with_copies(wizard_arm(team)),
            .own_arm = renderer.upload_with_copies(own_arm(team)),
            .spark = renderer.upload_with_copies(wand_spark(team)),
            .burst = renderer.upload_with_copies(burst_shell(team)),
            .shield = renderer.upload_with_copies(shield_rings(team)),
            .missiles = std::move(missiles),
            .plate = upload(renderer, start_plate(team))};
}

/// The top of a box, or the slope through the highest vertices of a ramp.
ArenaScene::Ground ground_of(const Thing& thing, const Arena& arena) {
    if (thing.body.shape != physics::Shape::mesh) {
        const auto high = thing.position + thing.body.size;
        return {thing.position - thing.body.size, high, high.y, 0, 0};
    }
    vec3 half(0), top(0);
    for (const auto& v : arena.meshes[thing.body.mesh].vertices) half = glm::max(half, glm::abs(v));
    for (const auto& v : arena.meshes[thing.body.mesh].vertices) {
        if (v.y > 0.9 * half.y) top += v;
    }
    const bool along_x = std::abs(top.x) > std::abs(top.z);
    const double rise = half.y / (along_x ? half.x : half.z);
    return {thing.position - half, thing.position + half, thing.position.y,
            along_x ? std::copysign(rise, top.x) : 0, along_x ? 0 : std::copysign(rise, top.z)};
}

/// Adds the block with which a fixed box hides things. It is a little smaller than the masonry, whose blocks
/// are bevelled and sunk. At the border of the arena it is endless, since a viewer inside sees only stone
/// there. So one block covers a cell of the sky over a corner of two walls, or over the foot of a wall.
void add_block(const Thing& thing, ArenaScene& arena_scene) {
    constexpr double less = 0.12, endless = 1000;  // m
    const vec3 half = thing.body.size - less;
    if (glm::any(glm::lessThanEqual(half, vec3(0)))) return;
    render::Block block{thing.position - half, thing.position + half};
    const double end = arena_scene.shade.half - 2 * less;
    bool beyond = false;
    for (const int axis : {0, 2}) {
        beyond = beyond || block.low[axis] > end || block.high[axis] < -end;
        if (block.low[axis] <= -end) block.low[axis] = -endless;
        if (block.high[axis] >= end) block.high[axis] = endless;
    }
    if (beyond) block.low.y = -endless;
    arena_scene.blocks.push_back(block);
}

/// Adds the light of a thing that gives light.
void add_light_of(const Thing& thing, ArenaScene& arena_scene) {
    const fvec3 at(thing.position);
    if (thing.surface == Surface::bowl) {
        arena_scene.bowl = thing.position;
        arena_scene.lights.insert(arena_scene.lights.begin(),
                                  {at + fvec3(0, 1.5F, 0), 5.0F * colour(0xFF8C3C), 22});
    }
    if (thing.surface == Surface::orb)
        arena_scene.lights.push_back({at + fvec3(0.8F, 0.2F, 0), 2.2F * colour(0x8A6AFF), 8});
    if (thing.surface == Surface::crystal)
        arena_scene.lights.push_back({at + fvec3(0, 0.6F, 0), 1.8F * colour(0x50D0F0), 7});
}

render::Environment dusk() {
    render::Environment e;
    // The sun is so low that the wall of 12 m shades the eastern half. The cauldron stands just inside the
    // shade, and both players start in the light.
    e.sun.direction = glm::normalize(fvec3(0.86F, 0.50F, 0.16F));
    e.sun.colour = 2.5F * colour(0xFFAE6C);
    e.sky.zenith = colour(0x2A1E58);
    e.sky.horizon = colour(0xA0608C);
    e.sky.sun_glow = 1.3F * colour(0xE07A40);
    e.fog.colour = colour(0x5A4274);
    e.fog.density = 0.0105F;
    e.ambient.above = 0.85F * colour(0x8078CC);
    e.ambient.below = 0.8F * colour(0x5C4254);
    return e;
}

}  // namespace

double ArenaScene::Ground::height_at(vec3 p) const {
    return height + slope_x * (p.x - (low.x + high.x) / 2) + slope_z * (p.z - (low.z + high.z) / 2);
}

ArenaScene make_arena_scene(render::Renderer& renderer, const MatchData& data) {
    const auto& arena = data.arena;
    ArenaScene arena_scene;
    if (data.cauldron) {
        arena_scene.brew =
            std::make_shared<BrewLook>(make_brew_look(renderer, brew_place(*arena.bowl, *data.cauldron)));
    }
    arena_scene.environment = dusk();
    arena_scene.wizard_height = data.wizard.height;
    arena_scene.shade = make_shade(arena, arena_scene.environment.sun.direction);
    const auto& shade = arena_scene.shade;
    render::Patchwork stone;
    for (const auto& thing : arena.things) {
        if (thing.prop)
            add_kind(renderer, key_of(thing), arena_scene);
        else
            arena_scene.solids.push_back(make_solid(renderer, shade, arena, thing, stone));
        if (thing.surface == Surface::bowl && thing.body.shape == physics::Shape::mesh)
            arena_scene.painted_brew = upload(renderer, cauldron(arena.meshes[thing.body.mesh]).glowing);
        add_light_of(thing, arena_scene);
        if (is_masonry(thing)) add_block(thing, arena_scene);
        if (thing.surface == Surface::floor || thing.surface == Surface::pit)
            arena_scene.grounds.push_back(ground_of(thing, arena));
    }
    for (std::uint32_t team = 0; team < players; ++team)
        arena_scene.teams[team] = make_team(renderer, *data.presentation, team);
    arena_scene.power_ups = make_power_up_meshes(renderer);
    arena_scene.anchor = upload(renderer, anchor());
    arena_scene.neutral_plate = upload(renderer, start_plate(no_player));
    add_decoration(shade, stone);
    arena_scene.stone = renderer.upload(stone);
    arena_scene.lamps = renderer.upload(lamps(shade));
    arena_scene.skyline = renderer.upload(skyline());
    for (const auto& wand : data.presentation->wands)
        arena_scene.wands.push_back(renderer.upload_with_copies(wand_mesh(wand.look)));
    arena_scene.runes = renderer.upload_with_copies(rune_circle(2.1F));
    arena_scene.bubble = renderer.upload_with_copies(render::sphere(1, 8, colour(0xFFB048)));
    arena_scene.beam = renderer.upload_with_copies(beam_of_light());
    arena_scene.bead = renderer.upload_with_copies(render::sphere(1, 8, fvec3(1)));
    arena_scene.ember = renderer.upload_with_copies(render::sphere(1, 5, colour(0xFFA040)));
    arena_scene.contact = renderer.upload_with_copies(contact_shade(0.42F));
    const fvec3 grey = colour(0x807890);
    arena_scene.unit_shapes = {renderer.upload_with_copies(render::box(fvec3(1), grey, 0.06F)),
                               renderer.upload_with_copies(render::sphere(1, 14, grey)),
                               renderer.upload_with_copies(render::capsule(0.5F, 1, 12, grey)),
                               renderer.upload_with_copies(render::cylinder(1, 2, 16, grey))};
    return arena_scene;
}

// Showing ---------------------------------------------------------------------------------------------------

namespace {

fmat4 placed(vec3 position, quat orientation) {
    fmat4 m = glm::mat4_cast(fquat(orientation));
    m[3] = fvec4(fvec3(position), 1);
    return m;
}

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

/// Adds a thing that the arena does not have, such as one of a scenario, by its bare shape.
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

/// Returns the highest ground below a place, or null.
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

/// True if the ground's plane lies under the whole rim, so that no shade hangs over an edge.
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

/// Sets whether the sun reaches each instance, for pictures without a shadow map. Fixed things have baked
/// light instead.
void set_sun(const ArenaScene& arena_scene, vec3 at, std::span<Instance> of) {
    const float sun = sees_sun(arena_scene.shade, at) ? 1.0F : 0.0F;
    for (auto& instance : of) instance.sun = sun;
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
    // The test point lies 0.1 m up, since a flat thing lies inside the ground block.
    set_sun(arena_scene, thing.position + vec3(0, 0.1, 0), std::span(out).subspan(first));
}

fmat4 turned(double yaw, double pitch) { return glm::mat4_cast(fquat(look_rotation(yaw, pitch))); }

/// Rotation of the wand and the hand about the wand's tip, as the stylus turns them (eye frame). The angle is
/// limited, because the hand would leave the arm at larger angles.
fmat4 stylus_turned(const PlayerPicture& p) {
    constexpr double most = 0.7;  // rad
    const vec3 by = limited(p.wand_turn, most);
    const double angle = glm::length(by);
    if (!(angle > 1e-6)) return fmat4(1);
    return render::translated(fvec3(wand_tip)) * glm::mat4_cast(fquat(rotation(by / angle, angle))) *
           render::translated(-fvec3(wand_tip));
}

/// Adds body, arm and wand, as the other player sees them and as they cast shadows.
void add_figure(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                std::vector<Instance>& out) {
    const auto& team = arena_scene.teams[number];
    const auto first = out.size();
    const fvec3 feet(p.centre - vec3(0, arena_scene.wizard_height / 2, 0));
    const auto standing = render::translated(feet) * turned(p.yaw, 0);
    out.push_back({.mesh = p.dead ? team.fallen : team.figure, .model = standing});
    if (!p.dead) {
        const auto arm = render::translated(fvec3(p.eye)) * turned(p.yaw, 0) * render::translated(shoulder) *
                         turned(0, p.pitch);
        out.push_back({.mesh = team.arm, .model = arm});
        if (!p.wand.empty() && !p.stirs)
            out.push_back({.mesh = arena_scene.wands[p.wand_number],
                           .model = arm * render::translated(-shoulder) * stylus_turned(p) * wand_in_hand()});
    }
    set_sun(arena_scene, p.centre, std::span(out).subspan(first));
}

/// The glow at a wand's tip. It grows with the wand's charge.
Instance spark_at(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                  const fmat4& tip) {
    const auto size = static_cast<float>(1 + 3.5 * p.readiness);
    return {.mesh = arena_scene.teams[number].spark, .model = glm::scale(tip, fvec3(size)), .glow = 1};
}

/// Adds the glowing parts of a wizard: the wand's tip and the shield.
void add_glow(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p, double time,
              std::vector<Instance>& out) {
    if (p.dead) return;
    const auto& team = arena_scene.teams[number];
    const auto arm = render::translated(fvec3(p.eye)) * turned(p.yaw, 0) * render::translated(shoulder) *
                     turned(0, p.pitch);
    if (!p.wand.empty())
        out.push_back(spark_at(arena_scene, number, p, arm * render::translated(fvec3(wand_tip) - shoulder)));
    if (p.shielded) {
        const auto slowly = turned(0.8 * time, 0);
        out.push_back(
            {.mesh = team.shield, .model = render::translated(fvec3(p.centre)) * slowly, .glow = 0.9F});
    }
}

void add_own_arm(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                 std::vector<Instance>& out) {
    // Greatest shown reach (m); beyond it hand and wand would leave the picture.
    constexpr double most_reach = 0.22;
    const auto first = out.size();
    const auto eye = render::translated(fvec3(p.eye)) * turned(p.yaw, p.pitch) *
                     render::translated(fvec3(limited(p.wand_reach, most_reach))) * stylus_turned(p);
    if (p.stirs) return;  // the view of a player who stirs shows only the ladle
    out.push_back({.mesh = arena_scene.teams[number].own_arm, .model = eye});
    if (!p.wand.empty()) {
        out.push_back({.mesh = arena_scene.wands[p.wand_number], .model = eye * wand_in_own_hand()});
        out.push_back(spark_at(arena_scene, number, p, eye * render::translated(fvec3(wand_tip))));
    }
    set_sun(arena_scene, p.eye, std::span(out).subspan(first));
}

void add_beam(const ArenaScene& arena_scene, vec3 from, vec3 to, double thick, fvec3 tint,
              std::vector<Instance>& out) {
    const vec3 way = to - from;
    const double length = glm::length(way);
    if (length < 1e-6) return;
    const auto yaw = std::atan2(-way.x, -way.z), pitch = std::atan2(way.y, std::hypot(way.x, way.z));
    const fvec3 size(vec3(thick, thick, length));
    out.push_back({.mesh = arena_scene.beam,
                   .model = glm::scale(render::translated(fvec3(from)) * turned(yaw, pitch), size),
                   .tint = tint,
                   .glow = 0.7F});
}

/// Adds the spring from the wand to a held object. In a player's own view it also adds the force on the hand,
/// at the wand's tip.
void add_forces(const ArenaScene& arena_scene, const PlayerPicture& p, bool own, std::vector<Instance>& out) {
    if (p.dead) return;
    const auto looking = look_rotation(p.yaw, p.pitch);
    const vec3 tip = p.eye + looking * (wand_tip + (own ? p.wand_reach : vec3(0)));
    const double share = p.force.cap > 0 ? glm::length(p.force.now) / p.force.cap : 0;
    const fvec3 shown = force_colour(share),
                tint = shown * shown;  // converts screen colours to linear light
    if (p.held) add_beam(arena_scene, tip, *p.held, 0.012, tint, out);
    if (!own || share < least_share) return;
    add_beam(arena_scene, tip, tip + looking * p.force.now / p.force.cap * ribbon_length, 0.006, tint, out);
    out.push_back({.mesh = arena_scene.bead,
                   .model = glm::scale(render::translated(fvec3(tip)), fvec3(0.02F)),
                   .tint = tint,
                   .glow = 0.7F});
}

/// Places a missile and turns -z into its direction of flight.
fmat4 flying(const MissilePicture& missile) {
    const vec3 v = missile.velocity;
    const double flat = std::hypot(v.x, v.z);
    return render::translated(fvec3(missile.position)) *
           turned(std::atan2(-v.x, -v.z), std::atan2(v.y, flat));
}

/// Scale of a missile. A missile of the viewer starts small and grows, because at full size it would fill the
/// view.
float size_of(const Picture& picture, const MissilePicture& missile, std::uint32_t viewer) {
    if (missile.player != viewer || viewer >= players) return 1;
    const double distance = glm::length(missile.position - picture.wizards[viewer].eye);
    return static_cast<float>(std::clamp(distance / 6, 0.2, 1.0));
}

void add_missile(const ArenaScene& arena_scene, const Picture& picture, const MissilePicture& missile,
                 std::uint32_t viewer, std::vector<Instance>& out) {
    const auto& team = arena_scene.teams[missile.player % players];
    const float scale = missile.size > 0 ? static_cast<float>(missile.size) : 1.0F;
    const float size = size_of(picture, missile, viewer) * scale;
    out.push_back(
        {.mesh = team.missiles[missile.wand], .model = glm::scale(flying(missile), fvec3(size)), .glow = 1});
}

/// Adds a small core that fades and a shell that flies as far as the burst reaches. Neither ever fills a
/// view. The core is limited to a share of the view, and the shell is hidden once it has passed the eye.
void add_burst(const ArenaScene& arena_scene, const Picture& picture, const BurstPicture& burst,
               std::uint32_t viewer, std::vector<Instance>& out) {
    constexpr double most_of_view = 0.15;  // largest core radius as a share of the distance
    constexpr double past_the_eye = 1.25;  // margin of the shell radius for its thick bars
    const auto& team = arena_scene.teams[burst.player % players];
    const auto age = static_cast<float>(std::clamp(burst.age_s / burst_seconds, 0.0, 1.0));
    const auto radius = static_cast<float>(burst.radius);
    const auto at = render::translated(fvec3(burst.place));
    const float shell = radius * (0.15F + 0.85F * std::sqrt(age)), core = 0.2F * radius * (1 - age);
    const double distance = viewer < players ? glm::distance(burst.place, picture.wizards[viewer].eye) : 100;
    const float shown = std::min(core, static_cast<float>(most_of_view * distance));
    if (distance > past_the_eye * double{shell})
        out.push_back({.mesh = team.burst,
                       .model = glm::scale(at, fvec3(shell)),
                       .tint = fvec3(1 - 0.8F * age),
                       .glow = 1});
    if (shown > 0)
        out.push_back({.mesh = arena_scene.ember, .model = glm::scale(at, fvec3(shown)), .glow = 1});
}

void add_painted_brew(const ArenaScene& arena_scene, std::vector<Instance>& out) {
    if (!arena_scene.bowl || !arena_scene.painted_brew) return;
    out.push_back({.mesh = *arena_scene.painted_brew,
                   .model = render::translated(fvec3(*arena_scene.bowl)),
                   .tint = fvec3(brew_glow),
                   .glow = glow_share});
}

/// Distance beyond which a brew at rest looks like the painted one (m).
constexpr double brew_seen_from = 14;

bool is_near_brew(const ArenaScene& arena_scene, vec3 eye) {
    return glm::distance(eye, arena_scene.brew->place.middle) < brew_seen_from;
}

/// True if the viewer sees the simulated brew and not the painted one. The empty arena behind a menu is seen
/// from afar.
bool sees_brew(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer) {
    return viewer < players && visible_brew(arena_scene, picture, picture.wizards[viewer].eye) != nullptr;
}

void add_brew_of(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                 std::vector<Instance>& out) {
    if (!sees_brew(arena_scene, picture, viewer)) return add_painted_brew(arena_scene, out);
    add_brew(*arena_scene.brew, out);
    for (const auto& ladle : picture.cauldron.ladles) {
        if (ladle) add_ladle(arena_scene.brew->meshes, *ladle, out);
    }
}

void add_niches(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    constexpr float height = 0.5F, size = 0.14F;
    for (const auto& niche : picture.niches) {
        const auto at = render::translated(fvec3(niche.position));
        out.push_back({.mesh = arena_scene.contact, .model = glm::scale(at, fvec3(0.4F, 1, 0.4F))});
        if (!niche.there) continue;
        for (const fvec3 off : {fvec3(0, 0, 0), fvec3(0.16F, -0.08F, 0.05F), fvec3(-0.12F, -0.07F, 0.12F)})
            out.push_back(
                {.mesh = arena_scene.bead,
                 .model = glm::scale(at * render::translated(off + fvec3(0, height, 0)), fvec3(size)),
                 .tint = niche.colour,
                 .glow = 0.55F});
    }
}

/// Adds sparks that rise from the brew, each on its own path.
void add_embers(const ArenaScene& arena_scene, double time, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    for (int i = 0; i < embers; ++i) {
        const double number = i;
        const double life = time * (0.10 + 0.013 * (i % 7)) + number * 0.618;
        const double age = life - std::floor(life);
        const double angle = number * 2.4 + 1.6 * age;
        const double radius = (0.25 + 0.8 * std::fmod(number * 0.37, 1.0)) * (1 + 0.9 * age);
        const vec3 at =
            *arena_scene.bowl + vec3(radius * std::cos(angle), 0.4 + 5.5 * age, radius * std::sin(angle));
        const auto size = static_cast<float>(0.035 * std::sin(pi * age) * (0.6 + 0.1 * (i % 5)));
        out.push_back({.mesh = arena_scene.ember,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(std::max(size, 1e-4F))),
                       .glow = 1});
    }
}

/// Adds bubbles that swell and sink in the brew, each at its own place and time.
void add_bubbles(const ArenaScene& arena_scene, double time, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    for (int i = 0; i < bubbles; ++i) {
        const double life = time * (0.35 + 0.05 * (i % 4)) + i * 0.381;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 3 * round),
                     radius = 0.25 + 0.75 * std::fmod(0.618 * (i + round), 1.0);
        const vec3 at = *arena_scene.bowl + vec3(radius * std::cos(angle), 0.72 - 0.10 * radius * radius,
                                                 radius * std::sin(angle));
        const auto size = static_cast<float>(0.02 + 0.13 * std::sin(pi * age));
        out.push_back({.mesh = arena_scene.bubble,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(size)),
                       .glow = 1});
    }
}

}  // namespace

/// Wisps swell, drift apart and fade. A lighter brew is hotter and has more of them.
void add_steam(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    const double heat = picture.cauldron.there ? picture.cauldron.heat : 0;
    const double wanted = glm::mix(wisps_least, wisps_most, heat);
    for (int i = 0; i < wanted; ++i) {
        const double life = picture.played_s * (0.12 + 0.02 * (i % 5)) + i * 0.618;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 5 * round) + 1.2 * age;
        const double radius = (0.1 + 0.75 * std::fmod(0.618 * (i + 2 * round), 1.0)) * (1 - 0.3 * age);
        const vec3 at = *arena_scene.bowl + vec3(radius * std::cos(angle), 0.75 + (1.5 + 0.2 * (i % 3)) * age,
                                                 radius * std::sin(angle));
        const double dense = std::min(1.0, wanted - i) * std::min(1.0, 4 * age) * (1 - age);
        out.push_back(
            {.mesh = arena_scene.bead,
             .model = glm::scale(render::translated(fvec3(at)), fvec3(static_cast<float>(0.13 + 0.28 * age))),
             .tint = colour(0xD8CCE0),
             .glow = 0.4F * static_cast<float>(dense)});
    }
}

void add_contact_shades(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    for (const auto& thing : picture.things) {
        if (thing.fixed || thing.key.shape == physics::Shape::mesh) continue;
        const bool box = thing.key.shape == physics::Shape::box;
        const vec3 size = box ? thing.key.size : vec3(thing.key.size.x, thing.key.size.y, thing.key.size.x);
        // A round shade does not fit a long plank.
        if (std::max(size.x, size.z) > 2) continue;
        const double height = thing.key.shape == physics::Shape::sphere ? size.x : size.y;
        add_contact_shade(arena_scene, thing.position, 1.35 * std::hypot(size.x, size.z), height, out);
    }
    for (const auto& p : picture.wizards) {
        if (!p.dead) add_contact_shade(arena_scene, p.centre, 0.85, arena_scene.wizard_height / 2, out);
    }
}

void add_casters(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& fixed,
                 std::vector<Instance>& moving) {
    fixed.push_back({.mesh = arena_scene.stone});
    for (const auto& thing : picture.things) add_thing(arena_scene, thing, thing.fixed ? fixed : moving);
    for (std::uint32_t player = 0; player < players; ++player)
        add_figure(arena_scene, player, picture.wizards[player], moving);
}

void show_brew_near(const ArenaScene& arena_scene, const Picture& picture, const BrewOverlay& overlay) {
    const bool seen = std::any_of(
        picture.wizards.begin(), picture.wizards.end(),
        [&](const PlayerPicture& p) { return arena_scene.brew && is_near_brew(arena_scene, p.eye); });
    if (seen && picture.cauldron.there) show_brew(picture.cauldron.brew, overlay, *arena_scene.brew);
}

std::span<const render::Block> blocks_seen_from(const ArenaScene& arena_scene, vec3 eye) {
    const auto& shade = arena_scene.shade;
    const bool within = std::max(std::abs(eye.x), std::abs(eye.z)) < shade.half && eye.y < shade.wall_top;
    return within ? std::span<const render::Block>(arena_scene.blocks) : std::span<const render::Block>();
}

const render::Volume* visible_brew(const ArenaScene& arena_scene, const Picture& picture, vec3 eye) {
    const bool shown = arena_scene.brew && picture.cauldron.there && arena_scene.brew->shown != 0;
    return shown && is_near_brew(arena_scene, eye) ? &arena_scene.brew->volume : nullptr;
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
    for (const auto& thing : picture.things) add_thing(arena_scene, thing, out);
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& wizard = picture.wizards[player];
        add_forces(arena_scene, wizard, player == viewer, out);
        if (player == viewer && !wizard.dead) {
            add_own_arm(arena_scene, player, wizard, out);
            continue;
        }
        add_figure(arena_scene, player, wizard, out);
        add_glow(arena_scene, player, wizard, picture.played_s, out);
    }
    for (const auto& missile : picture.missiles) add_missile(arena_scene, picture, missile, viewer, out);
    for (std::uint32_t i = 0; i < picture.burst_count; ++i)
        add_burst(arena_scene, picture, picture.bursts[i], viewer, out);
    add_brew_of(arena_scene, picture, viewer, out);
    add_niches(arena_scene, picture, out);
    add_embers(arena_scene, picture.played_s, out);
    if (!sees_brew(arena_scene, picture, viewer)) add_bubbles(arena_scene, picture.played_s, out);
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
        if (p.dead || p.wand.empty()) continue;
        const vec3 tip = p.eye + look_rotation(p.yaw, p.pitch) * wand_tip;
        const auto more = static_cast<float>(p.readiness);
        out.push_back({fvec3(tip), (0.5F + 1.5F * more) * team_colours(player).glow, 2.5F + 2 * more});
    }
    // The sort key is the distance of the eye beyond twice the light's radius, so near and wide lights come
    // first.
    const auto distance = [&](const PointLight& l) {
        return glm::length(l.position - fvec3(eye)) - 2 * l.radius;
    };
    std::sort(out.begin(), out.end(),
              [&](const PointLight& a, const PointLight& b) { return distance(a) < distance(b); });
    if (out.size() > render::max_lights) out.resize(render::max_lights);
}

}  // namespace thaum::game
