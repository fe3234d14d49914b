#include "fluid/detail/solids.h"

#include <algorithm>
#include <cmath>

#include "fluid/detail/independent_iterations.h"
#include "fluid/detail/part_of_row.h"
#include "fluid/detail/sums.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"

namespace thaum::fluid {
namespace {

// Extra term of the preconditioner for a cell that solids mostly close off: own_part h^2 (1 / d - 1 /
// own_below), where d is the sum of the shares of the cell's six faces that no solid covers. With these
// values the pressure solve of the game's cauldron takes 4.2 iterations; with h^2 / d it took 6.2.
constexpr double own_part = 0.8, own_below = 5;
// Conjugate gradients run in rounds. This is the factor by which a round reduces the residual, and the
// largest number of rounds. In float, the search stops converging at a few thousandths of the initial
// residual. The residual is then computed again from the corrected velocity, and the next round begins. Its
// search direction stays conjugate to the last one, because restarting the search would cost a third of an
// iteration per step.
constexpr double gain_of_round = 2e-3;
constexpr int max_rounds = 4;

double total(const Floats8& values) {
    double sum = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) sum += static_cast<double>(values[lane]);
    return sum;
}

/// The larger number; NaN if one of them is NaN.
double larger_or_nan(double a, double b) { return b > a || std::isnan(b) ? b : a; }

/// Adds a multiple of an array to another one in some layers: to += part * from.
void add(const Rows& rows, Layers layers, Samples& to, double part, const Samples& from) {
    const auto factor = static_cast<float>(part);
    each_row(rows, layers, [&](Row row) {
        float* x = to.data() + row.at;
        const float* y = from.data() + row.at;
        for (std::ptrdiff_t i = 0; i < row.count; i += 8)
            store_within_row(x + i, load(x + i) + factor * load(y + i), row.count - i);
    });
}

/// Fills the ghost cells of the potential at periodic sides only. At walls this is not needed: walls count as
/// closed faces, and values beyond closed faces have no effect.
void fill_round(const Rows& rows, Samples& potential) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (rows.lattice.edges[axis] == Edge::periodic)
            fill_ghosts_across(rows, axis, GhostRule::even, potential);
}

}  // namespace

Solids::Solids(const Lattice& lattice, const SolidShare& solid, double min_share)
    : lattice_(lattice), box_(lattice, 2) {
    for (auto* samples : {&residual_, &smoothed_, &direction_, &image_, &correction_})
        *samples = make_samples(lattice);
    // The array has eight more values, so that vectors of the last row may be read past its end.
    packed_.resize(static_cast<std::size_t>(lattice.cells[0]) * static_cast<std::size_t>(lattice.cells[1]) *
                       static_cast<std::size_t>(lattice.cells[2]) +
                   8);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        open_[axis] = make_samples(lattice);
        each_cell(lattice, [&](int i, int j, int k, std::size_t at) {
            const OpenPart part = open_part(solid, lattice.h * vec3(i, j, k), axis, lattice.h);
            if (part.share < min_share) return;
            open_[axis][at] = static_cast<float>(part.share);
            if (part.share < 1) cut_faces_[axis].push_back({at, part.middle});
        });
        std::array<GhostRule, 3> rule = all_even;
        rule[axis] = GhostRule::through_wall;
        fill_ghosts(lattice, rule, open_[axis]);
    }
    diagonal_ = openness(lattice, open_);
    own_ = make_samples(lattice);
    std::ranges::transform(diagonal_, own_.begin(), [h2 = lattice.h * lattice.h](float d) {
        const double more = d > 0 ? 1 / static_cast<double>(d) - 1 / own_below : 0;
        return static_cast<float>(own_part * h2 * std::max(more, 0.0));
    });
    rows_ = rows_above_zero(lattice, diagonal_);
    row_sums_.resize(rows_.rows.size());
}

void Solids::clear_closed_faces(std::array<Samples, 3>& velocity) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float* open = open_[axis].data();
        float* u = velocity[axis].data();
        each_row(lattice_, [&](std::ptrdiff_t at) {
            const std::ptrdiff_t end = at + lattice_.cells[0];
            THAUM_INDEPENDENT_ITERATIONS
            for (std::ptrdiff_t i = at; i < end; ++i) u[i] = open[i] > 0 ? u[i] : 0.0F;
        });
    }
}

/// Sets residual_ to minus the divergence of the velocity. Returns the largest divergence and the largest
/// velocity component.
Solids::Maxima Solids::divergence(const std::array<Samples, 3>& velocity, Team& team) {
    const Split split(team, lattice_.cells[2]);
    std::array<Maxima, max_cells> found{};
    team.each(split.slices, [&](int slice, unsigned) {
        const Layers layers = split[slice];
        found[static_cast<std::size_t>(slice)] = divergence_in(velocity, layers);
    });
    Maxima most{};
    for (int slice = 0; slice < split.slices; ++slice) {
        const Maxima& other = found[static_cast<std::size_t>(slice)];
        most.divergence = larger_or_nan(most.divergence, other.divergence);
        most.velocity = larger_or_nan(most.velocity, other.velocity);
    }
    return most;
}

Solids::Maxima Solids::divergence_in(const std::array<Samples, 3>& velocity, Layers layers) {
    const auto [x, y, z] = lattice_.stride;
    const auto per_h = static_cast<float>(1 / lattice_.h);
    const float *u = velocity[0].data(), *v = velocity[1].data(), *w = velocity[2].data();
    const float *a = open_[0].data(), *b = open_[1].data(), *c = open_[2].data();
    float* out = residual_.data();
    Magnitudes8 largest{}, fastest{};
    each_row(rows_, layers, [&, x = x, y = y, z = z](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            // Velocities past the end of a row whose length is no multiple of eight do not count: the sum of
            // open shares, diagonal_, is 0 there.
            const auto holds = load(diagonal_.data() + i) > zero8;
            const Floats8 ux = load(u + i), vy = load(v + i), wz = load(w + i);
            const Floats8 along_x = load(a + i + x) * load(u + i + x) - load(a + i) * ux;
            const Floats8 along_y = load(b + i + y) * load(v + i + y) - load(b + i) * vy;
            const Floats8 along_z = load(c + i + z) * load(w + i + z) - load(c + i) * wz;
            const Floats8 found = -per_h * (along_x + (along_y + along_z));
            const Floats8 left = holds ? found : zero8;
            store(out + i, left);
            largest = larger_magnitudes(largest, magnitudes_of(left));
            const Magnitudes8 across = larger_magnitudes(magnitudes_of(vy), magnitudes_of(wz));
            fastest = larger_magnitudes(fastest,
                                        holds ? larger_magnitudes(magnitudes_of(ux), across) : Magnitudes8{});
        }
    });
    return {max_of(largest), max_of(fastest)};
}

Solids::Products Solids::sum_of_rows() const {
    Products sum;
    for (std::size_t r = 0; r < row_sums_.size(); ++r) {
        if (rows_.rows[r].count == 0) continue;
        sum.residual += row_sums_[r].residual;
        sum.image += row_sums_[r].image;
    }
    return sum;
}

/// Applies the operator of the pressure equation to the search direction: sets image_ to minus the
/// divergence, through open faces, of the direction's gradient. Ghosts at periodic sides must be filled.
/// Returns the scalar product of direction and image.
double Solids::apply_to_direction(Team& team) {
    each_slice(team, Split(team, lattice_.cells[2]), [&](Layers layers, unsigned) { apply_in(layers); });
    return sum_of_rows().image;
}

void Solids::apply_in(Layers layers) {
    const auto [x, y, z] = lattice_.stride;
    const auto per_h2 = static_cast<float>(1 / (lattice_.h * lattice_.h));
    const float* p = direction_.data();
    const float *a = open_[0].data(), *b = open_[1].data(), *c = open_[2].data();
    const float* d = diagonal_.data();
    const int ny = lattice_.cells[1];
    for (int r = layers.first * ny; r < layers.end * ny; ++r) {
        const Row row = rows_.rows[static_cast<std::size_t>(r)];
        Floats8 products{};
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            const Floats8 own = load(p + i);
            const Floats8 beside = load(a + i + x) * load(p + i + x) + load(a + i) * load(p + i - x);
            const Floats8 above = load(b + i + y) * load(p + i + y) + load(b + i) * load(p + i - y);
            const Floats8 behind = load(c + i + z) * load(p + i + z) + load(c + i) * load(p + i - z);
            const Floats8 diagonal = load(d + i);
            const Floats8 image = per_h2 * (diagonal * own - (beside + (above + behind)));
            const Floats8 kept = diagonal > zero8 ? image : zero8;
            store(image_.data() + i, kept);
            products += own * kept;
        }
        row_sums_[static_cast<std::size_t>(r)] = {0, total(products)};
    }
}

/// Sets smoothed_ to the preconditioned residual. Returns its scalar products with the residual and with
/// image_, the operator times the search direction.
Solids::Products Solids::precondition(Team& team) {
    const std::ptrdiff_t nx = lattice_.cells[0];
    const Split split(team, lattice_.cells[2]);
    each_single(team, split, [&](Layers layers, unsigned seat) {
        float* packed = packed_.data() + layers.first * lattice_.cells[1] * nx;
        each_row(lattice_, layers, [&](std::ptrdiff_t at) {
            for (std::ptrdiff_t i = 0; i < nx; i += 8)
                store_within_row(packed + i, load(residual_.data() + at + i), nx - i);
            packed += nx;
        });
        box_.to_waves(packed_, layers, seat);
    });
    each_slice(team, Split(team, box_.blocks()),
               [&](Layers blocks, unsigned) { box_.divide(packed_, blocks.first, blocks.end); });
    each_single(team, split, [&](Layers layers, unsigned seat) {
        box_.from_waves(packed_, layers, seat);
        smooth_in(layers);
    });
    return sum_of_rows();
}

/// Sets smoothed_ from the solution of the box in packed_, and the sums of the rows to its scalar products.
void Solids::smooth_in(Layers layers) {
    const std::ptrdiff_t nx = lattice_.cells[0];
    const int ny = lattice_.cells[1];
    for (int r = layers.first * ny; r < layers.end * ny; ++r) {
        const Row row = rows_.rows[static_cast<std::size_t>(r)];
        const float* found = packed_.data() + r * nx + (row.at - lattice_.at(0, r % ny, r / ny));
        Floats8 by_residual{}, by_image{};
        for (std::ptrdiff_t i = 0; i < row.count; i += 8) {
            // The direct solve of the box is for +lap, but the operator here is -lap, so its result is
            // subtracted.
            const Floats8 d = load(diagonal_.data() + row.at + i);
            const Floats8 residual = load(residual_.data() + row.at + i);
            const Floats8 both =
                load(own_.data() + row.at + i) * residual - load_within_row(found + i, row.count - i);
            const Floats8 smoothed = d > zero8 ? both : zero8;
            store(smoothed_.data() + row.at + i, smoothed);
            by_residual += d > zero8 ? smoothed * residual : zero8;
            by_image += smoothed * load(image_.data() + row.at + i);
        }
        row_sums_[static_cast<std::size_t>(r)] = {total(by_residual), total(by_image)};
    }
}

/// Moves the solution along direction_ by the distance that reduces the energy of the corrected flow most.
/// Ghosts of the direction at periodic sides must be filled. `slope` is the scalar product of residual and
/// direction. Returns the largest remaining residual, or nothing if no step reduces the energy.
std::optional<double> Solids::step_along_direction(double slope, Team& team) {
    curvature_ = apply_to_direction(team);
    if (!(curvature_ > 0)) {
        curvature_ = 0;
        return std::nullopt;
    }
    const auto step = static_cast<float>(slope / curvature_);
    const Split split(team, lattice_.cells[2]);
    std::array<double, max_cells> most{};
    team.each(split.slices, [&](int slice, unsigned) {
        most[static_cast<std::size_t>(slice)] = take_step_in(step, split[slice]);
    });
    return *std::max_element(most.begin(), most.begin() + split.slices);
}

/// Adds a step along the direction to the solution in some layers. Returns the largest remaining residual, in
/// which a NaN does not count.
double Solids::take_step_in(float step, Layers layers) {
    Floats8 most{};
    each_row(rows_, layers, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            store(correction_.data() + i, load(correction_.data() + i) + step * load(direction_.data() + i));
            const Floats8 left = load(residual_.data() + i) - step * load(image_.data() + i);
            store(residual_.data() + i, left);
            most = larger(left < zero8 ? -left : left, most);
        }
    });
    double result = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane)
        result = std::max(result, static_cast<double>(most[lane]));
    return result;
}

/// Adds to correction_ the potential whose gradient has minus the residual as divergence. Stops when
/// the residual, initially at most `left`, is at most `tolerance` in each cell. Returns the number of
/// iterations.
int Solids::solve(double left, double tolerance, int max_iterations, Team& team) {
    int iterations = 0;
    while (iterations < max_iterations && left > tolerance) {
        const Products products = precondition(team);
        if (!(products.residual > 0)) break;
        // The new direction is conjugate to the previous one, even if that was the potential of the last
        // projection (first guess) or belongs to the previous round.
        const auto turn = static_cast<float>(curvature_ > 0 ? -products.image / curvature_ : 0);
        each_slice(team, Split(team, lattice_.cells[2]), [&](Layers layers, unsigned) {
            each_row(rows_, layers, [&](Row row) {
                for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
                    store(direction_.data() + i,
                          load(smoothed_.data() + i) + turn * load(direction_.data() + i));
            });
        });
        fill_round(rows_, direction_);
        const auto found = step_along_direction(products.residual, team);
        if (!found) break;
        left = *found;
        ++iterations;
    }
    fill_round(rows_, correction_);
    return iterations;
}

void Solids::subtract_correction_in(Layers layers, std::array<Samples, 3>& velocity) const {
    const auto per_h = static_cast<float>(1 / lattice_.h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto s = lattice_.stride[axis];
        const float* open = open_[axis].data();
        const float* p = correction_.data();
        float* u = velocity[axis].data();
        each_row(rows_, layers, [&](Row row) {
            for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
                const Floats8 left = load(u + i) - per_h * (load(p + i) - load(p + i - s));
                store(u + i, load(open + i) > zero8 ? left : zero8);
            }
        });
    }
}

/// Subtracts the gradient of the correction that a round has found from the velocity, and adds the
/// correction to the potential.
void Solids::end_round(std::array<Samples, 3>& velocity, Samples& potential, Team& team) const {
    each_slice(team, Split(team, lattice_.cells[2]), [&](Layers layers, unsigned) {
        subtract_correction_in(layers, velocity);
        add(rows_, layers, potential, 1, correction_);
    });
}

/// Begins a round of the projection: fills the ghosts of the velocity that its divergence reads, and sets the
/// correction to 0.
void Solids::begin_round(std::array<Samples, 3>& velocity, Team& team) {
    each_slice(team, Split(team, lattice_.cells[2]), [&](Layers layers, unsigned) {
        clear(rows_, layers, correction_);
        for (std::size_t axis = 0; axis < 3; ++axis)
            fill_ghosts_across(rows_, layers, axis, GhostRule::through_wall, velocity[axis]);
    });
}

Solids::ProjectionResult Solids::project(std::array<Samples, 3>& velocity, Samples& potential, double share,
                                         int max_iterations, Team& team) {
    ProjectionResult found;
    std::swap(direction_, potential);
    curvature_ = 0;
    for (int round = 0;; ++round) {
        begin_round(velocity, team);
        if (round == 0) clear(rows_, potential);
        const Maxima is = divergence(velocity, team);
        found.divergence = is.divergence;
        const double tolerance = share * is.velocity / lattice_.h;
        if (!(found.divergence > tolerance) || round == max_rounds) break;
        double left = found.divergence;
        if (round == 0) left = step_along_direction(dot(rows_, residual_, direction_), team).value_or(left);
        found.iterations += solve(left, std::max(tolerance, found.divergence * gain_of_round),
                                  max_iterations - found.iterations, team);
        end_round(velocity, potential, team);
    }
    each_slice(team, Split(team, lattice_.cells[2]),
               [&](Layers layers, unsigned) { fill_ghosts(rows_, layers, all_even, potential); });
    return found;
}

}  // namespace thaum::fluid
