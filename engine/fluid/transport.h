// fluid/transport.h: what a flow carries with it, and what spreads by itself: one substance, dc/dt = -div(u c) + k lap c.
//
// Finite volumes. What leaves a cell through a face enters its neighbour, so the amount of a substance stays what it was but for the
// rounding of sums; no cell falls below zero, and none rises above the highest one:
//
//     1. fluxes of fifth order, a little upwind-biased, in the three stages of Runge-Kutta (Shu and Osher 1988), summed to one flux per face
//     2. fluxes of first order, by which no cell can fall below zero or, where the flow has no divergence, rise above the rest
//     3. the difference of the two, cut at the faces of cells that it would take more from than they have or fill beyond the highest
//        density of the whole lattice (Zalesak 1979). Smooth hills may come as high as they are between cells: they are not clipped
//
// in sub-steps of such a length that the first-order fluxes take no more than `courant_most` of any cell. No direction is split off:
// all three fluxes act at once.
//
// To the bit: mirrored along any axis, or with x and y exchanged, the result is mirrored or exchanged. Exchanging z with another axis
// changes the order of a sum of three, so there it holds to rounding. A constant stays one to rounding where the flow has no
// divergence.
//
// Solids: a face has an aperture, 0 closed to 1 open, by which its flux is multiplied; every cell that holds anything counts as a
// whole one. Near a closed face the flux is of third or first order, since nothing stands behind it to be read.
#pragma once
#include <array>
#include <cstdint>

#include "core/maths.h"
#include "fluid/rows.h"

namespace thaum::fluid {

/// Apertures of the faces, at the places of the velocities, and what may be read across each. Made once.
struct FaceApertures {
    std::array<Samples, 3> aperture{};
    std::array<Samples, 3> third{}, fifth{};  ///< 5 and 1 where the flux may be of that order, else 0
    Rows rows{};                              ///< of the cells with open faces
};

/// Of apertures from 0 to 1; their ghosts are not read. Faces on the lattice's own walls count as open to reading, for what is
/// beyond them is mirrored.
FaceApertures make_face_apertures(const Lattice& lattice, const std::array<Samples, 3>& aperture);

/// A flow over a time: what part of a cell goes through each face. The same for all substances.
struct FaceFlow {
    std::array<Samples, 3> courant{};
    const FaceApertures* face_apertures{};  ///< null: all faces are open
    Rows whole{};                           ///< all cells, for where all faces are open
    double outflow{};  ///< the largest part that leaves a cell; above 1 where it is changed more than once
    double dt{};       ///< s

    const Rows& rows() const { return face_apertures != nullptr ? face_apertures->rows : whole; }
};

FaceFlow make_face_flow(const Lattice& lattice);

/// By the mean of the velocities before and after, m/s, that are finite, with their ghosts, for dt s >= 0. No allocation. The openings
/// must outlive the currents. `order`: of the divergence that the velocity is free of (pressure.h). At order 4 it is the
/// difference of (26 u[0] - u[-1] - u[1]) / 24 on the two sides of a cell, which is then the flow; openings must be null.
void set_face_flow(const Lattice& lattice, const std::array<Samples, 3>& before,
                   const std::array<Samples, 3>& after, const FaceApertures* face_apertures, double dt,
                   FaceFlow& face_flow, int order = 2);

/// Kept from call to call, for any substances of one lattice between the same openings. Zero where nothing is open.
struct TransportScratch {
    Samples first{}, second{}, part{}, room{};
    std::array<Samples, 3> flux{};
};

TransportScratch make_transport_scratch(const Lattice& lattice);

inline constexpr double courant_most = 0.9;

struct TransportSettings {
    double diffusion{};     ///< m^2/s, finite, >= 0
    int most_substeps{10};  ///< >= 1; enough for a flow of four cells along two axes at once
    vec3 moved_along{};     ///< axes for which `moved` is asked for: those that are not 0
};

struct TransportReport {
    int substeps{};  ///< 0: there is nothing, or nothing moves
    double carried{
        1};  ///< the part of dt for which the flow was followed; below 1 where the sub-steps were not enough
    double spread{
        1};  ///< the part of the diffusion that was done, likewise: at least half the room is the flow's
    /// Density that crossed the faces along each axis, counted upwards (cells): by so much its first moment grew. What merely goes
    /// round with the mean density of a level is left out, being zero but for what the pressure solve left.
    vec3 moved{};
    std::int64_t cells{};  ///< visited, over all sub-steps
};

/// Carries densities, finite and >= 0, by the currents. They need no ghosts and leave with them. What falls below
/// 1e-20 becomes 0.
TransportReport transport(const Lattice& lattice, const FaceFlow& face_flow,
                          const TransportSettings& settings, Samples& density, TransportScratch& scratch);

}  // namespace thaum::fluid
