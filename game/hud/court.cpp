#include "game/hud/court.h"

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

constexpr double least_share = 0.02;    ///< of the strongest force; less is not drawn
constexpr double ribbon_length = 0.25;  ///< m, of the strongest force
constexpr int embers = 36, bubbles = 14;
/// Of steam: over a pure brew, and over one that lifts.
constexpr double wisps_least = 9, wisps_most = 26;
constexpr float glow_share = 0.85F;  // of what shines by itself and is lit a little as well
constexpr float brew_glow = 1.7F;    // the brightest thing in the court
constexpr double shade_reach = 2.5;  // m above the ground, where contact shade is gone

// Making ---------------------------------------------------------------------------------------------------------------

std::optional<render::MeshId> upload(render::Renderer& renderer, const MeshData& mesh) {
    if (mesh.indices.empty()) return {};
    return renderer.upload_with_copies(mesh);
}

Court::Meshes upload(render::Renderer& renderer, const FurnitureMesh& mesh) {
    return {.lit = upload(renderer, mesh.lit), .glowing = upload(renderer, mesh.glowing)};
}

ShapeKey key_of(const Thing& thing) {
    return {thing.surface, thing.body.shape, thing.body.mesh, thing.body.size};
}

/// What never moves and is made of stone.
bool is_masonry(const Thing& thing) {
    return !thing.prop && thing.body.shape == physics::Shape::box && thing.surface != Surface::crystal;
}

/// Masonry goes into `stone`.
Court::Solid make_solid(render::Renderer& renderer, const Shade& shade, const Arena& arena,
                        const Thing& thing, render::Patchwork& stone) {
    Court::Solid solid{key_of(thing), thing.position, {}};
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

void add_kind(render::Renderer& renderer, const ShapeKey& key, Court& court) {
    const auto known = [&](const Court::Kind& kind) { return kind.key == key; };
    if (std::none_of(court.kinds.begin(), court.kinds.end(), known))
        court.kinds.push_back({key, upload(renderer, furniture(key))});
}

Court::Team make_team(render::Renderer& renderer, std::uint32_t team) {
    return {.figure = renderer.upload_with_copies(wizard_figure(team)),
            .fallen = renderer.upload_with_copies(fallen_wizard(team)),
            .arm = renderer.upload_with_copies(wizard_arm(team)),
            .own_arm = renderer.upload_with_copies(own_arm(team)),
            .spark = renderer.upload_with_copies(wand_spark(team)),
            .bolt = renderer.upload_with_copies(bolt_needle(team)),
            .fireball = renderer.upload_with_copies(fireball(team)),
            .stone = renderer.upload_with_copies(lob_stone(team)),
            .burst = renderer.upload_with_copies(burst_shell(team)),
            .shield = renderer.upload_with_copies(shield_rings(team)),
            .plate = upload(renderer, start_plate(team))};
}

/// The top of a box, or the slope that a ramp's highest vertices tell.
Court::Ground ground_of(const Thing& thing, const Arena& arena) {
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

/// A little less than the masonry fills, whose blocks are bevelled and sunk; and without end where the court ends, since who
/// is in it sees nothing there but through stone. So a cell of the sky over a corner of two walls, or over the foot of one, is
/// covered by one block.
void add_block(const Thing& thing, Court& court) {
    constexpr double less = 0.12, endless = 1000;  // m
    const vec3 half = thing.body.size - less;
    if (glm::any(glm::lessThanEqual(half, vec3(0)))) return;
    render::Block block{thing.position - half, thing.position + half};
    const double end = court.shade.half - 2 * less;
    bool beyond = false;
    for (const int axis : {0, 2}) {
        beyond = beyond || block.low[axis] > end || block.high[axis] < -end;
        if (block.low[axis] <= -end) block.low[axis] = -endless;
        if (block.high[axis] >= end) block.high[axis] = endless;
    }
    if (beyond) block.low.y = -endless;
    court.blocks.push_back(block);
}

/// What stands there gives light of its own.
void add_light_of(const Thing& thing, Court& court) {
    const fvec3 at(thing.position);
    if (thing.surface == Surface::bowl) {
        court.bowl = thing.position;
        court.lights.insert(court.lights.begin(), {at + fvec3(0, 1.5F, 0), 5.0F * colour(0xFF8C3C), 22});
    }
    if (thing.surface == Surface::orb)
        court.lights.push_back({at + fvec3(0.8F, 0.2F, 0), 2.2F * colour(0x8A6AFF), 8});
    if (thing.surface == Surface::crystal)
        court.lights.push_back({at + fvec3(0, 0.6F, 0), 1.8F * colour(0x50D0F0), 7});
}

render::Environment dusk() {
    render::Environment e;
    // So low that the wall of 12 m keeps the sun from the eastern half: the cauldron stands just within the shade, and
    // both players start in the light.
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

double Court::Ground::height_at(vec3 p) const {
    return height + slope_x * (p.x - (low.x + high.x) / 2) + slope_z * (p.z - (low.z + high.z) / 2);
}

Court make_court(render::Renderer& renderer, const MatchData& data) {
    const auto& arena = data.arena;
    Court court;
    if (data.cauldron) {
        court.brew =
            std::make_shared<BrewLook>(make_brew_look(renderer, brew_place(*arena.bowl, *data.cauldron)));
    }
    court.environment = dusk();
    court.wizard_height = data.wizard.height;
    court.shade = make_shade(arena, court.environment.sun.direction);
    const auto& shade = court.shade;
    render::Patchwork stone;
    for (const auto& thing : arena.things) {
        if (thing.prop)
            add_kind(renderer, key_of(thing), court);
        else
            court.solids.push_back(make_solid(renderer, shade, arena, thing, stone));
        if (thing.surface == Surface::bowl && thing.body.shape == physics::Shape::mesh)
            court.painted_brew = upload(renderer, cauldron(arena.meshes[thing.body.mesh]).glowing);
        add_light_of(thing, court);
        if (is_masonry(thing)) add_block(thing, court);
        if (thing.surface == Surface::floor || thing.surface == Surface::pit)
            court.grounds.push_back(ground_of(thing, arena));
    }
    for (std::uint32_t team = 0; team < players; ++team) court.teams[team] = make_team(renderer, team);
    court.power_ups = make_power_up_meshes(renderer);
    court.anchor = upload(renderer, anchor());
    court.neutral_plate = upload(renderer, start_plate(no_player));
    add_decoration(shade, stone);
    court.stone = renderer.upload(stone);
    court.lamps = renderer.upload(lamps(shade));
    court.skyline = renderer.upload(skyline());
    for (std::size_t i = 0; i < court.wands.size(); ++i)
        court.wands[i] = renderer.upload_with_copies(wand_mesh(static_cast<Silhouette>(i)));
    court.runes = renderer.upload_with_copies(rune_circle(2.1F));
    court.bubble = renderer.upload_with_copies(render::sphere(1, 8, colour(0xFFB048)));
    court.beam = renderer.upload_with_copies(beam_of_light());
    court.bead = renderer.upload_with_copies(render::sphere(1, 8, fvec3(1)));
    court.ember = renderer.upload_with_copies(render::sphere(1, 5, colour(0xFFA040)));
    court.contact = renderer.upload_with_copies(contact_shade(0.42F));
    const fvec3 grey = colour(0x807890);
    court.unit_shapes = {renderer.upload_with_copies(render::box(fvec3(1), grey, 0.06F)),
                         renderer.upload_with_copies(render::sphere(1, 14, grey)),
                         renderer.upload_with_copies(render::capsule(0.5F, 1, 12, grey)),
                         renderer.upload_with_copies(render::cylinder(1, 2, 16, grey))};
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
    if (meshes.glowing)
        out.push_back(
            {.mesh = *meshes.glowing, .model = model, .tint = fvec3(meshes.glow), .glow = glow_share});
}

const Court::Meshes* find_solid(const Court& court, const ThingPicture& thing) {
    for (const auto& solid : court.solids) {
        if (thing.fixed && solid.key == thing.key && solid.position == thing.position) return &solid.meshes;
    }
    return nullptr;
}

const Court::Meshes* find_kind(const Court& court, const ThingPicture& thing) {
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

/// The ground below, where there is any.
const Court::Ground* ground_below(const Court& court, vec3 at) {
    const Court::Ground* best = nullptr;
    for (const auto& g : court.grounds) {
        const bool over = at.x >= g.low.x && at.x <= g.high.x && at.z >= g.low.z && at.z <= g.high.z;
        if (over && g.height_at(at) <= at.y + 0.1 &&
            (best == nullptr || g.height_at(at) > best->height_at(at)))
            best = &g;
    }
    return best;
}

/// Nothing hangs over an edge: is the ground's plane under the whole rim?
bool lies_flat(const Court& court, const Court::Ground& ground, vec3 centre, double radius) {
    for (const vec3 way : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
        const vec3 rim = centre + radius * way;
        const double height = ground.height_at(rim);
        const auto* there = ground_below(court, {rim.x, height + 0.2, rim.z});
        if (there == nullptr || std::abs(there->height_at(rim) - height) > 0.05) return false;
    }
    return true;
}

void add_contact_shade(const Court& court, vec3 centre, double radius, double half_height,
                       std::vector<Instance>& out) {
    const auto* ground = ground_below(court, centre - vec3(0, 0.9 * half_height, 0));
    if (ground == nullptr) return;
    const double above = std::max(0.0, centre.y - half_height - ground->height_at(centre));
    if (above > shade_reach) return;
    for (int smaller = 0; smaller < 3 && !lies_flat(court, *ground, centre, radius); ++smaller) radius *= 0.6;
    if (!lies_flat(court, *ground, centre, radius)) return;
    const auto size = static_cast<float>(radius);
    const vec3 at(centre.x, ground->height_at(centre) + 0.012, centre.z);
    fmat4 m = render::translated(fvec3(at));
    m[0] = fvec4(size, size * static_cast<float>(ground->slope_x), 0, 0);
    m[2] = fvec4(0, size * static_cast<float>(ground->slope_z), size, 0);
    const auto strength = static_cast<float>(1 - above / shade_reach);
    out.push_back({.mesh = court.contact, .model = m, .tint = fvec3(strength)});
}

/// What is not baked where it stands is in the sun or not, where there is no shadow map.
void set_sun(const Court& court, vec3 at, std::span<Instance> of) {
    const float sun = sees_sun(court.shade, at) ? 1.0F : 0.0F;
    for (auto& instance : of) instance.sun = sun;
}

void add_thing(const Court& court, const ThingPicture& thing, std::vector<Instance>& out) {
    const auto first = out.size();
    auto model = placed(thing.position, thing.orientation);
    if (const auto* solid = find_solid(court, thing)) return add(*solid, model, out);
    if (thing.key.surface == Surface::pad)
        add(thing.team < players ? court.teams[thing.team].plate : court.neutral_plate, model, out);
    else if (thing.key.surface == Surface::anchor)
        add(court.anchor, glm::scale(model, fvec3(fvec3(thing.key.size).x)), out);
    else if (const auto* kind = find_kind(court, thing))
        add(*kind, model, out);
    else
        add_unknown(court, thing, out);
    // A hand's breadth up: what lies flat is within the ground.
    set_sun(court, thing.position + vec3(0, 0.1, 0), std::span(out).subspan(first));
}

fmat4 turned(double yaw, double pitch) { return glm::mat4_cast(fquat(look_rotation(yaw, pitch))); }

/// In the frame of the eye: the wand, and the hand on it, as the stylus turns them about the tip; by so much at most, else the hand
/// would come off its arm.
fmat4 stylus_turned(const PlayerPicture& p) {
    constexpr double most = 0.7;  // rad
    const vec3 by = limited(p.wand_turn, most);
    const double angle = glm::length(by);
    if (!(angle > 1e-6)) return fmat4(1);
    return render::translated(fvec3(wand_tip)) * glm::mat4_cast(fquat(rotation(by / angle, angle))) *
           render::translated(-fvec3(wand_tip));
}

/// Body, arm and wand, as the other sees them and as they cast a shadow.
void add_figure(const Court& court, std::uint32_t number, const PlayerPicture& p,
                std::vector<Instance>& out) {
    const auto& team = court.teams[number];
    const auto first = out.size();
    const fvec3 feet(p.centre - vec3(0, court.wizard_height / 2, 0));
    const auto standing = render::translated(feet) * turned(p.yaw, 0);
    out.push_back({.mesh = p.dead ? team.fallen : team.figure, .model = standing});
    if (!p.dead) {
        const auto arm = render::translated(fvec3(p.eye)) * turned(p.yaw, 0) * render::translated(shoulder) *
                         turned(0, p.pitch);
        out.push_back({.mesh = team.arm, .model = arm});
        if (!p.wand.empty() && !p.stirs)
            out.push_back({.mesh = court.wands[static_cast<std::size_t>(p.silhouette)],
                           .model = arm * render::translated(-shoulder) * stylus_turned(p) * wand_in_hand()});
    }
    set_sun(court, p.centre, std::span(out).subspan(first));
}

/// The glow at a wand's tip, which grows with what it is charged with.
Instance spark_at(const Court& court, std::uint32_t number, const PlayerPicture& p, const fmat4& tip) {
    const auto size = static_cast<float>(1 + 3.5 * p.readiness);
    return {.mesh = court.teams[number].spark, .model = glm::scale(tip, fvec3(size)), .glow = 1};
}

/// What shines of a wizard: the wand's tip, and the shield.
void add_glow(const Court& court, std::uint32_t number, const PlayerPicture& p, double time,
              std::vector<Instance>& out) {
    if (p.dead) return;
    const auto& team = court.teams[number];
    const auto arm = render::translated(fvec3(p.eye)) * turned(p.yaw, 0) * render::translated(shoulder) *
                     turned(0, p.pitch);
    if (!p.wand.empty())
        out.push_back(spark_at(court, number, p, arm * render::translated(fvec3(wand_tip) - shoulder)));
    if (p.shielded) {
        const auto slowly = turned(0.8 * time, 0);
        out.push_back(
            {.mesh = team.shield, .model = render::translated(fvec3(p.centre)) * slowly, .glow = 0.9F});
    }
}

void add_own_arm(const Court& court, std::uint32_t number, const PlayerPicture& p,
                 std::vector<Instance>& out) {
    constexpr double most_reach = 0.22;  // m; beyond, hand and wand would leave the picture
    const auto first = out.size();
    const auto eye = render::translated(fvec3(p.eye)) * turned(p.yaw, p.pitch) *
                     render::translated(fvec3(limited(p.wand_reach, most_reach))) * stylus_turned(p);
    if (p.stirs) return;  // the ladle is all that is seen of it
    out.push_back({.mesh = court.teams[number].own_arm, .model = eye});
    if (!p.wand.empty()) {
        out.push_back(
            {.mesh = court.wands[static_cast<std::size_t>(p.silhouette)], .model = eye * wand_in_own_hand()});
        out.push_back(spark_at(court, number, p, eye * render::translated(fvec3(wand_tip))));
    }
    set_sun(court, p.eye, std::span(out).subspan(first));
}

void add_beam(const Court& court, vec3 from, vec3 to, double thick, fvec3 tint, std::vector<Instance>& out) {
    const vec3 way = to - from;
    const double length = glm::length(way);
    if (length < 1e-6) return;
    const auto yaw = std::atan2(-way.x, -way.z), pitch = std::atan2(way.y, std::hypot(way.x, way.z));
    const fvec3 size(vec3(thick, thick, length));
    out.push_back({.mesh = court.beam,
                   .model = glm::scale(render::translated(fvec3(from)) * turned(yaw, pitch), size),
                   .tint = tint,
                   .glow = 0.7F});
}

/// What the hand feels: the spring to what it holds, and for one's own hand the force itself, at the wand's tip.
void add_forces(const Court& court, const PlayerPicture& p, bool own, std::vector<Instance>& out) {
    if (p.dead) return;
    const auto looking = look_rotation(p.yaw, p.pitch);
    const vec3 tip = p.eye + looking * (wand_tip + (own ? p.wand_reach : vec3(0)));
    const double share = p.force.cap > 0 ? glm::length(p.force.now) / p.force.cap : 0;
    const fvec3 shown = force_colour(share),
                tint = shown * shown;  // from the screen's colours to those of light
    if (p.held) add_beam(court, tip, *p.held, 0.012, tint, out);
    if (!own || share < least_share) return;
    add_beam(court, tip, tip + looking * p.force.now / p.force.cap * ribbon_length, 0.006, tint, out);
    out.push_back({.mesh = court.bead,
                   .model = glm::scale(render::translated(fvec3(tip)), fvec3(0.02F)),
                   .tint = tint,
                   .glow = 0.7F});
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

void add_missile(const Court& court, const Picture& picture, const MissilePicture& missile,
                 std::uint32_t viewer, std::vector<Instance>& out) {
    const auto& team = court.teams[missile.player % players];
    const bool round = missile.look != MissileLook::needle;
    const float size = size_of(picture, missile, viewer) * (round ? static_cast<float>(missile.size) : 1.0F);
    const auto mesh = missile.look == MissileLook::fireball ? team.fireball
                      : missile.look == MissileLook::stone  ? team.stone
                                                            : team.bolt;
    out.push_back({.mesh = mesh, .model = glm::scale(flying(missile), fvec3(size)), .glow = 1});
}

/// A small core that goes out, and a shell that flies as far as the burst reaches. Neither ever fills a view: the core is small where it
/// is near, and nobody sees the shell that goes past their eye.
void add_burst(const Court& court, const Picture& picture, const BurstPicture& burst, std::uint32_t viewer,
               std::vector<Instance>& out) {
    constexpr double most_of_view = 0.15;  // of the distance to it
    constexpr double past_the_eye = 1.25;  // its bars are thick
    const auto& team = court.teams[burst.player % players];
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
    if (shown > 0) out.push_back({.mesh = court.ember, .model = glm::scale(at, fvec3(shown)), .glow = 1});
}

void add_painted_brew(const Court& court, std::vector<Instance>& out) {
    if (!court.bowl || !court.painted_brew) return;
    out.push_back({.mesh = *court.painted_brew,
                   .model = render::translated(fvec3(*court.bowl)),
                   .tint = fvec3(brew_glow),
                   .glow = glow_share});
}

/// m: from farther away a brew at rest looks as if painted.
constexpr double brew_seen_from = 14;

bool is_near_brew(const Court& court, vec3 eye) {
    return glm::distance(eye, court.brew->place.middle) < brew_seen_from;
}

/// As what it is, and not as if painted; the court that nobody plays in is seen from afar.
bool sees_brew(const Court& court, const Picture& picture, std::uint32_t viewer) {
    return viewer < players && visible_brew(court, picture, picture.wizards[viewer].eye) != nullptr;
}

void add_brew_of(const Court& court, const Picture& picture, std::uint32_t viewer,
                 std::vector<Instance>& out) {
    if (!sees_brew(court, picture, viewer)) return add_painted_brew(court, out);
    add_brew(*court.brew, out);
    for (const auto& ladle : picture.cauldron.ladles) {
        if (ladle) add_ladle(court.brew->meshes, *ladle, out);
    }
}

void add_niches(const Court& court, const Picture& picture, std::vector<Instance>& out) {
    constexpr float height = 0.5F, size = 0.14F;
    for (const auto& niche : picture.niches) {
        const auto at = render::translated(fvec3(niche.position));
        out.push_back({.mesh = court.contact, .model = glm::scale(at, fvec3(0.4F, 1, 0.4F))});
        if (!niche.there) continue;
        for (const fvec3 off : {fvec3(0, 0, 0), fvec3(0.16F, -0.08F, 0.05F), fvec3(-0.12F, -0.07F, 0.12F)})
            out.push_back(
                {.mesh = court.bead,
                 .model = glm::scale(at * render::translated(off + fvec3(0, height, 0)), fvec3(size)),
                 .tint = niche.colour,
                 .glow = 0.55F});
    }
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
        const vec3 at = *court.bowl + vec3(radius * std::cos(angle), 0.72 - 0.10 * radius * radius,
                                           radius * std::sin(angle));
        const auto size = static_cast<float>(0.02 + 0.13 * std::sin(pi * age));
        out.push_back({.mesh = court.bubble,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(size)),
                       .glow = 1});
    }
}

}  // namespace

/// They swell, drift apart and thin out: the lighter the brew is, the hotter, and the more of them.
void add_steam(const Court& court, const Picture& picture, std::vector<Instance>& out) {
    if (!court.bowl) return;
    const double heat = picture.cauldron.there ? picture.cauldron.heat : 0;
    const double wanted = glm::mix(wisps_least, wisps_most, heat);
    for (int i = 0; i < wanted; ++i) {
        const double life = picture.played_s * (0.12 + 0.02 * (i % 5)) + i * 0.618;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 5 * round) + 1.2 * age;
        const double radius = (0.1 + 0.75 * std::fmod(0.618 * (i + 2 * round), 1.0)) * (1 - 0.3 * age);
        const vec3 at = *court.bowl + vec3(radius * std::cos(angle), 0.75 + (1.5 + 0.2 * (i % 3)) * age,
                                           radius * std::sin(angle));
        const double dense = std::min(1.0, wanted - i) * std::min(1.0, 4 * age) * (1 - age);
        out.push_back(
            {.mesh = court.bead,
             .model = glm::scale(render::translated(fvec3(at)), fvec3(static_cast<float>(0.13 + 0.28 * age))),
             .tint = colour(0xD8CCE0),
             .glow = 0.4F * static_cast<float>(dense)});
    }
}

void add_contact_shades(const Court& court, const Picture& picture, std::vector<Instance>& out) {
    for (const auto& thing : picture.things) {
        if (thing.fixed || thing.key.shape == physics::Shape::mesh) continue;
        const bool box = thing.key.shape == physics::Shape::box;
        const vec3 size = box ? thing.key.size : vec3(thing.key.size.x, thing.key.size.y, thing.key.size.x);
        // A long plank is no disc.
        if (std::max(size.x, size.z) > 2) continue;
        const double height = thing.key.shape == physics::Shape::sphere ? size.x : size.y;
        add_contact_shade(court, thing.position, 1.35 * std::hypot(size.x, size.z), height, out);
    }
    for (const auto& p : picture.wizards) {
        if (!p.dead) add_contact_shade(court, p.centre, 0.85, court.wizard_height / 2, out);
    }
}

void add_casters(const Court& court, const Picture& picture, std::vector<Instance>& fixed,
                 std::vector<Instance>& moving) {
    fixed.push_back({.mesh = court.stone});
    for (const auto& thing : picture.things) add_thing(court, thing, thing.fixed ? fixed : moving);
    for (std::uint32_t player = 0; player < players; ++player)
        add_figure(court, player, picture.wizards[player], moving);
}

void show_brew_near(const Court& court, const Picture& picture, const BrewOverlay& overlay) {
    const bool seen =
        std::any_of(picture.wizards.begin(), picture.wizards.end(),
                    [&](const PlayerPicture& p) { return court.brew && is_near_brew(court, p.eye); });
    if (seen && picture.cauldron.there) show_brew(picture.cauldron.brew, overlay, *court.brew);
}

std::span<const render::Block> blocks_seen_from(const Court& court, vec3 eye) {
    const auto& shade = court.shade;
    const bool within = std::max(std::abs(eye.x), std::abs(eye.z)) < shade.half && eye.y < shade.wall_top;
    return within ? std::span<const render::Block>(court.blocks) : std::span<const render::Block>();
}

const render::Volume* visible_brew(const Court& court, const Picture& picture, vec3 eye) {
    const bool shown = court.brew && picture.cauldron.there && court.brew->shown != 0;
    return shown && is_near_brew(court, eye) ? &court.brew->volume : nullptr;
}

void add_instances(const Court& court, const Picture& picture, std::uint32_t viewer,
                   std::vector<Instance>& out) {
    out.push_back({.mesh = court.stone});
    out.push_back({.mesh = court.lamps, .glow = glow_share});
    out.push_back({.mesh = court.skyline});
    if (court.bowl) {
        const auto* ground = ground_below(court, *court.bowl);
        const double height = ground == nullptr ? 0 : ground->height_at(*court.bowl);
        const fvec3 at(vec3(court.bowl->x, height, court.bowl->z));
        out.push_back({.mesh = court.runes, .model = render::translated(at), .glow = 0.35F});
    }
    for (const auto& thing : picture.things) add_thing(court, thing, out);
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& wizard = picture.wizards[player];
        add_forces(court, wizard, player == viewer, out);
        if (player == viewer && !wizard.dead) {
            add_own_arm(court, player, wizard, out);
            continue;
        }
        add_figure(court, player, wizard, out);
        add_glow(court, player, wizard, picture.played_s, out);
    }
    for (const auto& missile : picture.missiles) add_missile(court, picture, missile, viewer, out);
    for (std::uint32_t i = 0; i < picture.burst_count; ++i)
        add_burst(court, picture, picture.bursts[i], viewer, out);
    add_brew_of(court, picture, viewer, out);
    add_niches(court, picture, out);
    add_embers(court, picture.played_s, out);
    if (!sees_brew(court, picture, viewer)) add_bubbles(court, picture.played_s, out);
}

void choose_lights(const Court& court, const Picture& picture, vec3 eye, std::vector<PointLight>& out) {
    out = court.lights;
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
    // How far beyond its own reach the viewer is: what is near and wide comes first.
    const auto distance = [&](const PointLight& l) {
        return glm::length(l.position - fvec3(eye)) - 2 * l.radius;
    };
    std::sort(out.begin(), out.end(),
              [&](const PointLight& a, const PointLight& b) { return distance(a) < distance(b); });
    if (out.size() > render::max_lights) out.resize(render::max_lights);
}

}  // namespace thaum::game
