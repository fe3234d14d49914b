// Verbs (functions of scenario scripts) for loose things that a script adds to the arena.
#include <algorithm>

#include "game/match/spawn.h"
#include "game/scenario/detail/part.h"
#include "game/scenario/detail/verb.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;
using arg::Options;

constexpr std::size_t max_things = 48;

constexpr Range extent{0.02, 10};

void read_shape(lua_State* lua, const Options& options, physics::BodyDesc& body) {
    options.need("kind");
    const auto kind = arg::string(lua, -1, "kind");
    if (kind == "box") {
        body.shape = physics::Shape::box;
        options.need("size");
        body.size = arg::place(lua, -1, "size", extent.high) * 0.5;
        if (glm::min(body.size.x, glm::min(body.size.y, body.size.z)) < extent.low / 2) {
            fault("size: each must be at least ", extent.low);
        }
        return;
    }
    if (kind != "sphere" && kind != "cylinder") fault("kind '", kind, "' is none of box, sphere, cylinder");
    options.need("radius");
    body.size = {arg::number(lua, -1, "radius", extent), 0, 0};
    body.shape = physics::Shape::sphere;
    if (kind == "sphere") return;
    options.need("height");
    body.size.y = arg::number(lua, -1, "height", extent) / 2;
    body.shape = physics::Shape::cylinder;
}

Surface read_surface(lua_State* lua) {
    const auto name = arg::string(lua, -1, "surface");
    const auto found = std::find(surface_names.begin(), surface_names.end(), name);
    if (found == surface_names.end()) fault("there is no surface '", name, "'");
    return static_cast<Surface>(found - surface_names.begin());
}

Thing read_thing(lua_State* lua, const Options& options) {
    Thing thing;
    thing.prop = true;
    thing.surface = Surface::crate;
    read_shape(lua, options, thing.body);
    options.need("mass");
    thing.body.mass = arg::number(lua, -1, "mass", {0.01, 10000});
    options.need("at");
    thing.position = arg::place(lua, -1, "at", farthest);
    thing.body.friction = options.has("friction") ? arg::number(lua, -1, "friction", {0, 2}) : 0.8;
    thing.body.restitution = options.has("restitution") ? arg::number(lua, -1, "restitution", {0, 1}) : 0.1;
    thing.body.layer = layer::prop;
    if (thing.body.shape != physics::Shape::box) thing.body.rolling_friction = 0.01;
    if (options.has("surface")) thing.surface = read_surface(lua);
    return thing;
}

int verb_spawn(lua_State* lua, void* context) {
    auto& play = began(context);
    const Options options(
        lua, 1, "spawn",
        {"kind", "size", "radius", "height", "mass", "at", "velocity", "surface", "friction", "restitution"});
    if (play.things.size() == max_things) fault("there are ", max_things, " things already");
    const auto thing = read_thing(lua, options);
    const vec3 velocity = options.has("velocity") ? arg::place(lua, -1, "velocity", fastest) : vec3(0);
    scene_is_set(play);
    const auto entity = spawn_thing(world_to_change(play), thing);
    physics_of(play).set_velocity(entity.index, velocity);
    world_to_change(play).get<Motion>(entity).velocity = velocity;
    play.things.push_back({entity, thing.body.mass});
    lua_pushinteger(lua, static_cast<lua_Integer>(play.things.size()));
    return 1;
}

const SpawnedThing& thing_of(const Play& play, lua_State* lua) {
    const auto number = arg::integer(lua, 1, "a thing", {1, static_cast<double>(play.things.size())});
    return play.things[static_cast<std::size_t>(number - 1)];
}

const SpawnedThing& living_thing(const Play& play, lua_State* lua) {
    const auto& thing = thing_of(play, lua);
    if (!world_of(play).alive(thing.entity)) fault("that thing is gone");
    return thing;
}

int verb_thing_there(lua_State* lua, void* context) {
    const auto& play = began(context);
    lua_pushboolean(lua, world_of(play).alive(thing_of(play, lua).entity));
    return 1;
}

int verb_thing_position(lua_State* lua, void* context) {
    const auto& play = began(context);
    arg::push_place(lua, world_of(play).get<Motion>(living_thing(play, lua).entity).position);
    return 1;
}

int verb_thing_velocity(lua_State* lua, void* context) {
    const auto& play = began(context);
    arg::push_place(lua, world_of(play).get<Motion>(living_thing(play, lua).entity).velocity);
    return 1;
}

int verb_place_thing(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto entity = living_thing(play, lua).entity;
    Motion motion;
    motion.position = arg::place(lua, 2, "place", farthest);
    if (!lua_isnoneornil(lua, 3)) motion.velocity = arg::place(lua, 3, "velocity", fastest);
    scene_is_set(play);
    world_to_change(play).get<Motion>(entity) = motion;
    physics_of(play).set_state(entity.index, motion);
    return 0;
}

int verb_push_thing(lua_State* lua, void* context) {
    auto& play = began(context);
    const auto& thing = living_thing(play, lua);
    const vec3 impulse = arg::place(lua, 2, "impulse", 1e6);
    if (glm::length(impulse) > fastest * thing.mass)
        fault("that impulse makes it faster than ", fastest, " m/s");
    scene_is_set(play);
    physics_of(play).apply_central_impulse(thing.entity.index, impulse);
    return 0;
}

int verb_clear_props(lua_State*, void* context) {
    auto& play = began(context);
    scene_is_set(play);
    auto& world = world_to_change(play);
    std::vector<ecs::Entity> props;
    world.view<const Prop>().each([&](ecs::Entity e, const Prop&) { props.push_back(e); });
    for (const auto e : props) world.destroy(e);
    return 0;
}

constexpr VerbName thing_list[] = {
    {"raw_spawn", verb_spawn},
    {"raw_thing_there", verb_thing_there},
    {"raw_thing_position", verb_thing_position},
    {"raw_thing_velocity", verb_thing_velocity},
    {"raw_thing_place", verb_place_thing},
    {"raw_thing_push", verb_push_thing},
    {"clear_props", verb_clear_props},
};

}  // namespace

std::span<const VerbName> thing_verbs() { return thing_list; }

}  // namespace thaum::game::inline scenario
