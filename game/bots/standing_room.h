// game/bots/standing_room.h: tells whether a wizard can stand at a place of an arena.
#pragma once
#include <filesystem>

#include "game/match/simulation.h"

namespace thaum::game::inline bots {

class StandingRoom {
public:
    /// Reads an arena of assets/arenas. The error names file, line and key.
    static Expected<StandingRoom> load(const std::filesystem::path& assets, const std::string& arena);

    /// Why a wizard cannot stand with its feet at a place (m, world): "is outside the walls". Empty: it can.
    std::string_view fault_at(vec3 feet) const;

private:
    explicit StandingRoom(std::shared_ptr<const MatchData> data);
    bool is_inside_walls(vec3 feet) const;
    bool is_in_bowl(vec3 feet) const;
    bool is_in_solid(vec3 feet) const;
    bool has_ground(vec3 feet) const;

    std::shared_ptr<const MatchData> data_;
    std::shared_ptr<const Simulation> match_;  ///< a match in that arena before its first tick, for its
                                               ///< physics
};

}  // namespace thaum::game::inline bots
