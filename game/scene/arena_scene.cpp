#include "game/scene/arena_scene.h"

#include <algorithm>
#include <cmath>

#include "game/scene/decoration.h"
#include "game/scene/figures.h"
#include "game/scene/furniture.h"
#include "game/scene/ingredient_shapes.h"
#include "game/scene/masonry.h"

namespace thaum::game::inline scene {
namespace {

using render::colour;
using render::MeshData;

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

/// Makes the meshes of a fixed thing. Masonry is added to `stone` instead.
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

/// The surface to stand on: the top of a box, or the slope through the highest vertices of a ramp.
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

/// Adds the block with which a fixed box occludes things. The block is a little smaller than the masonry,
/// whose stones are bevelled and sunk. At the border of the arena the block is endless, since a viewer inside
/// sees only stone there. So a single block hides a cell of the sky that lies behind the corner of two walls,
/// or behind the foot of a wall.
void add_block(const Thing& thing, ArenaScene& arena_scene) {
    // margin by which the block is smaller than the box on each side, and length that counts as endless (m)
    constexpr double less = 0.12, endless = 1000;
    const vec3 half = thing.body.size - less;
    if (glm::any(glm::lessThanEqual(half, vec3(0)))) return;
    render::Block block{thing.position - half, thing.position + half};
    const auto& shade = arena_scene.shade;
    bool beyond = false;
    for (const int axis : {0, 2}) {
        const double low_end = (axis == 0 ? shade.low.x : shade.low.y) + 2 * less;
        const double high_end = (axis == 0 ? shade.high.x : shade.high.y) - 2 * less;
        beyond = beyond || block.low[axis] > high_end || block.high[axis] < low_end;
        if (block.low[axis] <= low_end) block.low[axis] = -endless;
        if (block.high[axis] >= high_end) block.high[axis] = endless;
    }
    if (beyond) block.low.y = -endless;
    arena_scene.blocks.push_back(block);
}

/// Adds the light of a thing that emits light.
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

/// Removes the painted insides of the orb and the crystals from the meshes that are always drawn, if the
/// match has a simulated flow or crystal instead.
void add_station(render::Renderer& renderer, const MatchData& data, const Thing& thing,
                 ArenaScene& arena_scene) {
    auto& meshes = arena_scene.solids.back().meshes;
    if (thing.surface == Surface::orb && data.orb && arena_scene.orb == nullptr) {
        arena_scene.orb = std::make_shared<OrbLook>(make_orb_look(renderer, thing.body.size.x));
        meshes.glowing.reset();
    }
    if (is_crystal(thing.surface, thing.body.shape) && data.crystal) {
        arena_scene.crystals.push_back(std::make_shared<CrystalLook>(make_crystal_look(renderer)));
        meshes.glowing.reset();
    }
}

/// Adds a thing with its meshes, its light, the block with which it occludes others, and the ground on top of
/// it.
void add_thing(render::Renderer& renderer, const MatchData& data, const Thing& thing,
               render::Patchwork& stone, ArenaScene& arena_scene) {
    const auto& arena = data.arena;
    if (thing.prop) {
        add_kind(renderer, key_of(thing), arena_scene);
    } else {
        arena_scene.solids.push_back(make_solid(renderer, arena_scene.shade, arena, thing, stone));
        add_station(renderer, data, thing, arena_scene);
    }
    if (thing.surface == Surface::bowl && thing.body.shape == physics::Shape::mesh)
        arena_scene.painted_brew = upload(renderer, cauldron(arena.meshes[thing.body.mesh]).glowing);
    add_light_of(thing, arena_scene);
    if (is_masonry(thing)) add_block(thing, arena_scene);
    if (thing.surface == Surface::floor || thing.surface == Surface::pit)
        arena_scene.grounds.push_back(ground_of(thing, arena));
}

/// Adds the meshes of effects, which are the same in every arena.
void add_effects(render::Renderer& renderer, ArenaScene& arena_scene) {
    arena_scene.runes = renderer.upload_with_copies(rune_circle(2.1F));
    arena_scene.bubble = renderer.upload_with_copies(render::sphere(1, 8, colour(0xFFB048)));
    arena_scene.beam = renderer.upload_with_copies(beam_of_light());
    arena_scene.bead = renderer.upload_with_copies(render::sphere(1, 8, fvec3(1)));
    arena_scene.ember = renderer.upload_with_copies(render::sphere(1, 5, colour(0xFFA040)));
    for (std::size_t i = 0; i < ingredient_shapes; ++i)
        arena_scene.ingredients[i] =
            renderer.upload_with_copies(ingredient_mesh(static_cast<IngredientShape>(i)));
    arena_scene.contact = renderer.upload_with_copies(contact_shade(0.42F));
}

std::array<render::MeshId, 4> unit_shapes(render::Renderer& renderer) {
    const fvec3 grey = colour(0x807890);
    return {renderer.upload_with_copies(render::box(fvec3(1), grey, 0.06F)),
            renderer.upload_with_copies(render::sphere(1, 14, grey)),
            renderer.upload_with_copies(render::capsule(0.5F, 1, 12, grey)),
            renderer.upload_with_copies(render::cylinder(1, 2, 16, grey))};
}

fvec3 light_of(const Tint& tint) { return static_cast<float>(tint.strength) * colour(tint.colour); }

render::Environment environment_of(const ArenaLook& look) {
    render::Environment e;
    e.sun.direction = glm::normalize(fvec3(look.towards_sun));
    e.sun.colour = light_of(look.sun);
    e.sky.zenith = light_of(look.zenith);
    e.sky.horizon = light_of(look.horizon);
    e.sky.sun_glow = light_of(look.sun_glow);
    e.fog.colour = light_of(look.fog);
    e.fog.density = static_cast<float>(look.fog_density);
    e.ambient.above = light_of(look.above);
    e.ambient.below = light_of(look.below);
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
    if (arena.bowl) {
        arena_scene.rim_radius = arena.bowl->size.radius;
        arena_scene.rim_height = arena.bowl->size.height / 2;
    }
    arena_scene.environment = environment_of(data.look);
    arena_scene.menu_camera = data.look.menu_camera;
    arena_scene.wizard_height = data.wizard.height;
    arena_scene.shade = make_shade(arena, data.look);
    const auto& shade = arena_scene.shade;
    render::Patchwork stone;
    for (const auto& thing : arena.things) add_thing(renderer, data, thing, stone, arena_scene);
    for (std::uint32_t team = 0; team < players; ++team)
        arena_scene.teams[team] = make_team(renderer, *data.presentation, team);
    arena_scene.power_ups = make_power_up_meshes(renderer);
    arena_scene.anchor = upload(renderer, anchor());
    arena_scene.neutral_plate = upload(renderer, start_plate(no_player));
    add_decoration(shade, data.look, stone);
    arena_scene.stone = renderer.upload(stone);
    arena_scene.lamps = renderer.upload(lamps(shade, data.look));
    arena_scene.skyline = renderer.upload(skyline(data.look));
    for (const auto& wand : data.presentation->wands)
        arena_scene.wands.push_back(renderer.upload_with_copies(wand_mesh(wand.look)));
    add_effects(renderer, arena_scene);
    arena_scene.unit_shapes = unit_shapes(renderer);
    return arena_scene;
}

}  // namespace thaum::game::inline scene
