// The pressure in a box without solids, which is solved directly.
#include <algorithm>
#include <span>

#include "fluid/detail/pressure.h"
#include "fluid/detail/staggered.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"

namespace thaum::fluid {
namespace {

/// Largest magnitude of some numbers, in which NaNs do not count.
double largest_of(std::span<const float> numbers) {
    Floats8 most{};
    const auto add = [&most](const Floats8& values) {
        most = larger(values < zero8 ? -values : values, most);
    };
    std::size_t i = 0;
    for (; i + 8 <= numbers.size(); i += 8) add(load(numbers.data() + i));
    for (; i < numbers.size(); ++i) add(Floats8{numbers[i]});
    double result = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane)
        result = std::max(result, static_cast<double>(most[lane]));
    return result;
}

}  // namespace

/// Sets potential_, and its ghosts, to the potential whose gradient has the divergence of the velocity.
void StaggeredSolver::solve_pressure(const Velocity& velocity) {
    const Split split = layers();
    each_single(*team_, split, [&](Layers slice, unsigned seat) {
        divergence(lattice_, slice, order_, velocity, packed_);
        pressure_.to_waves(packed_, slice, seat);
    });
    each_slice(*team_, Split(*team_, pressure_.blocks()),
               [&](Layers blocks, unsigned) { pressure_.divide(packed_, blocks.first, blocks.end); });
    each_single(*team_, split, [&](Layers slice, unsigned seat) {
        pressure_.from_waves(packed_, slice, seat);
        const float* packed = packed_.data() + slice.first * lattice_.cells[1] * lattice_.cells[0];
        each_row(lattice_, slice, [&](std::ptrdiff_t at) {
            std::copy_n(packed, lattice_.cells[0], potential_.data() + at);
            packed += lattice_.cells[0];
        });
        fill_ghosts(rows_, slice, all_even, potential_);
    });
}

/// Removes the divergence of a velocity in a box without solids, and fills its ghosts. Its divergence reads
/// only ghosts across the axis of each component.
void StaggeredSolver::project(Velocity& velocity) {
    each_slice(*team_, layers(), [&](Layers slice, unsigned) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            fill_ghosts_across(rows_, slice, axis, GhostRule::through_wall, velocity[axis]);
    });
    solve_pressure(velocity);
    each_single(*team_, layers(), [&](Layers layer, unsigned) {
        subtract_gradient(rows_, layer, order_, potential_, velocity);
        fill_sides_of(layer, velocity, ghosts);
    });
}

/// Largest divergence of a velocity in a box without solids (1/s).
double StaggeredSolver::largest_divergence(const Velocity& velocity) {
    const Split split = layers();
    std::array<double, max_cells> most{};
    const auto of_layer =
        static_cast<std::size_t>(lattice_.cells[0]) * static_cast<std::size_t>(lattice_.cells[1]);
    team_->each(split.slices, [&](int slice, unsigned) {
        double& found = most[static_cast<std::size_t>(slice)];
        for (int k = split[slice].first; k < split[slice].end; ++k) {
            divergence(lattice_, {k, k + 1}, order_, velocity, packed_);
            const auto layer = std::span(packed_).subspan(static_cast<std::size_t>(k) * of_layer, of_layer);
            found = std::max(found, largest_of(layer));
        }
    });
    return *std::max_element(most.begin(), most.begin() + split.slices);
}

}  // namespace thaum::fluid
