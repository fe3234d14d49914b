// game/arena/arena.h: an arena as described by its data file in assets/arenas.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "game/arena/solids.h"
#include "game/components/body.h"
#include "game/components/power_up.h"

namespace thaum::game::inline arena {

/// A body of the arena and its look. Ramps and bowls are static meshes.
struct Thing {
    Body body;
    Surface surface{};
    vec3 position{};
    bool prop = false;
    bool operator==(const Thing&) const = default;
};

/// The first bowl among the solids. It holds a cauldron if the match's rules have one.
struct BowlPlace {
    vec3 centre{};
    BowlSize size{};
    bool operator==(const BowlPlace&) const = default;
};

/// Niche of the cauldron: a place where wizards pick up an ingredient.
struct NichePlace {
    std::string ingredient;
    vec3 position{};  ///< position of the niche on the ground (m, world)
    bool operator==(const NichePlace&) const = default;
};

struct PowerUpPlace {
    PowerUpKind kind{};
    vec3 position{};  ///< position on the ground (m, world)
    bool operator==(const PowerUpPlace&) const = default;
};

struct Arena {
    std::string name;
    /// Meshes of ramps and bowls; Body::mesh is an index into this list.
    std::vector<physics::TriangleMesh> meshes;
    std::vector<Thing> things;  ///< static bodies and props (loose things), in the order of the file
    std::vector<vec3> anchors;
    std::vector<Pad> pads;
    std::vector<PowerUpPlace> power_ups;
    std::optional<BowlPlace> bowl;
    std::vector<NichePlace> niches;  ///< niches, places where wizards pick up ingredients for the cauldron
    /// places of the player and of the dummy on the practice range
    std::array<Pad, 2> practice{};
    bool operator==(const Arena&) const = default;
};

/// Box around all ground (solids with the surface floor or pit) (m, world). `low.y` is the height of the
/// lowest ground, `high.y` that of the highest.
struct GroundBounds {
    vec3 low{}, high{};
};
/// Bounds of the arena's ground. All zero for an arena without ground, which read_arena refuses.
GroundBounds ground_bounds(const Arena& arena);

/// The scrying orb: the first sphere with the surface orb; null if the arena has none.
const Thing* orb_of(const Arena& arena);

/// Whether a body is a crystal that can be carved: a box with the surface crystal.
bool is_crystal(Surface surface, physics::Shape shape);

/// Reads all tables of an arena's file except `[look]` (look.h). Errors are collected in the Config
/// (core/config.h).
Arena read_arena(const Config& file);

}  // namespace thaum::game::inline arena
