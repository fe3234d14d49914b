#include "game/arena/arena.h"

#include "core/text.h"
#include "game/arena/solids.h"

namespace thaum::game {
namespace {

constexpr Range place{-100, 100};
constexpr Range extent{0.01, 100};
const std::vector<std::string_view> solid_shapes{"box", "cylinder", "sphere", "ramp", "bowl"};
const std::vector<std::string_view> prop_shapes{"box", "cylinder", "sphere"};
const std::vector<std::string_view> directions{"east", "west"};

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

void read_mesh(const ConfigTable& table, std::string_view shape, Arena& arena, Body& body) {
    body.shape = physics::Shape::mesh;
    body.size = {0, 0, 0};
    body.mesh = static_cast<std::uint32_t>(arena.meshes.size());
    if (shape == "ramp") {
        const auto size = table.vector("size", extent);
        const bool east = table.choice("rises", directions) == 0;
        arena.meshes.push_back(ramp(size, east));
    } else {
        const BowlSize size{.radius = table.number("radius", extent),
                            .height = table.number("height", extent),
                            .thickness = table.number("thickness", {0.01, 1})};
        if (!arena.bowl) arena.bowl = BowlPlace{table.vector("centre", place), size};
        arena.meshes.push_back(bowl(size));
    }
}

void add_mirrored(const ConfigTable& table, Arena& arena, const Thing& thing) {
    arena.things.push_back(thing);
    if (!table.boolean("mirror", false)) return;
    Thing twin = thing;  // every shape is its own mirror image in z
    twin.position.z = -twin.position.z;
    arena.things.push_back(twin);
}

void read_solids(const ConfigTable& root, Arena& arena) {
    for (const auto& table : root.tables("solid")) {
        Thing thing;
        const auto shape = solid_shapes[table.choice("shape", solid_shapes)];
        if (shape == "ramp" || shape == "bowl") {
            read_mesh(table, shape, arena, thing.body);
        } else {
            read_shape(table, shape, thing.body);
        }
        thing.surface = read_surface(table);
        thing.position = table.vector("centre", place);
        thing.body.friction = table.number("friction", {0, 2}, 0.8);
        thing.body.layer = layer::ground;
        add_mirrored(table, arena, thing);
    }
}

/// Range of a prop's mass (kg). A stack carries up to 200 times the mass of its lightest body
/// (physics/physics.h).
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
        add_mirrored(table, arena, thing);
    }
}

void read_anchors(const ConfigTable& root, Arena& arena) {
    for (const auto& table : root.tables("anchor")) {
        const auto at = table.vector("position", place);
        arena.anchors.push_back(at);
        if (table.boolean("mirror", false)) arena.anchors.push_back({at.x, at.y, -at.z});
    }
}

void read_power_ups(const ConfigTable& root, Arena& arena) {
    static const std::vector<std::string_view> names(power_up_names.begin(), power_up_names.end());
    for (const auto& table : root.tables("power_up")) {
        const auto kind = static_cast<PowerUpKind>(table.choice("kind", names));
        const auto at = table.vector("position", place);
        arena.power_ups.push_back({kind, at});
        if (table.boolean("mirror", false)) arena.power_ups.push_back({kind, {at.x, at.y, -at.z}});
    }
}

void read_niches(const ConfigTable& root, Arena& arena) {
    for (const auto& table : root.tables("niche")) {
        const NichePlace niche{table.string("ingredient"), table.vector("position", place)};
        arena.niches.push_back(niche);
        if (table.boolean("mirror", false))
            arena.niches.push_back({niche.ingredient, niche.position * vec3(1, 1, -1)});
    }
}

Pad make_pad(vec3 feet, vec3 facing, std::int64_t player, std::size_t number) {
    const vec3 d = facing - feet;
    return {feet, det::atan2(-d.x, -d.z), static_cast<std::uint32_t>(player),
            static_cast<std::uint32_t>(number)};
}

void read_pads(const ConfigTable& root, Arena& arena) {
    bool starts[2] = {false, false};
    for (const auto& table : root.tables("pad")) {
        const auto feet = table.vector("position", place);
        const auto facing = table.vector("facing", place);
        const auto player = table.integer("player", {0, 2}, 2);
        arena.pads.push_back(make_pad(feet, facing, player, arena.pads.size()));
        const auto twin_player = table.integer("mirrored_player", {0, 2}, 2);
        if (table.boolean("mirror", false)) {
            const vec3 flip{1, 1, -1};
            arena.pads.push_back(make_pad(feet * flip, facing * flip, twin_player, arena.pads.size()));
        }
    }
    for (const auto& pad : arena.pads) {
        if (pad.player < 2) starts[pad.player] = true;
    }
    if (!starts[0] || !starts[1]) root.report("pad", "each of the players 0 and 1 needs a pad to start from");
}

}  // namespace

Arena read_arena(const Config& file) {
    Arena arena;
    const auto root = file.root();
    arena.name = root.string("name");
    read_solids(root, arena);
    read_props(root, arena);
    read_anchors(root, arena);
    read_pads(root, arena);
    read_power_ups(root, arena);
    read_niches(root, arena);
    return arena;
}

}  // namespace thaum::game
