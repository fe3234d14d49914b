// Verbs (functions of scenario scripts) for crystals, the wizards who carve them, and the Great Work. It wins
// the round for a wizard who holds both its halves, Azoth and the Lens, for long enough.
#include <cmath>

#include "core/hash.h"
#include "game/components/potions.h"
#include "game/match/great_work.h"
#include "game/match/simulation.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/verb.h"
#include "game/stations/crystal/crystal.h"
#include "game/stations/crystal/crystal_shape.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;

const Crystal& crystal_of(const Play& play, lua_State* lua) {
    const auto& world = world_of(play);
    if (world.count<Crystal>() == 0) fault("this match has no crystal");
    const auto number = arg::integer(lua, 1, "a crystal", {1, static_cast<double>(world.count<Crystal>())});
    return world.get<Crystal>(crystal_entity(world, static_cast<std::uint32_t>(number - 1)));
}

const Crystal& touched_crystal(const Play& play, lua_State* lua) {
    const auto& crystal = crystal_of(play, lua);
    if (crystal.touched == 0) fault("nobody has touched that crystal yet");
    return crystal;
}

/// Hash of the voxels of one crystal, as text.
std::string voxel_hash_of(const ecs::World& world, const Crystal& crystal) {
    const auto first = crystal.number * crystal_voxels;
    const auto density = world.blob<CrystalDensity>().subspan(first, crystal_voxels);
    const auto colour = world.blob<CrystalColour>().subspan(3 * first, 3 * crystal_voxels);
    return text(hash_bytes(std::as_bytes(colour), hash_bytes(std::as_bytes(density))));
}

/// Overlap of a crystal with the key, the shape to be carved. For an untouched crystal, the match computes it
/// only when a wizard starts to carve, so it is computed here.
double overlap_of(const Crystal& crystal) {
    if (crystal.touched != 0) return crystal.overlap;
    const auto key = key_density(crystal.seed, crystal_side);
    auto rough = field::make_voxels({crystal_side, crystal_side, crystal_side}, vec3(spacing_of(crystal)));
    rough.density = rough_density(crystal.seed, key, crystal_side);
    return field::overlap_with(rough.view(), key, crystal_surface).ratio();
}

int verb_crystal(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& crystal = crystal_of(play, lua);
    lua_createtable(lua, 0, 8);
    arg::set_number(lua, "overlap", overlap_of(crystal));
    arg::set_number(lua, "size", crystal.size);
    arg::set_number(lua, "voxel", spacing_of(crystal));
    arg::set_number(lua, "chipped", seconds(crystal.chipped));
    arg::set_text(lua, "seed", text(crystal.seed));
    arg::set_flag(lua, "touched", crystal.touched != 0);
    if (crystal.carver < players) arg::set_number(lua, "carver", crystal.carver + 1);
    if (crystal.touched != 0) arg::set_text(lua, "hash", voxel_hash_of(world_of(play), crystal));
    arg::set_place(lua, "middle", crystal.middle);
    return 1;
}

int verb_crystal_density(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& crystal = touched_crystal(play, lua);
    const vec3 place = field::to_own(placement_of(crystal), arg::place(lua, 2, "place", farthest));
    lua_pushnumber(lua, density_grid(world_of(play), crystal, field::Kernel::linear).value(place));
    return 1;
}

/// Verb: the point where a ray meets the surface that the picture shows; nil if the ray misses.
int verb_crystal_ray(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto& crystal = touched_crystal(play, lua);
    const auto placement = placement_of(crystal);
    const vec3 from = field::to_own(placement, arg::place(lua, 2, "from", farthest));
    const vec3 way = arg::place(lua, 3, "way", farthest) * placement.turn;
    const auto met = surface_along(world_of(play), crystal, from, way);
    if (!met) return lua_pushnil(lua), 1;
    arg::push_place(lua, field::to_parent(placement, *met));
    return 1;
}

/// A voxel in which the key, the shape to be carved, has at most this density clearly lies outside of the
/// key.
constexpr float clear_miss = 0.1F;

/// Verb: the nearest faulty voxel, and a word for its fault. "melt": it is solid though it clearly lies
/// outside the key, the shape to be carved. "construct": it is empty though it clearly lies inside. nil if
/// there is none. `kind`: one of these words, or nil for both.
int verb_crystal_fault(lua_State* lua, void* context) {
    auto& play = *static_cast<Play*>(context);
    const auto& crystal = touched_crystal(began(context), lua);
    const auto placement = placement_of(crystal);
    const vec3 from = field::to_own(placement, arg::place(lua, 2, "place", farthest));
    const auto kind = lua_isnoneornil(lua, 3) ? std::string() : arg::string(lua, 3, "kind");
    const auto& body = play.match->crystals().list.at(crystal.number);
    const auto density = world_of(play).blob<CrystalDensity>().subspan(crystal.number * crystal_voxels);
    vec3 nearest(0);
    double least = HUGE_VAL;
    bool surplus = false;
    for (std::size_t i = 0; i < crystal_voxels; ++i) {
        const bool solid = density[i] >= crystal_surface;
        if (solid ? body.key[i] > clear_miss : body.key[i] < 1 - clear_miss) continue;
        if ((kind == "melt" && !solid) || (kind == "construct" && solid)) continue;
        constexpr std::size_t side = crystal_side;
        const std::size_t x = i % side, y = i / side % side, z = i / (side * side);
        const vec3 voxel(x, y, z);
        const vec3 place = spacing_of(crystal) * (voxel - 0.5 * (crystal_side - 1));
        const double distance = glm::distance(place, from);
        if (distance < least) nearest = place, least = distance, surplus = solid;
    }
    if (!(least < HUGE_VAL)) return lua_pushnil(lua), 1;
    arg::push_place(lua, field::to_parent(placement, nearest));
    lua_pushstring(lua, surplus ? "melt" : "construct");
    return 2;
}

/// Verb: state of a wizard's work on crystals: the tool, whether it cuts, and its position. Also whether the
/// wizard has the Lens (the reward), and for how long both halves of the Great Work were held (s).
int verb_carver(lua_State* lua, void* context) {
    const auto& play = began(context);
    const auto player = arg::player(lua, 1);
    const auto& world = world_of(play);
    const auto wizard = wizard_of(world, player);
    const auto* lens = world.find<Lens>(wizard);
    if (lens == nullptr) fault("this match has no crystal");
    lua_createtable(lua, 0, 6);
    arg::set_text(lua, "tool", play.data->crystal->tools.at(lens->tool).name);
    arg::set_flag(lua, "lens", lens->held != 0);
    const auto tick = play.match->match().played;
    const bool works = world.count<GreatWork>() > 0;
    arg::set_number(lua, "great_work", works ? seconds(held_both_for(world, player, tick)) : 0);
    const auto* chisel = world.find<Chisel>(wizard);
    if (chisel == nullptr) return 1;
    arg::set_flag(lua, "cutting", chisel->cutting != 0);
    arg::set_place(lua, "place", chisel->place);
    arg::set_place(lua, "force", chisel->force);
    return 1;
}

/// Verb: gives a wizard one half of the Great Work, which wins a round: Azoth or the Lens. The verb changes
/// the world by itself (sets the scene), so no log is kept.
int verb_give(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto wizard = wizard_of(world_of(play), arg::player(lua, 1));
    const auto what = arg::string(lua, 2, "what to give");
    auto& world = play.match->world_to_change();
    scene_is_set(play);
    if (what == "lens" && world_of(play).has<Lens>(wizard)) return world.get<Lens>(wizard).held = 1, 0;
    if (what == "azoth" && world_of(play).has<WorkHalf>(wizard))
        return world.get<WorkHalf>(wizard).held = 1, 0;
    fault("give takes \"lens\" or \"azoth\", in a match that has it, not '", what, "'");
}

constexpr VerbName crystal_names[] = {
    {"crystal", verb_crystal},         {"crystal_density", verb_crystal_density},
    {"crystal_ray", verb_crystal_ray}, {"crystal_fault", verb_crystal_fault},
    {"carver", verb_carver},           {"give", verb_give},
};

}  // namespace

std::span<const VerbName> crystal_verbs() { return crystal_names; }

}  // namespace thaum::game::inline scenario
