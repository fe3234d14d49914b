#include "fluid/detail/transport.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fluid/detail/ceiling.h"
#include "fluid/detail/independent_iterations.h"
#include "fluid/detail/sums.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"

// F is the flux of fifth order, and q, q1, q2 are the fields of the three Runge-Kutta stages:
//
//     q1 = q - div F(q)     q2 = q - 1/4 div (F(q) + F(q1))     high = 1/6 (F(q) + F(q1)) + 2/3 F(q2)
//
// One array for each axis is enough for all fluxes. The lattice is processed layer by layer: first the
// fluxes through the faces of a layer, then, when those above it are ready, the new values of the
// layer.
//
// The flux of fifth order through a face with cells a b c | d e f around it and Courant number u is
//
//     u/60 (37 (d + c) - 8 (e + b) + (f + a)) - |u|/60 bias (10 (d - c) - 5 (e - b) + (f - a))
//
// The first bracket is of sixth order and does not diffuse. The second damps waves that are too short
// for the grid. Upwind differences have a bias of 1. A tenth of it is enough, because the limiter removes
// the rest. A Gaussian of 64^3 then returns from one revolution with an error of 3.7e-4, and from
// LeVeque's flow with 0.226; with a quarter they are 1.8e-4 and 0.249. With no bias at all short waves lag
// behind, and the first is 1.0e-3.
//
// A body with sharp edges, which the flow of high order would round off, gets
// one flux more, against its slope:
//
//     |u| sharpness minmod(c - b, d - c, e - d)
//
// A mirror image exchanges the terms in each bracket and the sign of u. It therefore changes the sign
// of the flux and nothing else.
namespace thaum::fluid {
namespace {

constexpr float bias = 0.1F;
/// Largest sharpness of the flux above. With it, a sphere of 64^3 returns from LeVeque's flow with an error
/// of 0.31. A sharpness of 0.15 gives 0.35, and a sharpness of 0 gives 0.60. A larger one deforms slots and
/// corners that are a few cells wide.
constexpr double max_sharpness = 0.25;
/// Intensities of segregation (sums.h) from which on edges are kept sharp in part, and fully. A Gaussian has
/// at most 0.41 in a flow that stretches it. At 0.5 and above, more of a body lies in its inside than on its
/// edge.
constexpr double segregation_of_blurred = 0.5, segregation_of_sharp = 0.6;
// Densities below this become 0. Smaller ones would soon be subnormal floats (below 1e-38), which are slow.
constexpr float min_density = 1e-20F;

using Floats = const float* __restrict;

// The loops over rows are functions that are not inlined and have no branches, so that GCC 12 vectorises all
// of them.

/// A row of faces of cells, with what the flux of a substance through each of them depends on.
struct FaceRow {
    Floats courant;
    /// Shares that no solid covers, and weights of terms of order 3 and 5; null if all faces are open.
    Floats aperture, third, fifth;
    std::ptrdiff_t step;  ///< index distance between the cells on both sides of a face
};

/// Factors of one sub-step, which covers a part of the whole time.
struct SubstepScale {
    float courant;    ///< share of the whole time: factor on the Courant numbers, which are for all of it
    float diffusion;  ///< diffusion coefficient times dt / h^2
    float sharpness;  ///< factor of the flux against the slope (see the top of this file)
};

enum class StageIndex { first, second, third };

/// Terms that a sub-step needs; loops are compiled separately for each combination.
struct TransportTerms {
    bool solids, diffuses, sharpens;
};

// Larger and smaller of x and 0. They are exact and have no branch, as GCC does not vectorise loops with
// several branches.
inline float above_zero(float x) { return 0.5F * (x + std::abs(x)); }
inline float below_zero(float x) { return 0.5F * (x - std::abs(x)); }

/// Flux of first order through a face: the flow carries the density of the cell from which it comes. `low`
/// and `high` are the densities below and above the face.
template <TransportTerms terms>
inline float donor(float courant, float diffusion, float low, float high) {
    const float carried = above_zero(courant) * low + below_zero(courant) * high;
    if constexpr (terms.diffuses) return carried - diffusion * (high - low);
    return carried;
}

/// Minimum and maximum without a branch.
inline float minimum(float a, float b) { return a < b ? a : b; }
inline float maximum(float a, float b) { return a > b ? a : b; }

/// The smallest of three slopes if they have one sign, else 0.
inline float minmod(float a, float b, float c) {
    return above_zero(minimum(minimum(a, c), b)) + below_zero(maximum(maximum(a, c), b));
}

/// Adds the fluxes of a Runge-Kutta stage to the sum. In the last stage, completes the sum to the flux of
/// high order and subtracts the flux of first order, which is computed from `start`.
template <StageIndex stage, TransportTerms terms>
[[gnu::noinline]] void flux_row(SubstepScale scale, const FaceRow& face, Floats value, Floats start,
                                std::ptrdiff_t count, float* __restrict sum) {
    const std::ptrdiff_t s = face.step;
    const float sixtieth = scale.courant * (1.0F / 60), upwind = bias * sixtieth;
    const float back = scale.courant * scale.sharpness * (terms.solids ? 0.2F : 1.0F);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float u = sixtieth * face.courant[i];
        const float p0 = value[i] + value[i - s], p1 = value[i + s] + value[i - 2 * s];
        const float p2 = value[i + 2 * s] + value[i - 3 * s];
        const float d0 = value[i] - value[i - s], d1 = value[i + s] - value[i - 2 * s];
        const float d2 = value[i + 2 * s] - value[i - 3 * s];
        float mean = 0, jump = 0, diffusion = scale.diffusion;
        if constexpr (terms.solids) {
            mean = (30 * p0 + face.third[i] * (p0 - p1)) + face.fifth[i] * ((2 * p0 - 3 * p1) + p2);
            jump = (30 * d0 - face.third[i] * (3 * d0 + d1)) + face.fifth[i] * (d2 - 5 * d0);
        } else {
            mean = (37 * p0 - 8 * p1) + p2;
            jump = (10 * d0 - 5 * d1) + d2;
        }
        float flux = u * mean - upwind * std::abs(face.courant[i]) * jump;
        if constexpr (terms.diffuses) {
            if constexpr (terms.solids) diffusion *= face.aperture[i];
            flux -= diffusion * d0;
        }
        if constexpr (terms.sharpens) {
            const float least = minmod(value[i - s] - value[i - 2 * s], d0, value[i + s] - value[i]);
            flux += back * std::abs(face.courant[i]) * (terms.solids ? face.third[i] * least : least);
        }
        if constexpr (stage == StageIndex::first) sum[i] = flux;
        if constexpr (stage == StageIndex::second) sum[i] += flux;
        if constexpr (stage == StageIndex::third)
            sum[i] = (sum[i] * (1.0F / 6) + flux * (2.0F / 3)) -
                     donor<terms>(scale.courant * face.courant[i], diffusion, start[i - s], start[i]);
    }
}

/// Fluxes through the lower faces of a row of cells, one row for each axis. The fluxes of the upper faces are
/// one step farther in memory.
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

/// Net outflow of a cell across one axis by fluxes of first order.
template <TransportTerms terms>
inline float donors(float part, float diffusion, Floats courant, Floats aperture, Floats value,
                    std::ptrdiff_t i, std::ptrdiff_t s) {
    float below = diffusion, above = diffusion;
    if constexpr (terms.solids && terms.diffuses) {
        below *= aperture[i];
        above *= aperture[i + s];
    }
    return donor<terms>(part * courant[i + s], above, value[i], value[i + s]) -
           donor<terms>(part * courant[i], below, value[i - s], value[i]);
}

/// Applies the first-order fluxes to a row of cells. Then computes for each cell which share of the flux
/// differences (fifth order minus first) may be applied. `part` is the share for differences that leave a
/// cell, with which its density stays above zero. `room` is the share for those that enter it, with which its
/// density stays below `ceiling`.
template <TransportTerms terms>
[[gnu::noinline]] void limit_row(SubstepScale scale, const std::array<FaceRow, 3>& faces,
                                 const Fluxes& difference, Floats start, float ceiling, std::ptrdiff_t count,
                                 float* __restrict value, float* __restrict part, float* __restrict room) {
    const Floats x = difference.low[0], y = difference.low[1], z = difference.low[2];
    const Floats cx = faces[0].courant, cy = faces[1].courant, cz = faces[2].courant;
    const Floats ax = faces[0].aperture, ay = faces[1].aperture, az = faces[2].aperture;
    const std::ptrdiff_t sy = faces[1].step, sz = faces[2].step;
    const float u = scale.courant, k = scale.diffusion;
    THAUM_INDEPENDENT_ITERATIONS
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float left =
            start[i] -
            ((donors<terms>(u, k, cx, ax, start, i, 1) + donors<terms>(u, k, cy, ay, start, i, sy)) +
             donors<terms>(u, k, cz, az, start, i, sz));
        const float taken =
            ((above_zero(x[i + 1]) - below_zero(x[i])) + (above_zero(y[i + sy]) - below_zero(y[i]))) +
            (above_zero(z[i + sz]) - below_zero(z[i]));
        const float given =
            ((above_zero(x[i]) - below_zero(x[i + 1])) + (above_zero(y[i]) - below_zero(y[i + sy]))) +
            (above_zero(z[i]) - below_zero(z[i + sz]));
        // The factor keeps the shares slightly below the exact ones, so that rounding cannot exceed the
        // limit.
        const float most = left * 0.999999F / (taken + 1e-30F);
        const float free = above_zero(ceiling - left) * 0.999999F / (given + 1e-30F);
        value[i] = left;
        part[i] = most < 1 ? most : 1;
        room[i] = free < 1 ? free : 1;
    }
}

/// The difference of the fluxes of fifth and first order through a face, times the share that the cells on
/// both sides allow. `s` is the step from the cell below to the one above.
inline float limited_difference(Floats difference, Floats part, Floats room, std::ptrdiff_t i,
                                std::ptrdiff_t s) {
    return above_zero(difference[i]) * minimum(part[i - s], room[i]) +
           below_zero(difference[i]) * minimum(part[i], room[i - s]);
}

/// Applies the limited flux differences to a row of cells.
[[gnu::noinline]] void apply_limited_row(const Fluxes& difference, Floats value, Floats part, Floats room,
                                         std::ptrdiff_t count, float* __restrict result) {
    const Floats x = difference.low[0], y = difference.low[1], z = difference.low[2];
    const std::ptrdiff_t sy = difference.step[1], sz = difference.step[2];
    THAUM_INDEPENDENT_ITERATIONS
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float current =
            value[i] -
            (((limited_difference(x, part, room, i + 1, 1) - limited_difference(x, part, room, i, 1)) +
              (limited_difference(y, part, room, i + sy, sy) - limited_difference(y, part, room, i, sy))) +
             (limited_difference(z, part, room, i + sz, sz) - limited_difference(z, part, room, i, sz)));
        result[i] = current < min_density ? 0 : current;
    }
}

/// What flows in one sub-step through the faces between two levels (layers of cells at one height), summed
/// over the faces.
struct LevelCrossing {
    double density{};  ///< amount of the substance that crossed the level upwards (densities times cells)
    double flow{};     ///< net flow of fluid (cells)
    double either{};   ///< sum of the absolute flows of fluid (cells)
    double carried{};  ///< sum of absolute flow times the mean density of the two cells beside the face

    /// Density that crossed, minus what the mean density would have carried. The net flow through a level is
    /// zero except for the error of the pressure solve.
    double beyond_mean() const { return either > 0 ? density - flow * carried / either : density; }
};

/// Adds the fluxes through the low faces of a row of cells to `levels`. The level of each cell is `across`
/// higher than that of the previous cell.
template <TransportTerms terms>
[[gnu::noinline]] void add_crossed(SubstepScale scale, const FaceRow& face, Floats difference, Floats start,
                                   Floats part, Floats room, std::ptrdiff_t count, std::ptrdiff_t across,
                                   LevelCrossing* levels) {
    constexpr std::ptrdiff_t lanes = 8;
    const std::ptrdiff_t s = face.step;
    std::array<std::array<float, lanes>, 4> sums{};
    const auto add = [&](std::ptrdiff_t i, std::size_t lane) {
        float diffusion = scale.diffusion;
        if constexpr (terms.solids && terms.diffuses) diffusion *= face.aperture[i];
        const float flow = scale.courant * face.courant[i];
        sums[0][lane] += donor<terms>(flow, diffusion, start[i - s], start[i]) +
                         limited_difference(difference, part, room, i, s);
        sums[1][lane] += flow;
        sums[2][lane] += std::abs(flow);
        sums[3][lane] += std::abs(flow) * (0.5F * (start[i - s] + start[i]));
    };
    const auto flush = [&](std::size_t lane, LevelCrossing& level) {
        level.density += static_cast<double>(sums[0][lane]);
        level.flow += static_cast<double>(sums[1][lane]);
        level.either += static_cast<double>(sums[2][lane]);
        level.carried += static_cast<double>(sums[3][lane]);
        for (auto& sum : sums) sum[lane] = 0;
    };
    if (across != 0) {
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            add(i, 0);
            flush(0, levels[i * across]);
        }
        return;
    }
    const std::ptrdiff_t whole = count / lanes * lanes;
    for (std::ptrdiff_t i = 0; i < whole; i += lanes)
        for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) add(i + lane, static_cast<std::size_t>(lane));
    for (std::ptrdiff_t i = whole; i < count; ++i) add(i, 0);
    for (std::size_t lane = 0; lane < lanes; ++lane) flush(lane, *levels);
}

// ---- fluxes over the whole lattice -----------------------------------------------------------------------

/// What all functions of one sub-step need: the flow, the density at the start, and the arrays to work in.
struct SubstepContext {
    const Lattice& lattice;
    const FaceFlow& face_flow;
    SubstepScale scale;
    const Samples& start;
    TransportScratch& scratch;

    const Rows& rows() const { return face_flow.rows(); }

    FaceRow face(std::size_t axis, std::ptrdiff_t at) const {
        FaceRow row{face_flow.courant[axis].data() + at, nullptr, nullptr, nullptr, lattice.stride[axis]};
        if (const FaceApertures* open = face_flow.face_apertures; open != nullptr) {
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

template <StageIndex stage, TransportTerms terms>
[[gnu::noinline]] void flux_rows(const SubstepContext& c, const Samples& value, std::size_t axis, int k) {
    each_row(c.rows(), k, [&](Row row) {
        flux_row<stage, terms>(c.scale, c.face(axis, row.at), value.data() + row.at, c.start.data() + row.at,
                               round_up_to_8(row.count), c.scratch.flux[axis].data() + row.at);
    });
}

/// Copies the first faces to the last ones at periodic sides. The last faces at walls and after the last cell
/// before a solid are closed: their flux is never written and stays 0.
void copy_last_faces(const SubstepContext& c, int k) {
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

/// Computes all fluxes of a stage and calls `layer(k)` when those of layer k are ready. Rows are
/// extended to whole vectors; the extra values are never read.
template <StageIndex stage, TransportTerms terms, class Layer>
void each_layer(const SubstepContext& c, const Samples& value, Layer layer) {
    const int nz = c.lattice.cells[2];
    for (int k = 0; k < nz; ++k) {
        flux_rows<stage, terms>(c, value, 2, k);
        if (k > 0) layer(k - 1);
        flux_rows<stage, terms>(c, value, 0, k);
        flux_rows<stage, terms>(c, value, 1, k);
        copy_last_faces(c, k);
    }
    layer(nz - 1);
}

/// Computes the density of the next Runge-Kutta stage: that at the start, changed by `part` times the sum of
/// the fluxes of the stages so far.
template <StageIndex stage, TransportTerms terms>
void take_stage(const SubstepContext& c, const Samples& value, float part, Samples& next) {
    each_layer<stage, terms>(c, value, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            stage_row(c.fluxes(row.at), c.start.data() + row.at, part, round_up_to_8(row.count),
                      next.data() + row.at);
        });
    });
    fill_ghosts(c.rows(), all_even, next);
}

/// Density that crossed all faces along an axis, positive in the direction of the axis.
template <TransportTerms terms>
double moved_across(const SubstepContext& c, std::size_t axis, const Samples& part, const Samples& room) {
    std::array<LevelCrossing, max_cells> levels{};
    for (int k = 0; k < c.lattice.cells[2]; ++k) {
        for (int j = 0; j < c.lattice.cells[1]; ++j) {
            const Row row = c.rows().at(j, k);
            if (row.count == 0) continue;
            const auto first = row.at - c.lattice.at(0, j, k);
            const auto level = static_cast<std::size_t>(axis == 0 ? first : axis == 1 ? j : k);
            add_crossed<terms>(c.scale, c.face(axis, row.at), c.scratch.flux[axis].data() + row.at,
                               c.start.data() + row.at, part.data() + row.at, room.data() + row.at, row.count,
                               axis == 0 ? 1 : 0, levels.data() + level);
        }
    }
    double sum = 0;
    for (const LevelCrossing& level : levels) sum += level.beyond_mean();
    return sum;
}

template <TransportTerms terms>
vec3 substep(const Lattice& lattice, const FaceFlow& face_flow, SubstepScale scale, const vec3& along,
             Samples& density, TransportScratch& scratch) {
    const SubstepContext c{lattice, face_flow, scale, density, scratch};
    Samples& first = scratch.first;
    Samples& second = scratch.second;
    take_stage<StageIndex::first, terms>(c, density, 1, first);
    take_stage<StageIndex::second, terms>(c, first, 0.25F, second);
    Samples& left = first;  // uses the memory of the first stage, which is no longer needed
    Samples& part = scratch.part;
    Samples& room = scratch.room;
    const float ceiling = density_ceiling(
        face_flow.rows(), face_flow.face_apertures != nullptr ? &face_flow.face_apertures->aperture : nullptr,
        density);
    each_layer<StageIndex::third, terms>(c, second, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const std::ptrdiff_t at = row.at;
            limit_row<terms>(scale, {c.face(0, at), c.face(1, at), c.face(2, at)}, c.fluxes(at),
                             density.data() + at, ceiling, round_up_to_8(row.count), left.data() + at,
                             part.data() + at, room.data() + at);
        });
    });
    // Values beyond walls are never used, because the flux difference through a wall is 0.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (lattice.edges[axis] != Edge::periodic) continue;
        fill_ghosts_across(c.rows(), axis, GhostRule::even, part);
        fill_ghosts_across(c.rows(), axis, GhostRule::even, room);
    }
    vec3 moved(0);
    for (int axis = 0; axis < 3; ++axis)
        if (along[axis] != 0)
            moved[axis] = moved_across<terms>(c, static_cast<std::size_t>(axis), part, room);
    each_row(c.rows(), [&](Row row) {
        const std::ptrdiff_t at = row.at;
        apply_limited_row(c.fluxes(at), left.data() + at, part.data() + at, room.data() + at, row.count,
                          density.data() + at);
    });
    fill_ghosts(c.rows(), all_even, density);
    return moved;
}

using Substep = vec3 (*)(const Lattice&, const FaceFlow&, SubstepScale, const vec3&, Samples&,
                         TransportScratch&);

template <bool solids>
Substep substep_of(SubstepScale scale) {
    if (scale.diffusion > 0) return substep<TransportTerms{solids, true, false}>;
    if (scale.sharpness > 0) return substep<TransportTerms{solids, false, true}>;
    return substep<TransportTerms{solids, false, false}>;
}

// ---- number of sub-steps ---------------------------------------------------------------------------------

struct Schedule {
    int substeps;
    double carried, spread;
};

/// Divides a time into at most `most` sub-steps. `outflow`, the part of a cell that flows out of it, and
/// `diffusion` (k dt / h^2) are for the whole time. If the sub-steps are not enough, only parts of both are
/// done.
Schedule schedule(double outflow, double diffusion, int most) {
    const double spreading = 6 * diffusion;
    const double wanted = std::max(1.0, std::ceil((outflow + spreading) / max_courant));
    if (wanted <= most) return {static_cast<int>(wanted), 1, 1};
    const double room = max_courant * most;
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

/// Sharpness of a substance's edges, the factor of the flux that keeps them sharp: 0 if the substance has no
/// region of uniform density, and 0 if it diffuses.
float sharpness_of(const FaceFlow& face_flow, double diffusion, const Samples& density) {
    if (diffusion > 0) return 0;
    const Cells n = face_flow.rows().lattice.cells;
    const double cells =
        face_flow.face_apertures != nullptr ? face_flow.face_apertures->cells : double(n[0]) * n[1] * n[2];
    const double share = (segregation(face_flow.rows(), cells, density) - segregation_of_blurred) /
                         (segregation_of_sharp - segregation_of_blurred);
    // Rounding the share to sixteenths hides the rounding errors of the sums, so that the symmetry of the
    // flow is kept.
    return static_cast<float>(max_sharpness * std::round(16 * std::clamp(share, 0.0, 1.0)) / 16);
}

/// Outflow of each cell of a row; `most` keeps the largest value so far.
[[gnu::noinline]] void outflow_row(const Fluxes& courant, std::ptrdiff_t count, float* __restrict most) {
    const Floats x = courant.low[0], y = courant.low[1], z = courant.low[2];
    const std::ptrdiff_t sy = courant.step[1], sz = courant.step[2];
    THAUM_INDEPENDENT_ITERATIONS
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float out =
            ((above_zero(x[i + 1]) - below_zero(x[i])) + (above_zero(y[i + sy]) - below_zero(y[i]))) +
            (above_zero(z[i + sz]) - below_zero(z[i]));
        most[i] = out > most[i] ? out : most[i];
    }
}

}  // namespace

FaceApertures make_face_apertures(const Lattice& lattice, const std::array<Samples, 3>& aperture) {
    FaceApertures result{.aperture = aperture};
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
    const Samples open = openness(lattice, result.aperture);
    result.rows = rows_above_zero(lattice, open);
    each_cell(lattice, [&](int, int, int, std::size_t at) { result.cells += open[at] > 0 ? 1 : 0; });
    return result;
}

FaceFlow make_face_flow(const Lattice& lattice) {
    FaceFlow face_flow{.whole = whole_rows(lattice)};
    for (Samples& samples : face_flow.courant) samples = make_samples(lattice);
    return face_flow;
}

TransportScratch make_transport_scratch(const Lattice& lattice) {
    TransportScratch scratch{.first = make_samples(lattice),
                             .second = make_samples(lattice),
                             .part = make_samples(lattice),
                             .room = make_samples(lattice)};
    for (Samples& samples : scratch.flux) samples = make_samples(lattice);
    return scratch;
}

void set_face_flow(const Lattice& lattice, const std::array<Samples, 3>& before,
                   const std::array<Samples, 3>& after, const FaceApertures* face_apertures, double dt,
                   FaceFlow& face_flow, int order) {
    const auto factor = static_cast<float>(dt / lattice.h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Floats first = before[axis].data(), second = after[axis].data();
        float* const __restrict to = face_flow.courant[axis].data();
        const auto mean = [=](std::size_t i) { return 0.5F * (first[i] + second[i]); };
        if (order == 4) {
            const auto s = static_cast<std::size_t>(lattice.stride[axis]);
            for (std::size_t i = s; i < lattice.size - s; ++i)
                to[i] = factor * (mean(i) * (26.0F / 24) - (mean(i - s) + mean(i + s)) * (1.0F / 24));
        } else if (face_apertures != nullptr) {
            const Floats aperture = face_apertures->aperture[axis].data();
            each_row(face_apertures->rows, [&](Row row) {
                const auto end = static_cast<std::size_t>(row.at + row.count);
                for (auto i = static_cast<std::size_t>(row.at); i < end; ++i)
                    to[i] = mean(i) * factor * aperture[i];
            });
            // The last faces of a periodic lattice are copies of the first.
            if (lattice.edges[axis] == Edge::periodic)
                fill_ghosts_across(face_apertures->rows, axis, GhostRule::even, face_flow.courant[axis]);
        } else {
            for (std::size_t i = 0; i < lattice.size; ++i) to[i] = mean(i) * factor;
        }
    }
    face_flow.face_apertures = face_apertures;
    face_flow.dt = dt;
    std::array<float, max_cells> most{};
    each_row(face_flow.rows(), [&](Row row) {
        const auto& c = face_flow.courant;
        outflow_row({{c[0].data() + row.at, c[1].data() + row.at, c[2].data() + row.at}, lattice.stride},
                    row.count, most.data());
    });
    face_flow.outflow = *std::ranges::max_element(most);
}

TransportReport transport(const Lattice& lattice, const FaceFlow& face_flow,
                          const TransportSettings& settings, Samples& density, TransportScratch& scratch) {
    const double diffusion = settings.diffusion * face_flow.dt / (lattice.h * lattice.h);
    if ((face_flow.outflow == 0 && diffusion == 0) || is_empty(face_flow.rows(), density)) return {};
    const auto [substeps, carried, spread] = schedule(face_flow.outflow, diffusion, settings.max_substeps);
    const SubstepScale scale{static_cast<float>(carried / substeps),
                             static_cast<float>(diffusion * spread / substeps),
                             sharpness_of(face_flow, diffusion, density)};
    fill_ghosts(face_flow.rows(), all_even, density);
    const auto step =
        face_flow.face_apertures != nullptr ? substep_of<true>(scale) : substep_of<false>(scale);
    vec3 moved(0);
    for (int i = 0; i < substeps; ++i)
        moved += step(lattice, face_flow, scale, settings.moved_along, density, scratch);
    const auto [nx, ny, nz] = lattice.cells;
    return {substeps, carried, spread, moved, std::int64_t{nx} * ny * nz * substeps};
}

}  // namespace thaum::fluid
