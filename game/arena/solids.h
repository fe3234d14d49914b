// game/arena/solids.h: the arena's shapes that are not primitives, as closed triangle meshes for Bullet.
#pragma once
#include "physics/physics.h"

namespace thaum::game {

/// Half a box of that size (m), centred on it: a wedge that rises towards +x (east) or -x.
physics::TriangleMesh ramp(vec3 size, bool rises_east);

struct BowlSize {
    double radius{};     ///< m, of the rim
    double height{};     ///< m
    double thickness{};  ///< m, of the wall
    bool operator==(const BowlSize&) const = default;
};

/// A solid of revolution about y, centred at half its height: a foot, a belly, an open top.
physics::TriangleMesh bowl(const BowlSize& size);

/// The bowl's profile, (radius, y), outside from the foot's centre up, then inside down to the middle of the floor.
std::vector<vec2> bowl_profile(const BowlSize& size);

}  // namespace thaum::game
