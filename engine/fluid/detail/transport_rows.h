// fluid/detail/transport_rows.h: the arithmetic of transport (transport.h), on rows of cells and faces.
//
// F is the flux of fifth order, and q, q1, q2 are the fields of the three Runge-Kutta stages:
//
//     q1 = q - div F(q)     q2 = q - 1/4 div (F(q) + F(q1))     high = 1/6 (F(q) + F(q1)) + 2/3 F(q2)
//
// The flux of fifth order through a face with cells a b c | d e f around it and Courant number u is
//
//     u/60 (37 (d + c) - 8 (e + b) + (f + a)) - |u|/60 bias (10 (d - c) - 5 (e - b) + (f - a))
//
// The first bracket is of sixth order and does not diffuse. The second damps waves that are too short for the
// grid. Upwind differences have a bias of 1. A bias of 0.1 is enough, because the limiter removes the rest.
// On 64^3 cells a Gaussian then returns from one revolution with an error of 3.7e-4, and from LeVeque's flow
// with 0.226. With a bias of 0.25 these errors are 1.8e-4 and 0.249. With a bias of 0 short waves lag behind,
// and the error of the revolution is 1.0e-3.
//
// A body with sharp edges, which the flow of high order would round off, gets one flux more, against its
// slope:
//
//     |u| sharpness minmod(c - b, d - c, e - d)
//
// A mirror image exchanges the terms in each bracket and the sign of u. It therefore changes the sign
// of the flux and nothing else.
//
// All loops take eight cells at once and go on to the end of a whole vector. The rows of a bowl are only a
// few vectors long. A loop over single cells that the compiler vectorises would spend most of its time on the
// cells before and after the whole vectors.
#pragma once
#include <algorithm>
#include <array>

#include "fluid/detail/transport.h"
#include "fluid/floats8.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

inline constexpr float bias = 0.1F;
// Densities below this become 0. Smaller ones would soon be subnormal floats (below 1e-38), which are slow.
inline constexpr float min_density = 1e-20F;

/// A row of faces of cells, with the values that determine the flux of a substance through each of them.
struct FaceRow {
    const float* courant;
    /// Shares that no solid covers, and weights of terms of order 3 and 5; null if all faces are open.
    const float *aperture, *third, *fifth;
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

/// The absolute value in each lane.
inline Floats8 magnitude(const Floats8& values) { return std::bit_cast<Floats8>(magnitudes_of(values)); }
inline Floats8 above_zero(const Floats8& x) { return larger(x, zero8); }
inline Floats8 below_zero(const Floats8& x) { return smaller(x, zero8); }

/// The smallest of three slopes if they have one sign, else 0.
inline Floats8 minmod(const Floats8& a, const Floats8& b, const Floats8& c) {
    return above_zero(smaller(smaller(a, c), b)) + below_zero(larger(larger(a, c), b));
}

/// Flux of first order through a face: the flow carries the density of the cell from which it comes. `low`
/// and `high` are the densities below and above the face.
template <TransportTerms terms>
inline Floats8 donor(const Floats8& courant, const Floats8& diffusion, const Floats8& low,
                     const Floats8& high) {
    const Floats8 carried = above_zero(courant) * low + below_zero(courant) * high;
    if constexpr (terms.diffuses) return carried - diffusion * (high - low);
    return carried;
}

/// Flux of fifth order through eight faces (see the top of this file), from the densities around them.
template <TransportTerms terms>
inline Floats8 flux_of_fifth(const SubstepScale& scale, const FaceRow& face, std::ptrdiff_t i,
                             const Floats8& diffusion, const float* value) {
    const std::ptrdiff_t s = face.step;
    const Floats8 a = load(value - 3 * s), b = load(value - 2 * s), c = load(value - s);
    const Floats8 d = load(value), e = load(value + s), f = load(value + 2 * s);
    const Floats8 p0 = d + c, p1 = e + b, p2 = f + a, d0 = d - c, d1 = e - b, d2 = f - a;
    const Floats8 courant = load(face.courant + i), size = magnitude(courant);
    const float sixtieth = scale.courant * (1.0F / 60);
    Floats8 mean, jump, third;
    if constexpr (terms.solids) {
        third = load(face.third + i);
        const Floats8 fifth = load(face.fifth + i);
        mean = (30.0F * p0 + third * (p0 - p1)) + fifth * ((2.0F * p0 - 3.0F * p1) + p2);
        jump = (30.0F * d0 - third * (3.0F * d0 + d1)) + fifth * (d2 - 5.0F * d0);
    } else {
        mean = (37.0F * p0 - 8.0F * p1) + p2;
        jump = (10.0F * d0 - 5.0F * d1) + d2;
    }
    Floats8 flux = sixtieth * courant * mean - bias * sixtieth * size * jump;
    if constexpr (terms.diffuses) flux -= diffusion * d0;
    if constexpr (terms.sharpens) {
        const Floats8 least = minmod(c - b, d0, e - d);
        const float back = scale.courant * scale.sharpness * (terms.solids ? 0.2F : 1.0F);
        flux += back * size * (terms.solids ? third * least : least);
    }
    return flux;
}

/// Arrays of a sub-step at one row of faces.
struct FluxRow {
    const float* value;  ///< density in this stage
    const float* start;  ///< density at the start of the sub-step
    float* sum;          ///< fluxes of the stages so far
    float* donors;       ///< fluxes of first order; written in the last stage
};

/// Adds the fluxes of a Runge-Kutta stage to the sum. In the last stage, completes the sum to the flux of
/// high order and subtracts the flux of first order, which is computed from the density at the start.
template <StageIndex stage, TransportTerms terms>
[[gnu::always_inline]] inline void flux_row(SubstepScale scale, const FaceRow& face, std::ptrdiff_t count,
                                            const FluxRow& row) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        Floats8 diffusion = zero8 + scale.diffusion;
        if constexpr (terms.solids && terms.diffuses) diffusion *= load(face.aperture + i);
        const Floats8 flux = flux_of_fifth<terms>(scale, face, i, diffusion, row.value + i);
        if constexpr (stage == StageIndex::first) store(row.sum + i, flux);
        if constexpr (stage == StageIndex::second) store(row.sum + i, load(row.sum + i) + flux);
        if constexpr (stage == StageIndex::third) {
            const Floats8 first = donor<terms>(scale.courant * load(face.courant + i), diffusion,
                                               load(row.start + i - face.step), load(row.start + i));
            store(row.sum + i, (load(row.sum + i) * (1.0F / 6) + flux * (2.0F / 3)) - first);
            store(row.donors + i, first);
        }
    }
}

/// Fluxes through the lower faces of a row of cells, one row for each axis. The fluxes of the upper faces are
/// one step farther in memory.
struct Fluxes {
    std::array<const float*, 3> low;
    std::array<std::ptrdiff_t, 3> step;

    Floats8 below(std::size_t axis, std::ptrdiff_t i) const { return load(low[axis] + i); }
    Floats8 above(std::size_t axis, std::ptrdiff_t i) const { return load(low[axis] + i + step[axis]); }
};

/// Amount that flows out of each of eight cells minus the amount that flows in, through all six faces.
inline Floats8 net_outflow(const Fluxes& f, std::ptrdiff_t i) {
    const auto across = [&](std::size_t axis) { return f.above(axis, i) - f.below(axis, i); };
    return (across(0) + across(1)) + across(2);
}
/// Amount that flows out of each of eight cells, summed over those of its faces through which some leaves.
inline Floats8 outflow(const Fluxes& f, std::ptrdiff_t i) {
    const auto across = [&](std::size_t axis) {
        return above_zero(f.above(axis, i)) - below_zero(f.below(axis, i));
    };
    return (across(0) + across(1)) + across(2);
}
/// Amount that flows into each of eight cells, summed over those of its faces through which some enters.
inline Floats8 inflow(const Fluxes& f, std::ptrdiff_t i) {
    const auto across = [&](std::size_t axis) {
        return above_zero(f.below(axis, i)) - below_zero(f.above(axis, i));
    };
    return (across(0) + across(1)) + across(2);
}

/// For the cells of a row, the density after the fluxes of first order, and which shares of the flux
/// differences (fifth order minus first) may still be applied.
struct LimitRow {
    float* value;  ///< density after the fluxes of first order
    /// Share of the flux differences (fifth order minus first) that may leave a cell, so that its density
    /// stays above zero.
    float* part;
    /// Share of the flux differences (fifth order minus first) that may enter a cell, so that its density
    /// stays below the ceiling, the highest density that any cell may reach.
    float* room;
};

/// Applies the first-order fluxes to a row of cells. Then computes for each cell which share of the flux
/// differences (fifth order minus first) may still be applied without leaving the bounds of the density.
inline void limit_row(const Fluxes& donors, const Fluxes& difference, const float* start, float ceiling,
                      std::ptrdiff_t count, const LimitRow& row) {
    const Floats8 one = zero8 + 1.0F;
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        const Floats8 left = load(start + i) - net_outflow(donors, i);
        // The factor keeps the shares slightly below the exact ones, so that rounding cannot exceed the
        // limit.
        const Floats8 most = left * 0.999999F / (outflow(difference, i) + 1e-30F);
        const Floats8 free = above_zero(ceiling - left) * 0.999999F / (inflow(difference, i) + 1e-30F);
        store(row.value + i, left);
        store(row.part + i, smaller(most, one));
        store(row.room + i, smaller(free, one));
    }
}

/// Multiplies the flux differences (fifth order minus first) through a row of faces by the shares that the
/// cells on both sides allow. `s` is the index distance from the cell below a face to the one above.
inline void limit_fluxes(const float* part, const float* room, std::ptrdiff_t s, std::ptrdiff_t count,
                         float* difference) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        const Floats8 all = load(difference + i);
        store(difference + i, above_zero(all) * smaller(load(part + i - s), load(room + i)) +
                                  below_zero(all) * smaller(load(part + i), load(room + i - s)));
    }
}

/// Amounts that flow in one sub-step through the faces between two levels (layers of cells at one height),
/// summed over the faces.
struct LevelCrossing {
    double density{};  ///< amount of the substance that crossed the faces upwards (densities times cells)
    double flow{};     ///< net flow of fluid (cells)
    double either{};   ///< sum of the absolute flows of fluid (cells)
    double carried{};  ///< sum of absolute flow times the mean density of the two cells beside the face

    void add(float crossed, float of_fluid, float either_way, float with_mean) {
        density += static_cast<double>(crossed);
        flow += static_cast<double>(of_fluid);
        either += static_cast<double>(either_way);
        carried += static_cast<double>(with_mean);
    }
    /// Amount that crossed the faces upwards (densities times cells), less what the net flow of fluid carries
    /// at the mean density there. That net flow comes from the error of the pressure solve alone.
    double beyond_mean() const { return either > 0 ? density - flow * carried / either : density; }
};
using Levels = std::array<LevelCrossing, max_cells>;

/// Fluxes of a sub-step through a row of faces.
struct CrossedRow {
    const float *donors, *limited;
    const float* courant;
    const float* start;
    std::ptrdiff_t step;
};

/// Flow of a substance and of fluid through the low faces of eight cells, from the i-th of a row on.
inline CrossedSums crossed_at(float scale, const CrossedRow& row, std::ptrdiff_t i) {
    const Floats8 flow = scale * load(row.courant + i), size = magnitude(flow);
    return {.density = load(row.donors + i) + load(row.limited + i),
            .flow = flow,
            .either = size,
            .carried = size * (0.5F * (load(row.start + i - row.step) + load(row.start + i)))};
}

/// Sums the amounts that flow through the low faces of a row of cells that are all at one height.
inline CrossedSums crossed_in_row(float scale, const CrossedRow& row, std::ptrdiff_t count) {
    CrossedSums sums{};
    std::ptrdiff_t i = 0;
    for (; i + 8 <= count; i += 8) {
        const CrossedSums here = crossed_at(scale, row, i);
        sums.density += here.density;
        sums.flow += here.flow;
        sums.either += here.either;
        sums.carried += here.carried;
    }
    if (i == count) return sums;
    const CrossedSums here = crossed_at(scale, row, i);
    for (std::ptrdiff_t lane = 0; lane < count - i; ++lane) {
        sums.density[0] += here.density[lane];
        sums.flow[0] += here.flow[lane];
        sums.either[0] += here.either[lane];
        sums.carried[0] += here.carried[lane];
    }
    return sums;
}

/// Adds the fluxes through the low faces of a row of cells to `levels`, one element for each cell. Each cell
/// of the row lies one level higher than the cell before.
inline void add_crossed(float scale, const CrossedRow& row, std::ptrdiff_t count, LevelCrossing* levels) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        const CrossedSums here = crossed_at(scale, row, i);
        for (std::ptrdiff_t lane = 0; lane < std::min<std::ptrdiff_t>(8, count - i); ++lane)
            levels[i + lane].add(here.density[lane], here.flow[lane], here.either[lane], here.carried[lane]);
    }
}

}  // namespace thaum::fluid
