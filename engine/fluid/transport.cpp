#include "fluid/transport.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fluid/ceiling.h"
#include "fluid/eight.h"
#include "fluid/ghosts.h"

// With F the flux of a field by the fifth order and q, q1, q2 Runge-Kutta's three fields,
//
//     q1 = q - div F(q)     q2 = q - 1/4 div (F(q) + F(q1))     high = 1/6 (F(q) + F(q1)) + 2/3 F(q2)
//
// so one array per axis holds all that is to be kept of the fluxes. Layer by layer: fluxes through the faces of a layer, and as soon
// as those above it are there, what they make of the layer.
//
// The flux of fifth order through a face with the cells a b c | d e f around it and the Courant number u is
//
//     u/60 (37 (d + c) - 8 (e + b) + (f + a)) - |u|/60 bias (10 (d - c) - 5 (e - b) + (f - a))
//
// The first bracket is of sixth order and spreads nothing; the second damps what the grid cannot carry. Upwind differences have it with
// bias 1. A quarter of it is enough: the limits below see to the rest. A Gaussian comes back from a turn with half the error (64^3:
// 2.1e-4 after 4.1e-4), and without any bias with more (1.0e-3), for its short waves stay behind.
//
// a mirror exchanges the terms within each bracket and the sign of u, so it turns the sign of the flux and nothing else.
namespace thaum::fluid {
namespace {

constexpr float bias = 0.25F;
constexpr float least_density = 1e-20F;  // numbers of less precision, which are slow, begin at 1e-38

using Floats = const float* __restrict;

// The loops over rows are functions that are not inlined, and written without branches: so GCC 12 makes vectors of all of them.

/// What a row of faces is crossed by.
struct FaceRow {
    Floats courant;
    Floats aperture, third, fifth;  ///< null where all is open
    std::ptrdiff_t step;            ///< from a cell to the next across the face
};

/// Of a sub-step.
struct Pace {
    float courant;    ///< its part of the currents
    float diffusion;  ///< k dt / h^2
};

enum class Stage { first, second, third };

/// What costs nothing where there is none of it.
struct Kind {
    bool solids, diffuses;
};

// Exact, and without a branch: GCC makes no vectors of loops with several.
inline float above_zero(float x) { return 0.5F * (x + std::abs(x)); }
inline float below_zero(float x) { return 0.5F * (x - std::abs(x)); }

/// Of first order; `low` and `high` are the values of the cells below and above the face.
template <Kind kind>
inline float donor(float courant, float diffusion, float low, float high) {
    const float carried = above_zero(courant) * low + below_zero(courant) * high;
    if constexpr (kind.diffuses) return carried - diffusion * (high - low);
    return carried;
}

/// Adds a stage's flux to the sum; the last one turns the sum into high less first order of `start`.
template <Stage stage, Kind kind>
[[gnu::noinline]] void flux_row(Pace pace, const FaceRow& face, Floats value, Floats start,
                                std::ptrdiff_t count, float* __restrict sum) {
    const std::ptrdiff_t s = face.step;
    const float sixtieth = pace.courant * (1.0F / 60), upwind = bias * sixtieth;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float u = sixtieth * face.courant[i];
        const float p0 = value[i] + value[i - s], p1 = value[i + s] + value[i - 2 * s];
        const float p2 = value[i + 2 * s] + value[i - 3 * s];
        const float d0 = value[i] - value[i - s], d1 = value[i + s] - value[i - 2 * s];
        const float d2 = value[i + 2 * s] - value[i - 3 * s];
        float mean = 0, jump = 0, diffusion = pace.diffusion;
        if constexpr (kind.solids) {
            mean = (30 * p0 + face.third[i] * (p0 - p1)) + face.fifth[i] * ((2 * p0 - 3 * p1) + p2);
            jump = (30 * d0 - face.third[i] * (3 * d0 + d1)) + face.fifth[i] * (d2 - 5 * d0);
        } else {
            mean = (37 * p0 - 8 * p1) + p2;
            jump = (10 * d0 - 5 * d1) + d2;
        }
        float flux = u * mean - upwind * std::abs(face.courant[i]) * jump;
        if constexpr (kind.diffuses) {
            if constexpr (kind.solids) diffusion *= face.aperture[i];
            flux -= diffusion * d0;
        }
        if constexpr (stage == Stage::first) sum[i] = flux;
        if constexpr (stage == Stage::second) sum[i] += flux;
        if constexpr (stage == Stage::third)
            sum[i] = (sum[i] * (1.0F / 6) + flux * (2.0F / 3)) -
                     donor<kind>(pace.courant * face.courant[i], diffusion, start[i - s], start[i]);
    }
}

/// The three rows of fluxes that meet a row of cells from below; those from above lie a step farther.
struct Fluxes {
    std::array<const float*, 3> low;
    std::array<std::ptrdiff_t, 3> step;
};

[[gnu::noinline]] void stage_row(const Fluxes& flux, Floats start, float part, std::ptrdiff_t count,
                                 float* __restrict value) {
    const Floats x = flux.low[0], y = flux.low[1], z = flux.low[2];
    const std::ptrdiff_t sy = flux.step[1], sz = flux.step[2];
    for (std::ptrdiff_t i = 0; i < count; ++i)
        value[i] = start[i] - part * (((x[i + 1] - x[i]) + (y[i + sy] - y[i])) + (z[i + sz] - z[i]));
}

/// What leaves a cell across one axis by the fluxes of first order.
template <Kind kind>
inline float donors(float part, float diffusion, Floats courant, Floats aperture, Floats value,
                    std::ptrdiff_t i, std::ptrdiff_t s) {
    float below = diffusion, above = diffusion;
    if constexpr (kind.solids && kind.diffuses) {
        below *= aperture[i];
        above *= aperture[i + s];
    }
    return donor<kind>(part * courant[i + s], above, value[i], value[i + s]) -
           donor<kind>(part * courant[i], below, value[i - s], value[i]);
}

/// What the first-order fluxes make of a row of cells, and what part of the differences each cell can afford: `part` of those that leave
/// it, so that it stays above zero, and `room` for those that enter it, so that it stays below `ceiling`.
template <Kind kind>
[[gnu::noinline]] void afford_row(Pace pace, const std::array<FaceRow, 3>& faces, const Fluxes& difference,
                                  Floats start, float ceiling, std::ptrdiff_t count, float* __restrict value,
                                  float* __restrict part, float* __restrict room) {
    const Floats x = difference.low[0], y = difference.low[1], z = difference.low[2];
    const Floats cx = faces[0].courant, cy = faces[1].courant, cz = faces[2].courant;
    const Floats ax = faces[0].aperture, ay = faces[1].aperture, az = faces[2].aperture;
    const std::ptrdiff_t sy = faces[1].step, sz = faces[2].step;
    const float u = pace.courant, k = pace.diffusion;
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float left =
            start[i] - ((donors<kind>(u, k, cx, ax, start, i, 1) + donors<kind>(u, k, cy, ay, start, i, sy)) +
                        donors<kind>(u, k, cz, az, start, i, sz));
        const float taken =
            ((above_zero(x[i + 1]) - below_zero(x[i])) + (above_zero(y[i + sy]) - below_zero(y[i]))) +
            (above_zero(z[i + sz]) - below_zero(z[i]));
        const float given =
            ((above_zero(x[i]) - below_zero(x[i + 1])) + (above_zero(y[i]) - below_zero(y[i + sy]))) +
            (above_zero(z[i]) - below_zero(z[i + sz]));
        // A little less than all, so that the rounding of what is taken or given cannot go beyond it.
        const float most = left * 0.999999F / (taken + 1e-30F);
        const float free = above_zero(ceiling - left) * 0.999999F / (given + 1e-30F);
        value[i] = left;
        part[i] = most < 1 ? most : 1;
        room[i] = free < 1 ? free : 1;
    }
}

/// Without a branch.
inline float lesser(float a, float b) { return a < b ? a : b; }

/// A difference through a face, as far as the cells on both sides of it can afford; s: from the cell below to that above.
inline float cut(Floats difference, Floats part, Floats room, std::ptrdiff_t i, std::ptrdiff_t s) {
    return above_zero(difference[i]) * lesser(part[i - s], room[i]) +
           below_zero(difference[i]) * lesser(part[i], room[i - s]);
}

/// Takes the differences.
[[gnu::noinline]] void cut_row(const Fluxes& difference, Floats value, Floats part, Floats room,
                               std::ptrdiff_t count, float* __restrict result) {
    const Floats x = difference.low[0], y = difference.low[1], z = difference.low[2];
    const std::ptrdiff_t sy = difference.step[1], sz = difference.step[2];
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float now = value[i] - (((cut(x, part, room, i + 1, 1) - cut(x, part, room, i, 1)) +
                                       (cut(y, part, room, i + sy, sy) - cut(y, part, room, i, sy))) +
                                      (cut(z, part, room, i + sz, sz) - cut(z, part, room, i, sz)));
        result[i] = now < least_density ? 0 : now;
    }
}

/// Sums over faces of one level, for one sub-step.
struct Crossed {
    double density{};  ///< density that crosses them
    double flow{};     ///< fluid that crosses them, in cells
    double either{};   ///< fluid that crosses them either way
    double carried{};  ///< that fluid times the mean density beside the face

    /// What crosses beyond the fluid's own mean: no fluid crosses a level in all, but for what the pressure solve has left.
    double beyond_mean() const { return either > 0 ? density - flow * carried / either : density; }
};

/// Adds the low faces of a row of cells to `levels`, each cell's level being `across` beyond that of the cell before it.
template <Kind kind>
[[gnu::noinline]] void add_crossed(Pace pace, const FaceRow& face, Floats difference, Floats start,
                                   Floats part, Floats room, std::ptrdiff_t count, std::ptrdiff_t across,
                                   Crossed* levels) {
    constexpr std::ptrdiff_t lanes = 8;
    const std::ptrdiff_t s = face.step;
    std::array<std::array<float, lanes>, 4> sums{};
    const auto add = [&](std::ptrdiff_t i, std::size_t lane) {
        float diffusion = pace.diffusion;
        if constexpr (kind.solids && kind.diffuses) diffusion *= face.aperture[i];
        const float flow = pace.courant * face.courant[i];
        sums[0][lane] +=
            donor<kind>(flow, diffusion, start[i - s], start[i]) + cut(difference, part, room, i, s);
        sums[1][lane] += flow;
        sums[2][lane] += std::abs(flow);
        sums[3][lane] += std::abs(flow) * (0.5F * (start[i - s] + start[i]));
    };
    const auto hand_over = [&](std::size_t lane, Crossed& level) {
        level.density += static_cast<double>(sums[0][lane]);
        level.flow += static_cast<double>(sums[1][lane]);
        level.either += static_cast<double>(sums[2][lane]);
        level.carried += static_cast<double>(sums[3][lane]);
        for (auto& sum : sums) sum[lane] = 0;
    };
    if (across != 0) {
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            add(i, 0);
            hand_over(0, levels[i * across]);
        }
        return;
    }
    const std::ptrdiff_t whole = count / lanes * lanes;
    for (std::ptrdiff_t i = 0; i < whole; i += lanes)
        for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) add(i + lane, static_cast<std::size_t>(lane));
    for (std::ptrdiff_t i = whole; i < count; ++i) add(i, 0);
    for (std::size_t lane = 0; lane < lanes; ++lane) hand_over(lane, *levels);
}

// ---- over the lattice --------------------------------------------------------------------------------------------

/// One sub-step's arrays.
struct Crossing {
    const Lattice& lattice;
    const Currents& currents;
    Pace pace;
    const Samples& start;
    TransportScratch& scratch;

    const Rows& rows() const { return currents.rows(); }

    FaceRow face(std::size_t axis, std::ptrdiff_t at) const {
        FaceRow row{currents.courant[axis].data() + at, nullptr, nullptr, nullptr, lattice.stride[axis]};
        if (const Openings* open = currents.openings; open != nullptr) {
            row.aperture = open->aperture[axis].data() + at;
            row.third = open->third[axis].data() + at;
            row.fifth = open->fifth[axis].data() + at;
        }
        return row;
    }
    Fluxes fluxes(std::ptrdiff_t at) const {
        const auto& f = scratch.flux;
        return {{f[0].data() + at, f[1].data() + at, f[2].data() + at}, lattice.stride};
    }
};

template <Stage stage, Kind kind>
[[gnu::noinline]] void flux_rows(const Crossing& c, const Samples& value, std::size_t axis, int k) {
    each_row(c.rows(), k, [&](Row row) {
        flux_row<stage, kind>(c.pace, c.face(axis, row.at), value.data() + row.at, c.start.data() + row.at,
                              whole_eights(row.count), c.scratch.flux[axis].data() + row.at);
    });
}

/// The last faces of a periodic lattice are the first ones. On walls they are closed, as are those behind the last cells before
/// something solid: nothing goes through, and nothing is ever written there.
void close_rings(const Crossing& c, int k) {
    const auto [nx, ny, nz] = c.lattice.cells;
    auto& flux = c.scratch.flux;
    if (c.lattice.edges[0] == Edge::periodic)
        each_row(c.lattice, k,
                 [begin = flux[0].data(), nx = nx](std::ptrdiff_t at) { begin[at + nx] = begin[at]; });
    const auto first = [&](std::size_t axis, int j, int layer) {
        return flux[axis].data() + c.lattice.at(0, j, layer);
    };
    if (c.lattice.edges[1] == Edge::periodic) std::copy_n(first(1, 0, k), nx, first(1, ny, k));
    if (k == 0 && c.lattice.edges[2] == Edge::periodic)
        for (int j = 0; j < ny; ++j) std::copy_n(first(2, j, 0), nx, first(2, j, nz));
}

/// All fluxes of a stage, and `layer(k)` once those of layer k are there. Rows are taken in whole vectors; what that writes beyond
/// them is nowhere read.
template <Stage stage, Kind kind, class Layer>
void each_layer(const Crossing& c, const Samples& value, Layer layer) {
    const int nz = c.lattice.cells[2];
    for (int k = 0; k < nz; ++k) {
        flux_rows<stage, kind>(c, value, 2, k);
        if (k > 0) layer(k - 1);
        flux_rows<stage, kind>(c, value, 0, k);
        flux_rows<stage, kind>(c, value, 1, k);
        close_rings(c, k);
    }
    layer(nz - 1);
}

/// The field after `part` of the fluxes so far.
template <Stage stage, Kind kind>
void take_stage(const Crossing& c, const Samples& value, float part, Samples& next) {
    each_layer<stage, kind>(c, value, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            stage_row(c.fluxes(row.at), c.start.data() + row.at, part, whole_eights(row.count),
                      next.data() + row.at);
        });
    });
    fill_ghosts(c.rows(), evenly, next);
}

/// What crosses all faces along an axis, counted in the direction of the axis.
template <Kind kind>
double crossed(const Crossing& c, std::size_t axis, const Samples& part, const Samples& room) {
    std::array<Crossed, cells_most> levels{};
    for (int k = 0; k < c.lattice.cells[2]; ++k) {
        for (int j = 0; j < c.lattice.cells[1]; ++j) {
            const Row row = c.rows().at(j, k);
            if (row.count == 0) continue;
            const auto first = row.at - c.lattice.at(0, j, k);
            const auto level = static_cast<std::size_t>(axis == 0 ? first : axis == 1 ? j : k);
            add_crossed<kind>(c.pace, c.face(axis, row.at), c.scratch.flux[axis].data() + row.at,
                              c.start.data() + row.at, part.data() + row.at, room.data() + row.at, row.count,
                              axis == 0 ? 1 : 0, levels.data() + level);
        }
    }
    double sum = 0;
    for (const Crossed& level : levels) sum += level.beyond_mean();
    return sum;
}

template <Kind kind>
vec3 substep(const Lattice& lattice, const Currents& currents, Pace pace, const vec3& along, Samples& density,
             TransportScratch& scratch) {
    const Crossing c{lattice, currents, pace, density, scratch};
    Samples& first = scratch.first;
    Samples& second = scratch.second;
    take_stage<Stage::first, kind>(c, density, 1, first);
    take_stage<Stage::second, kind>(c, first, 0.25F, second);
    Samples& left = first;  // the stages' fields have served
    Samples& part = scratch.part;
    Samples& room = scratch.room;
    const float ceiling = density_ceiling(
        currents.rows(), currents.openings != nullptr ? &currents.openings->aperture : nullptr, density);
    each_layer<Stage::third, kind>(c, second, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const std::ptrdiff_t at = row.at;
            afford_row<kind>(pace, {c.face(0, at), c.face(1, at), c.face(2, at)}, c.fluxes(at),
                             density.data() + at, ceiling, whole_eights(row.count), left.data() + at,
                             part.data() + at, room.data() + at);
        });
    });
    // Beyond walls they meet no difference.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (lattice.edges[axis] != Edge::periodic) continue;
        fill_ghosts_across(c.rows(), axis, Beyond::even, part);
        fill_ghosts_across(c.rows(), axis, Beyond::even, room);
    }
    vec3 moved(0);
    for (int axis = 0; axis < 3; ++axis)
        if (along[axis] != 0) moved[axis] = crossed<kind>(c, static_cast<std::size_t>(axis), part, room);
    each_row(c.rows(), [&](Row row) {
        const std::ptrdiff_t at = row.at;
        cut_row(c.fluxes(at), left.data() + at, part.data() + at, room.data() + at, row.count,
                density.data() + at);
    });
    fill_ghosts(c.rows(), evenly, density);
    return moved;
}

using Substep = vec3 (*)(const Lattice&, const Currents&, Pace, const vec3&, Samples&, TransportScratch&);

Substep substep_of(Kind kind) {
    if (kind.solids) return kind.diffuses ? substep<Kind{true, true}> : substep<Kind{true, false}>;
    return kind.diffuses ? substep<Kind{false, true}> : substep<Kind{false, false}>;
}

// ---- how many sub-steps ----------------------------------------------------------------------------------------------

struct Schedule {
    int substeps;
    double carried, spread;
};

/// outflow and diffusion, k dt / h^2, over the whole time.
Schedule schedule(double outflow, double diffusion, int most) {
    const double spreading = 6 * diffusion;
    const double wanted = std::max(1.0, std::ceil((outflow + spreading) / courant_most));
    if (wanted <= most) return {static_cast<int>(wanted), 1, 1};
    const double room = courant_most * most;
    const double spread = std::min(spreading, std::max(room / 2, room - outflow));
    const double carried = std::min(outflow, room - spread);
    return {most, outflow > 0 ? carried / outflow : 1, spreading > 0 ? spread / spreading : 1};
}

bool is_empty(const Rows& rows, const Samples& density) {
    return std::ranges::all_of(rows.rows, [&](Row row) {
        const float* value = density.data() + row.at;
        std::uint32_t bits = 0;
        for (std::ptrdiff_t i = 0; i < row.count; ++i) bits |= std::bit_cast<std::uint32_t>(value[i]);
        return bits == 0;
    });
}

/// What can leave each cell of a row, kept where it is more than before.
[[gnu::noinline]] void outflow_row(const Fluxes& courant, std::ptrdiff_t count, float* __restrict most) {
    const Floats x = courant.low[0], y = courant.low[1], z = courant.low[2];
    const std::ptrdiff_t sy = courant.step[1], sz = courant.step[2];
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float out =
            ((above_zero(x[i + 1]) - below_zero(x[i])) + (above_zero(y[i + sy]) - below_zero(y[i]))) +
            (above_zero(z[i + sz]) - below_zero(z[i]));
        most[i] = out > most[i] ? out : most[i];
    }
}

}  // namespace

Openings make_openings(const Lattice& lattice, const std::array<Samples, 3>& aperture) {
    Openings result{.aperture = aperture};
    const Cells n = lattice.cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t step = lattice.stride[axis];
        const bool round = lattice.edges[axis] == Edge::periodic;
        result.third[axis] = result.fifth[axis] = make_samples(lattice);
        for (int k = 0; k <= n[2]; ++k) {
            for (int j = 0; j <= n[1]; ++j) {
                for (int i = 0; i <= n[0]; ++i) {
                    const std::array<int, 3> cell{i, j, k};
                    const std::ptrdiff_t at = lattice.at(i, j, k), from = at - cell[axis] * step;
                    const auto open = [&](int farther) {
                        const int face = cell[axis] + farther;
                        if (round)
                            return aperture[axis][static_cast<std::size_t>(from + (face + n[axis]) % n[axis] *
                                                                                      step)] > 0;
                        return face <= 0 || face >= n[axis] ||
                               aperture[axis][static_cast<std::size_t>(from + face * step)] > 0;
                    };
                    const bool third = open(-1) && open(0) && open(1);
                    const auto to = static_cast<std::size_t>(at);
                    result.third[axis][to] = third ? 5.0F : 0.0F;
                    result.fifth[axis][to] = third && open(-2) && open(2) ? 1.0F : 0.0F;
                    if (round && cell[axis] == n[axis])
                        result.aperture[axis][to] = aperture[axis][static_cast<std::size_t>(from)];
                }
            }
        }
    }
    result.rows = rows_above_zero(lattice, openness(lattice, result.aperture));
    return result;
}

Currents make_currents(const Lattice& lattice) {
    Currents currents{.whole = whole_rows(lattice)};
    for (Samples& samples : currents.courant) samples = make_samples(lattice);
    return currents;
}

TransportScratch make_transport_scratch(const Lattice& lattice) {
    TransportScratch scratch{.first = make_samples(lattice),
                             .second = make_samples(lattice),
                             .part = make_samples(lattice),
                             .room = make_samples(lattice)};
    for (Samples& samples : scratch.flux) samples = make_samples(lattice);
    return scratch;
}

void set_currents(const Lattice& lattice, const std::array<Samples, 3>& before,
                  const std::array<Samples, 3>& after, const Openings* openings, double dt,
                  Currents& currents, int order) {
    const auto factor = static_cast<float>(dt / lattice.h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Floats first = before[axis].data(), second = after[axis].data();
        float* const __restrict to = currents.courant[axis].data();
        const auto mean = [=](std::size_t i) { return 0.5F * (first[i] + second[i]); };
        if (order == 4) {
            const auto s = static_cast<std::size_t>(lattice.stride[axis]);
            for (std::size_t i = s; i < lattice.size - s; ++i)
                to[i] = factor * (mean(i) * (26.0F / 24) - (mean(i - s) + mean(i + s)) * (1.0F / 24));
        } else if (openings != nullptr) {
            const Floats aperture = openings->aperture[axis].data();
            each_row(openings->rows, [&](Row row) {
                const auto end = static_cast<std::size_t>(row.at + row.count);
                for (auto i = static_cast<std::size_t>(row.at); i < end; ++i)
                    to[i] = mean(i) * factor * aperture[i];
            });
            // The last faces of a periodic lattice are the first ones.
            if (lattice.edges[axis] == Edge::periodic)
                fill_ghosts_across(openings->rows, axis, Beyond::even, currents.courant[axis]);
        } else {
            for (std::size_t i = 0; i < lattice.size; ++i) to[i] = mean(i) * factor;
        }
    }
    currents.openings = openings;
    currents.dt = dt;
    std::array<float, cells_most> most{};
    each_row(currents.rows(), [&](Row row) {
        const auto& c = currents.courant;
        outflow_row({{c[0].data() + row.at, c[1].data() + row.at, c[2].data() + row.at}, lattice.stride},
                    row.count, most.data());
    });
    currents.outflow = *std::ranges::max_element(most);
}

TransportReport transport(const Lattice& lattice, const Currents& currents, const TransportSettings& settings,
                          Samples& density, TransportScratch& scratch) {
    const double diffusion = settings.diffusion * currents.dt / (lattice.h * lattice.h);
    if ((currents.outflow == 0 && diffusion == 0) || is_empty(currents.rows(), density)) return {};
    const auto [substeps, carried, spread] = schedule(currents.outflow, diffusion, settings.most_substeps);
    const Pace pace{static_cast<float>(carried / substeps),
                    static_cast<float>(diffusion * spread / substeps)};
    fill_ghosts(currents.rows(), evenly, density);
    const auto step = substep_of({currents.openings != nullptr, diffusion > 0});
    vec3 moved(0);
    for (int i = 0; i < substeps; ++i)
        moved += step(lattice, currents, pace, settings.moved_along, density, scratch);
    const auto [nx, ny, nz] = lattice.cells;
    return {substeps, carried, spread, moved, std::int64_t{nx} * ny * nz * substeps};
}

}  // namespace thaum::fluid
