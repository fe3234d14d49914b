// game/bots/nav.h: where one can walk in an arena: a grid of 1 m cells with the height of the ground, found by asking the
// physics. It depends on the arena alone: a cache.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/physics.h"

namespace thaum::game {

class WalkGrid {
public:
    static constexpr int side = 40;             ///< cells
    static constexpr double half = side / 2.0;  ///< m
    static constexpr std::uint16_t unreachable = 0xffff;

    explicit WalkGrid(const physics::Physics& physics);

    /// The cell under a place, clamped to the grid.
    static int cell_at(vec3 place);
    static vec3 centre_of(int cell);
    bool walkable(int cell) const { return height_[static_cast<std::size_t>(cell)] > blocked; }

    /// Of the ground in a walkable cell, m.
    double height(int cell) const { return height_[static_cast<std::size_t>(cell)]; }

    /// Steps to a goal from every cell (breadth first); memory is used again.
    struct Ways {
        int goal = -1;
        std::vector<std::uint16_t> steps;  ///< unreachable where there is no way
        std::vector<int> queue;
    };
    void find_ways(int goal, Ways& ways) const;
    /// The neighbour of `cell` that is nearest to the goal; `cell` itself at the goal or where there is no way.
    int next(int cell, const Ways& ways) const;
    /// Can one walk straight from here to there, at most a few metres?
    bool straight(vec3 from, vec3 to) const;

private:
    static constexpr double blocked = -1e9;
    /// Can one walk from a cell to a neighbour of it? A drop counts as no: one would not come back.
    bool passable(int from, int to) const;
    template <class Visit>
    void neighbours(int cell, Visit&& visit) const;

    std::vector<double> height_;
};

}  // namespace thaum::game
