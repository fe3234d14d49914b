// game/arena/solids.h: closed triangle meshes of ramps and bowls, shapes for which Bullet has no primitives.
#pragma once
#include <array>
#include <string_view>

#include "physics/physics.h"

namespace thaum::game::inline arena {

/// Direction in which a ramp rises: +x, -x, -z, +z.
enum class Rise : std::uint8_t { east, west, north, south };
inline constexpr std::array<std::string_view, 4> rise_names{"east", "west", "north", "south"};

/// A wedge that fills half of a box of the given size (m); the origin is the middle of the box.
physics::TriangleMesh ramp(vec3 size, Rise rise);

struct BowlSize {
    double radius{};     ///< radius of the bowl's rim (m)
    double height{};     ///< height of the whole bowl (m)
    double thickness{};  ///< thickness of the bowl's wall (m)
    bool operator==(const BowlSize&) const = default;
};

/// A solid of revolution about the y axis with a foot, a rounded body and an open top. The origin is on the
/// axis at half the height.
physics::TriangleMesh bowl(const BowlSize& size);

/// Profile of the bowl as points (radius, y) in m. It first follows the outside from the middle of the foot
/// up to the rim, then the inside down to the middle of the floor.
std::vector<vec2> bowl_profile(const BowlSize& size);

}  // namespace thaum::game::inline arena
