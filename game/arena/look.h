// game/arena/look.h: what a picture of an arena shows besides the solids: light, sky, and decoration around
// the walls. Read from the table `[look]` of the arena's file. It has no effect on a match.
#pragma once
#include <string_view>
#include <vector>

#include "core/config.h"

namespace thaum::game::inline arena {

/// A colour 0xRRGGBB and a factor on its linear light.
struct Tint {
    std::uint32_t colour{};
    double strength{1};
    bool operator==(const Tint&) const = default;
};

/// One of the four outer walls; south is at +z.
enum class WallSide : std::uint8_t { south, north, east, west };
inline constexpr std::array<std::string_view, 4> wall_side_names{"south", "north", "east", "west"};

/// A banner of a team on the inside of a wall.
struct BannerLook {
    WallSide wall{};
    double along{};   ///< offset from the middle of the wall, along +x or +z (m)
    double height{};  ///< height of the banner's middle (m, world)
    std::uint32_t team{};
    bool operator==(const BannerLook&) const = default;
};

/// A tower outside of the arena.
struct TowerLook {
    vec3 foot{};      ///< middle of the tower's base (m, world)
    double radius{};  ///< radius at the base (m)
    double height{};  ///< height of the tower's shaft (m)
    bool operator==(const TowerLook&) const = default;
};

/// Camera that circles the empty arena behind the start screen.
struct MenuCameraLook {
    double distance{15.5};  ///< distance from the vertical axis through the arena's middle (m)
    double height{7.5};     ///< height of the camera (m, world)
    double down{0.36};      ///< angle of the view direction below the horizon (rad)
    bool operator==(const MenuCameraLook&) const = default;
};

/// Everything in `[look]`. The defaults are dusk without towers and banners.
struct ArenaLook {
    vec3 towards_sun{0.86, 0.50, 0.16};  ///< direction towards the sun; its length has no meaning
    Tint sun{0xFFAE6C, 2.5};
    Tint zenith{0x2A1E58}, horizon{0xA0608C}, sun_glow{0xE07A40, 1.3};
    Tint fog{0x5A4274};
    double fog_density{0.0105};                        ///< density of the fog (1/m)
    Tint above{0x8078CC, 0.85}, below{0x5C4254, 0.8};  ///< light of the sky, and light from the ground
    bool merlons = true, pilasters = true;             ///< whether the outer walls have merlons and pilasters
    double lamp_height{3.4};                           ///< height of the lamps on the outer walls (m, world)
    std::vector<vec3> lamps;  ///< positions of lamps besides those on the outer walls (m,
                              ///< world)
    std::vector<BannerLook> banners;
    std::vector<TowerLook> towers;
    MenuCameraLook menu_camera;
    bool operator==(const ArenaLook&) const = default;
};

/// Reads the table `[look]`, which may be missing. Errors are collected in the Config.
ArenaLook read_arena_look(const Config& file);

}  // namespace thaum::game::inline arena
