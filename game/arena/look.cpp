#include "game/arena/look.h"

#include "game/arena/symmetry.h"

namespace thaum::game::inline arena {
namespace {

constexpr Range far_place{-1000, 1000};
constexpr Range near_place{-100, 100};
constexpr Range brightness{0, 20};

/// Reads a colour and its strength, `NAME` and `NAME_strength`. The colour may also be an integer, as in
/// older files (0xRRGGBB).
void read_tint(const ConfigTable& table, const std::string& name, Tint& tint) {
    if (const auto hex = table.hex_colour(name))
        tint.colour = *hex;
    else
        tint.colour = static_cast<std::uint32_t>(table.integer(name, {0, 0xFFFFFF}, tint.colour));
    tint.strength = table.number(name + "_strength", brightness, tint.strength);
}

void read_light(const ConfigTable& table, ArenaLook& look) {
    const auto sun = table.table("sun");
    look.towards_sun = sun.vector("towards", {-1, 1}, look.towards_sun);
    // The light of a sun at or below the horizon would come through the ground.
    if (!(look.towards_sun.y >= 0.05))
        sun.report("towards", "'towards': the height (y) must be at least 0.05");
    read_tint(sun, "colour", look.sun);
    const auto sky = table.table("sky");
    read_tint(sky, "zenith", look.zenith);
    read_tint(sky, "horizon", look.horizon);
    read_tint(sky, "sun_glow", look.sun_glow);
    const auto fog = table.table("fog");
    read_tint(fog, "colour", look.fog);
    look.fog_density = fog.number("density_per_m", {0, 1}, look.fog_density);
    const auto ambient = table.table("ambient");
    read_tint(ambient, "above", look.above);
    read_tint(ambient, "below", look.below);
}

void read_decoration(const ConfigTable& table, ArenaLook& look) {
    static const std::vector<std::string_view> sides(wall_side_names.begin(), wall_side_names.end());
    const auto walls = table.table("walls");
    look.merlons = walls.boolean("merlons", look.merlons);
    look.pilasters = walls.boolean("pilasters", look.pilasters);
    look.lamp_height = walls.number("lamp_height", near_place, look.lamp_height);
    for (const auto& lamp : table.tables("lamp")) {
        const auto at = lamp.vector("position", near_place);
        const auto symmetry = read_symmetry(lamp);
        look.lamps.push_back(at);
        if (symmetry != Symmetry::none) look.lamps.push_back(twin_place(symmetry, at));
    }
    for (const auto& banner : table.tables("banner")) {
        look.banners.push_back({.wall = static_cast<WallSide>(banner.choice("wall", sides)),
                                .along = banner.number("along", near_place),
                                .height = banner.number("height", near_place),
                                .team = static_cast<std::uint32_t>(banner.integer("team", {0, 1}))});
    }
    for (const auto& tower : table.tables("tower")) {
        look.towers.push_back({.foot = tower.vector("foot", far_place),
                               .radius = tower.number("radius", {0.1, 50}),
                               .height = tower.number("height", {1, 200})});
    }
}

}  // namespace

ArenaLook read_arena_look(const Config& file) {
    ArenaLook look;
    const auto table = file.root().table("look");
    read_light(table, look);
    read_decoration(table, look);
    const auto camera = table.table("menu_camera");
    look.menu_camera.distance = camera.number("distance", {1, 200}, look.menu_camera.distance);
    look.menu_camera.height = camera.number("height", near_place, look.menu_camera.height);
    look.menu_camera.down =
        camera.number("down_deg", {-89, 89}, look.menu_camera.down / radians_per_degree) * radians_per_degree;
    return look;
}

}  // namespace thaum::game::inline arena
