#include "game/bots/nav.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "game/components/body.h"

namespace thaum::game::inline bots {
namespace {

constexpr double body_radius = 0.4;  ///< radius of the sphere that tests ways (m); a wizard's is less
/// Height above the highest ground from which the ground is searched downwards (m). Things higher up block no
/// wizard.
constexpr double headroom = 2.5;
/// Depth below the lowest ground to which the ground is searched (m).
constexpr double depth = 15;
/// Largest height difference between neighbouring cells (m): ramps are walkable, ledges are not.
constexpr double highest_step = 0.75;
/// Least size of a connected walkable region that counts as large, as a share of the largest region's size.
constexpr double large_share = 0.25;

/// A step to a neighbouring cell, in columns and rows.
struct Step {
    int columns, rows;
};
/// The steps to all neighbours, in the order in which a search tries them: straight ones, then diagonals.
constexpr std::array<Step, 8> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

}  // namespace

WalkGrid::WalkGrid(const physics::Physics& physics, const GroundBounds& ground)
    : west_(std::floor(ground.low.x)),
      north_(std::floor(ground.low.z)),
      columns_(std::max(1, static_cast<int>(std::ceil(ground.high.x - west_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(ground.high.z - north_)))),
      height_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), blocked) {
    const double above = ground.high.y + headroom, below = ground.low.y - depth;
    for (int cell = 0; cell < cells(); ++cell) {
        const vec3 centre = centre_of(cell);
        const vec3 from{centre.x, above, centre.z};
        const vec3 to{centre.x, below, centre.z};
        const auto hit = physics.sweep_sphere(from, to, body_radius, layer::ground);
        if (hit && hit->fraction > 0) {
            height_[static_cast<std::size_t>(cell)] = above + (below - above) * hit->fraction - body_radius;
        }
    }
    for (int cell = 0; cell < cells(); ++cell) open_steps_.push_back(open_steps_from(cell));
    find_large_regions();
}

int WalkGrid::cell_at(vec3 place) const {
    const auto index = [](double offset, int count) {
        return static_cast<int>(std::clamp(std::floor(offset), 0.0, count - 1.0));
    };
    return index(place.z - north_, rows_) * columns_ + index(place.x - west_, columns_);
}

vec3 WalkGrid::centre_of(int cell) const {
    const int column = cell % columns_;
    const int row = cell / columns_;
    return {west_ + column + 0.5, 0, north_ + row + 0.5};
}

bool WalkGrid::covers(vec3 place) const {
    const double x = place.x - west_, z = place.z - north_;
    return x >= 0 && x < columns_ && z >= 0 && z < rows_;
}

bool WalkGrid::passable(int from, int to) const {
    return walkable(from) && walkable(to) &&
           std::abs(height_[static_cast<std::size_t>(from)] - height_[static_cast<std::size_t>(to)]) <
               highest_step;
}

std::uint8_t WalkGrid::open_steps_from(int cell) const {
    const int x = cell % columns_;
    const int z = cell / columns_;
    const auto open = [&](int dx, int dz) {
        const int nx = x + dx;
        const int nz = z + dz;
        return nx >= 0 && nx < columns_ && nz >= 0 && nz < rows_ && passable(cell, nz * columns_ + nx);
    };
    // A diagonal step is open only if both ways round its corner can be walked to the end, so that the way
    // back is open, too.
    const auto open_diagonally = [&](int dx, int dz) {
        const int there = cell + dz * columns_ + dx;
        return open(dx, dz) && open(dx, 0) && open(0, dz) && passable(cell + dx, there) &&
               passable(cell + dz * columns_, there);
    };
    unsigned found = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto [dx, dz] = steps[i];
        const bool straight_step = dx == 0 || dz == 0;
        if (straight_step ? open(dx, dz) : open_diagonally(dx, dz)) found |= 1U << i;
    }
    return static_cast<std::uint8_t>(found);
}

template <class Visit>
void WalkGrid::neighbours(int cell, Visit&& visit) const {
    for (unsigned left = open_steps_[static_cast<std::size_t>(cell)]; left != 0; left &= left - 1) {
        const auto& step = steps[static_cast<std::size_t>(std::countr_zero(left))];
        visit(cell + step.rows * columns_ + step.columns);
    }
}

void WalkGrid::find_ways(int goal, Ways& ways) const {
    ways.goal = goal;
    ways.steps.assign(height_.size(), unreachable);
    ways.queue.clear();
    ways.queue.reserve(height_.size());
    ways.queue.push_back(goal);
    ways.steps[static_cast<std::size_t>(goal)] = 0;
    for (std::size_t i = 0; i < ways.queue.size(); ++i) {
        const int cell = ways.queue[i];
        neighbours(cell, [&](int n) {
            auto& steps = ways.steps[static_cast<std::size_t>(n)];
            if (steps != unreachable) return;
            steps = static_cast<std::uint16_t>(ways.steps[static_cast<std::size_t>(cell)] + 1);
            ways.queue.push_back(n);
        });
    }
}

int WalkGrid::next(int cell, const Ways& ways) const {
    int best = cell;
    neighbours(cell, [&](int n) {
        if (ways.steps[static_cast<std::size_t>(n)] < ways.steps[static_cast<std::size_t>(best)]) best = n;
    });
    return best;
}

void WalkGrid::find_large_regions() {
    std::vector<std::vector<int>> regions;
    std::vector<bool> known(height_.size(), false);
    std::size_t largest = 0;
    Ways ways;
    for (int cell = 0; cell < cells(); ++cell) {
        if (known[static_cast<std::size_t>(cell)] || !walkable(cell)) continue;
        find_ways(cell, ways);
        for (const int found : ways.queue) known[static_cast<std::size_t>(found)] = true;
        largest = std::max(largest, ways.queue.size());
        regions.push_back(ways.queue);
    }
    in_large_region_.assign(height_.size(), 0);
    for (const auto& region : regions) {
        if (static_cast<double>(region.size()) < large_share * static_cast<double>(largest)) continue;
        for (const int cell : region) in_large_region_[static_cast<std::size_t>(cell)] = 1;
    }
}

int WalkGrid::nearest_way(int cell, vec3 feet) const {
    int best = cell;
    double nearest = std::numeric_limits<double>::max();
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
            const vec3 place = centre_of(cell) + vec3(dx, 0, dz);
            const int there = cell_at(place);
            if (!covers(place) || !in_large_region(there) || height(there) > feet.y + highest_step) continue;
            const double along = glm::distance(vec2(place.x, place.z), vec2(feet.x, feet.z));
            const double drop = std::max(0.0, feet.y - height(there));
            if (along + drop < nearest) nearest = along + drop, best = there;
        }
    }
    return best;
}

bool WalkGrid::over_edge(vec3 from, vec3 to) const {
    const int samples = 1 + static_cast<int>(4 * glm::distance(from, to));
    int cell = cell_at(from);
    for (int i = 1; i <= samples; ++i) {
        const int next = cell_at(from + (to - from) * (static_cast<double>(i) / samples));
        if (!walkable(cell) || !walkable(next)) return false;
        if (height(cell) - height(next) > hurtful_drop) return true;
        if (next != cell && !passable(cell, next)) return false;
        cell = next;
    }
    return false;
}

bool WalkGrid::straight(vec3 from, vec3 to) const {
    const int samples = 1 + static_cast<int>(4 * glm::distance(from, to));
    int cell = cell_at(from);
    for (int i = 1; i <= samples; ++i) {
        const int next = cell_at(from + (to - from) * (static_cast<double>(i) / samples));
        if (next != cell && !passable(cell, next)) return false;
        cell = next;
    }
    return true;
}

}  // namespace thaum::game::inline bots
