// game/bots/nav.h: walkable ground of an arena: a grid of 1 m cells with the height of the highest ground in
// each, measured by sweeps through the physics. The grid depends on the arena alone, so it is a cache.
#pragma once
#include <cstdint>
#include <vector>

#include "game/arena/arena.h"
#include "physics/physics.h"

namespace thaum::game::inline bots {

/// Height of a fall that costs a wizard more than a few points of health (m).
inline constexpr double hurtful_drop = 3.5;

/// Grid of walkable cells, with a search for shortest ways.
class WalkGrid {
public:
    static constexpr std::uint16_t unreachable = 0xffff;

    /// Measures the ground within the bounds.
    WalkGrid(const physics::Physics& physics, const GroundBounds& ground);

    int cells() const { return static_cast<int>(height_.size()); }
    /// The cell under a position, clamped to the grid.
    int cell_at(vec3 place) const;
    vec3 centre_of(int cell) const;
    /// Whether a position lies over the grid.
    bool covers(vec3 place) const;
    bool walkable(int cell) const { return height_[static_cast<std::size_t>(cell)] > blocked; }

    /// Height of the ground in a walkable cell (m, world).
    double height(int cell) const { return height_[static_cast<std::size_t>(cell)]; }

    /// Number of steps to a goal from every cell, found by breadth-first search. Its memory is reused.
    struct Ways {
        int goal = -1;
        /// Number of steps from each cell; `unreachable`: there is no way to the goal.
        std::vector<std::uint16_t> steps;
        std::vector<int> queue;
    };
    void find_ways(int goal, Ways& ways) const;
    /// The neighbour of `cell` that is nearest to the goal by number of steps; `cell` itself at the goal, or
    /// if there is no way.
    int next(int cell, const Ways& ways) const;
    /// Whether the cell is in one of the large regions of connected walkable cells. The top of a block is in
    /// none, nor is a cell that a thing fills in part.
    bool in_large_region(int cell) const { return in_large_region_[static_cast<std::size_t>(cell)] != 0; }
    /// The neighbour of `cell` that is in a large region and at most a step above the feet. Of several, the
    /// one nearest to the feet in distance and height; `cell` itself if there is none.
    int nearest_way(int cell, vec3 feet) const;
    /// Whether the straight line between two places, a few metres at most, can be walked.
    bool straight(vec3 from, vec3 to) const;
    /// Whether the straight line between two places, a few metres at most, leads over walkable ground and
    /// over an edge. The ground below such an edge lies deeper by more than hurtful_drop.
    bool over_edge(vec3 from, vec3 to) const;

private:
    static constexpr double blocked = -1e9;
    /// Whether a step from a cell to a neighbour is possible. A drop is not, because there would be no way
    /// back.
    bool passable(int from, int to) const;
    /// Calls visit(number of the neighbour) for each neighbour to which a step is open.
    template <class Visit>
    void neighbours(int cell, Visit&& visit) const;
    std::uint8_t open_steps_from(int cell) const;
    void find_large_regions();

    double west_{}, north_{};  ///< the least x and z of the grid (m, world)
    int columns_{}, rows_{};
    std::vector<double> height_;
    /// Open steps from each cell, one bit for each direction. Every search for ways needs all of them, so
    /// they are found once.
    std::vector<std::uint8_t> open_steps_;
    std::vector<std::uint8_t> in_large_region_;  ///< 1: the cell is in one of the large connected regions
};

}  // namespace thaum::game::inline bots
