// game/bots/nav.h: walkable ground of an arena: a grid of 1 m cells with the height of the ground, measured
// by sweeps through the physics. The grid depends on the arena alone, so it is a cache.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/physics.h"

namespace thaum::game {

/// Grid of walkable cells with a search for ways.
class WalkGrid {
public:
    static constexpr int side = 40;             ///< number of cells along each side
    static constexpr double half = side / 2.0;  ///< half the length of a side (m)
    static constexpr std::uint16_t unreachable = 0xffff;

    explicit WalkGrid(const physics::Physics& physics);

    /// The cell under a position, clamped to the grid.
    static int cell_at(vec3 place);
    static vec3 centre_of(int cell);
    bool walkable(int cell) const { return height_[static_cast<std::size_t>(cell)] > blocked; }

    /// Height of the ground in a walkable cell (m, world).
    double height(int cell) const { return height_[static_cast<std::size_t>(cell)]; }

    /// Number of steps to a goal from every cell, found by breadth-first search. Its memory is reused.
    struct Ways {
        int goal = -1;
        std::vector<std::uint16_t> steps;  ///< `unreachable` for a cell without a way to the goal
        std::vector<int> queue;
    };
    void find_ways(int goal, Ways& ways) const;
    /// The neighbour of `cell` nearest to the goal; `cell` itself at the goal, or if there is no way.
    int next(int cell, const Ways& ways) const;
    /// Whether the straight line between two places, a few metres at most, can be walked.
    bool straight(vec3 from, vec3 to) const;

private:
    static constexpr double blocked = -1e9;
    /// Whether a step from a cell to a neighbour is possible. A drop is not, because there would be no way
    /// back.
    bool passable(int from, int to) const;
    template <class Visit>
    void neighbours(int cell, Visit&& visit) const;

    std::vector<double> height_;
};

}  // namespace thaum::game
