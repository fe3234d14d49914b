#include "game/arena/arena.h"

#include <algorithm>
#include <limits>

#include "core/one_line.h"
#include "core/text.h"
#include "game/arena/placement.h"
#include "game/arena/solids.h"
#include "game/arena/symmetry.h"

namespace thaum::game::inline arena {
namespace {

constexpr Range place{-100, 100};
constexpr Range extent{0.01, 100};
const std::vector<std::string_view> solid_shapes{"box", "cylinder", "sphere", "ramp", "bowl"};
const std::vector<std::string_view> prop_shapes{"box", "cylinder", "sphere"};
const std::vector<std::string_view> rises(rise_names.begin(), rise_names.end());

Surface read_surface(const ConfigTable& table) {
    static const std::vector<std::string_view> names(surface_names.begin(), surface_names.end());
    return static_cast<Surface>(table.choice("surface", names));
}

/// Reads shape and size of a box, cylinder or sphere.
void read_shape(const ConfigTable& table, std::string_view shape, Body& body) {
    if (shape == "box") {
        body.shape = physics::Shape::box;
        body.size = table.vector("size", extent) * 0.5;
    } else if (shape == "cylinder") {
        body.shape = physics::Shape::cylinder;
        body.size = {table.number("radius", extent), table.number("height", extent) / 2, 0};
    } else {
        body.shape = physics::Shape::sphere;
        body.size = {table.number("radius", extent), 0, 0};
    }
}

void read_bowl(const ConfigTable& table, Arena& arena, Body& body) {
    body.shape = physics::Shape::mesh;
    body.size = {0, 0, 0};
    body.mesh = static_cast<std::uint32_t>(arena.meshes.size());
    const BowlSize size{.radius = table.number("radius", extent),
                        .height = table.number("height", extent),
                        .thickness = table.number("thickness", {0.01, 1})};
    // With these limits, the bowl's solid bottom is within the lowest fifth of its height. So there is hollow
    // space below the brew, wherever the data file may put the brew's surface.
    if (size.thickness > 0.2 * size.height || size.thickness > 0.4 * size.radius)
        table.report("thickness",
                     text("'thickness' is ", size.thickness,
                          ", and must be at most 0.2 times the height and 0.4 times the radius"));
    if (arena.bowl || read_symmetry(table) != Symmetry::none)
        table.report("shape", "a second bowl: only one can be the cauldron");
    if (!arena.bowl) arena.bowl = BowlPlace{table.vector("centre", place), size};
    arena.meshes.push_back(bowl(size));
}

Rise opposite(Rise rise) {
    constexpr std::array<Rise, 4> opposites{Rise::west, Rise::east, Rise::south, Rise::north};
    return opposites[static_cast<std::size_t>(rise)];
}

Rise twin_rise(Symmetry symmetry, Rise rise) {
    const bool along_z = rise == Rise::north || rise == Rise::south;
    const bool reversed = symmetry == Symmetry::turned || (symmetry == Symmetry::mirror && along_z);
    return reversed ? opposite(rise) : rise;
}

/// Adds the mesh of a ramp, and the mesh of the ramp's mirrored or turned copy if that differs. Returns the
/// index of the copy's mesh.
std::uint32_t read_ramp(const ConfigTable& table, Symmetry symmetry, Arena& arena, Body& body) {
    const auto size = table.vector("size", extent);
    const auto rise = static_cast<Rise>(table.choice("rises", rises));
    body.shape = physics::Shape::mesh;
    body.size = {0, 0, 0};
    body.mesh = static_cast<std::uint32_t>(arena.meshes.size());
    arena.meshes.push_back(ramp(size, rise));
    const auto twin = twin_rise(symmetry, rise);
    if (twin == rise) return body.mesh;
    arena.meshes.push_back(ramp(size, twin));
    return body.mesh + 1;
}

/// Adds a thing and its mirrored or turned copy. Only a ramp needs another mesh for its copy: all other
/// shapes look the same mirrored or turned.
void add_thing(Symmetry symmetry, Arena& arena, const Thing& thing) {
    arena.things.push_back(thing);
    if (symmetry == Symmetry::none) return;
    Thing twin = thing;
    twin.position = twin_place(symmetry, thing.position);
    arena.things.push_back(twin);
}

void read_solids(const ConfigTable& root, Arena& arena) {
    for (const auto& table : root.tables("solid")) {
        Thing thing;
        const auto shape = solid_shapes[table.choice("shape", solid_shapes)];
        const auto symmetry = read_symmetry(table);
        std::optional<std::uint32_t> twin_mesh;
        if (shape == "bowl") {
            read_bowl(table, arena, thing.body);
        } else if (shape == "ramp") {
            twin_mesh = read_ramp(table, symmetry, arena, thing.body);
        } else {
            read_shape(table, shape, thing.body);
        }
        thing.surface = read_surface(table);
        thing.position = table.vector("centre", place);
        thing.body.friction = table.number("friction", {0, 2}, 0.8);
        thing.body.layer = layer::ground;
        if (thing.surface == Surface::orb && shape == "sphere" &&
            (orb_of(arena) != nullptr || symmetry != Symmetry::none))
            table.report("surface", "a second orb: only one can be looked into");
        add_thing(symmetry, arena, thing);
        if (twin_mesh && symmetry != Symmetry::none) arena.things.back().body.mesh = *twin_mesh;
    }
}

/// Range of the mass of a prop (a loose thing) (kg). A stack carries up to 200 times the mass of its lightest
/// body (physics/physics.h).
constexpr Range prop_mass{1, 200};

void read_props(const ConfigTable& root, Arena& arena) {
    for (const auto& table : root.tables("prop")) {
        Thing thing;
        thing.prop = true;
        read_shape(table, prop_shapes[table.choice("shape", prop_shapes)], thing.body);
        thing.surface = read_surface(table);
        thing.position = table.vector("position", place);
        thing.body.mass = table.number("mass", prop_mass);
        thing.body.friction = table.number("friction", {0, 2}, 0.8);
        thing.body.restitution = table.number("restitution", {0, 1}, 0.1);
        thing.body.layer = layer::prop;
        if (thing.body.shape != physics::Shape::box) thing.body.rolling_friction = 0.01;
        add_thing(read_symmetry(table), arena, thing);
    }
}

void refuse_outside(const ConfigTable& table, const GroundBounds& ground, vec3 at, std::string_view key) {
    if (at.x >= ground.low.x && at.x <= ground.high.x && at.z >= ground.low.z && at.z <= ground.high.z)
        return;
    table.report(key, text("'", key, "' lies outside of the arena's ground, x from ", ground.low.x, " to ",
                           ground.high.x, ", z from ", ground.low.z, " to ", ground.high.z));
}

/// Calls add(place) for the position of an entry of the arena's file, and for that of its mirrored or turned
/// copy. A position outside of the ground is an error.
template <class Add>
void read_places(const ConfigTable& table, const GroundBounds& ground, Add&& add) {
    const auto at = table.vector("position", place);
    const auto symmetry = read_symmetry(table);
    refuse_outside(table, ground, at, "position");
    add(at);
    if (symmetry != Symmetry::none) add(twin_place(symmetry, at));
}

void read_anchors(const ConfigTable& root, const GroundBounds& ground, Arena& arena) {
    for (const auto& table : root.tables("anchor"))
        read_places(table, ground, [&](vec3 at) { arena.anchors.push_back(at); });
}

void read_power_ups(const ConfigTable& root, const GroundBounds& ground, Arena& arena) {
    static const std::vector<std::string_view> names(power_up_names.begin(), power_up_names.end());
    for (const auto& table : root.tables("power_up")) {
        const auto kind = static_cast<PowerUpKind>(table.choice("kind", names));
        read_places(table, ground, [&](vec3 at) { arena.power_ups.push_back({kind, at}); });
    }
}

void read_niches(const ConfigTable& root, const GroundBounds& ground, Arena& arena) {
    for (const auto& table : root.tables("niche")) {
        const auto ingredient = table.string("ingredient");
        read_places(table, ground, [&](vec3 at) { arena.niches.push_back({ingredient, at}); });
    }
}

Pad make_pad(vec3 feet, vec3 facing, std::int64_t player, std::size_t number) {
    const vec3 d = facing - feet;
    return {feet, det::atan2(-d.x, -d.z), static_cast<std::uint32_t>(player),
            static_cast<std::uint32_t>(number)};
}

void read_pads(const ConfigTable& root, const GroundBounds& ground, Arena& arena) {
    bool starts[2] = {false, false};
    for (const auto& table : root.tables("pad")) {
        const auto feet = table.vector("position", place);
        const auto facing = table.vector("facing", place);
        const auto player = table.integer("player", {0, 2}, 2);
        refuse_outside(table, ground, feet, "position");
        arena.pads.push_back(make_pad(feet, facing, player, arena.pads.size()));
        const auto symmetry = read_symmetry(table);
        const auto twin_key = symmetry == Symmetry::turned ? "turned_player" : "mirrored_player";
        const auto twin_player = table.integer(twin_key, {0, 2}, 2);
        if (symmetry != Symmetry::none) {
            arena.pads.push_back(make_pad(twin_place(symmetry, feet), twin_place(symmetry, facing),
                                          twin_player, arena.pads.size()));
        }
    }
    for (const auto& pad : arena.pads) {
        if (pad.player < 2) starts[pad.player] = true;
    }
    if (!starts[0] || !starts[1]) root.report("pad", "each of the players 0 and 1 needs a pad to start from");
}

/// Reads `[range]`, the places of player and dummy on the practice range. Without this table, practice takes
/// place at the pads where players start.
void read_practice(const ConfigTable& root, const GroundBounds& ground, Arena& arena) {
    constexpr std::array<std::string_view, 2> names{"player", "dummy"};
    const auto range = root.table("range");
    for (std::uint32_t player = 0; player < arena.practice.size(); ++player) {
        auto& pad = arena.practice[player];
        for (const auto& start : arena.pads) {
            if (start.player == player) pad = start;
        }
        pad.player = pad.number = player;
        if (!root.has("range")) continue;
        const auto table = range.table(names[player]);
        pad.feet = table.vector("place", place);
        pad.yaw = table.number("yaw_deg", {-360, 360}) * radians_per_degree;
        refuse_outside(table, ground, pad.feet, "place");
    }
}

bool is_ground(const Thing& thing) {
    return !thing.prop && (thing.surface == Surface::floor || thing.surface == Surface::pit);
}

/// Half the extent of a thing along the axes (m).
vec3 half_extent(const Arena& arena, const Thing& thing) {
    switch (thing.body.shape) {
        case physics::Shape::box: return thing.body.size;
        case physics::Shape::sphere: return vec3(thing.body.size.x);
        case physics::Shape::mesh: break;
        default: return {thing.body.size.x, thing.body.size.y, thing.body.size.x};
    }
    vec3 half(0);
    for (const auto& v : arena.meshes[thing.body.mesh].vertices) half = glm::max(half, glm::abs(v));
    return half;
}

/// Reads the display name of an arena. The name is printed unchanged, so it may hold no control characters.
std::string read_name(const ConfigTable& root) {
    constexpr std::size_t longest_name = 64;  // largest length of an arena's name (bytes)
    auto name = root.string("name");
    if (name.empty() || printable(name, longest_name) != name)
        root.report("name", text("'name' must be a line of 1 to ", longest_name,
                                 " bytes without control characters"));
    return name;
}

}  // namespace

const Thing* orb_of(const Arena& arena) {
    const auto found = std::find_if(arena.things.begin(), arena.things.end(), [](const Thing& thing) {
        return thing.surface == Surface::orb && thing.body.shape == physics::Shape::sphere;
    });
    return found == arena.things.end() ? nullptr : &*found;
}

bool is_crystal(Surface surface, physics::Shape shape) {
    return surface == Surface::crystal && shape == physics::Shape::box;
}

GroundBounds ground_bounds(const Arena& arena) {
    constexpr double huge = std::numeric_limits<double>::max();
    GroundBounds bounds{vec3(huge), vec3(-huge)};
    for (const auto& thing : arena.things) {
        if (!is_ground(thing)) continue;
        const vec3 half = half_extent(arena, thing);
        vec3 low = thing.position - half;
        const vec3 high = thing.position + half;
        if (thing.body.shape != physics::Shape::mesh)
            // Only a ramp can be walked on below its top; any other thing is ground at its top alone.
            low.y = high.y;
        bounds.low = glm::min(bounds.low, low);
        bounds.high = glm::max(bounds.high, high);
    }
    return bounds.low.x <= bounds.high.x ? bounds : GroundBounds{};
}

Arena read_arena(const Config& file) {
    Arena arena;
    const auto root = file.root();
    arena.name = read_name(root);
    read_solids(root, arena);
    if (std::none_of(arena.things.begin(), arena.things.end(), is_ground))
        root.report("solid", "an arena needs at least one solid with the surface 'floor'");
    const auto ground = ground_bounds(arena);
    read_props(root, arena);
    read_anchors(root, ground, arena);
    read_pads(root, ground, arena);
    read_power_ups(root, ground, arena);
    read_niches(root, ground, arena);
    read_practice(root, ground, arena);
    if (file.is_sound()) check_placement(root, arena);
    return arena;
}

}  // namespace thaum::game::inline arena
