// game/arena/arena.h: the place of a match, as its file describes it (assets/arenas).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "game/arena/solids.h"
#include "game/components/body.h"
#include "game/components/power_up.h"

namespace thaum::game {

/// One thing of the arena: a body and its look. Ramps and the bowl are static meshes.
struct Thing {
    Body body;
    Surface surface{};
    vec3 position{};
    bool prop = false;
    bool operator==(const Thing&) const = default;
};

/// The first bowl among the solids: a cauldron stands in it where the rule set has one.
struct BowlPlace {
    vec3 centre{};
    BowlSize size{};
    bool operator==(const BowlPlace&) const = default;
};

struct NichePlace {
    std::string ingredient;
    vec3 position{};  ///< m, on the ground
    bool operator==(const NichePlace&) const = default;
};

struct PowerUpPlace {
    PowerUpKind kind{};
    vec3 position{};  ///< m, on the ground
    bool operator==(const PowerUpPlace&) const = default;
};

struct Arena {
    std::string name;
    std::vector<physics::TriangleMesh> meshes;  ///< Body::mesh counts in here
    std::vector<Thing> things;                  ///< static ones and props, in the order of the file
    std::vector<vec3> anchors;
    std::vector<Pad> pads;
    std::vector<PowerUpPlace> power_ups;
    std::optional<BowlPlace> bowl;
    std::vector<NichePlace> niches;  ///< of ingredients for it
    bool operator==(const Arena&) const = default;
};

/// Reads `[[solid]]`, `[[anchor]]`, `[[pad]]`, `[[prop]]`, `[[power_up]]` and `[[niche]]`; faults stay in the Config (core/config.h).
Arena read_arena(const Config& file);

}  // namespace thaum::game
