// fluid/detail/transport.h: advection and diffusion of one substance, dc/dt = -div(u c) + k lap c.
//
// The method is of finite volumes. The flux that leaves a cell through a face enters its neighbour, so the
// amount is conserved up to rounding. No density falls below zero, and none rises above the highest density.
// A sub-step has three parts:
//
//     1. Fluxes of fifth order, slightly upwind-biased, in three stages of Runge-Kutta (Shu and Osher
//        1988), summed to one flux for each face.
//     2. Fluxes of first order. By these no cell can fall below zero. Where the flow has no divergence,
//        no cell can rise above the others either.
//     3. The difference of the two, limited at each face (Zalesak 1979). It may not take more from a cell
//        than the cell has, nor fill it beyond the highest density of the lattice. The limit allows for
//        smooth hills whose top lies between cells, so they are not clipped.
//
// Sharp edges: a body of one density would be smeared out, as the limit stops what the fluxes of fifth order
// would take back from outside. If most of a substance lies in cells of its highest density (sums.h,
// `segregation`), one more flux carries density up the slope, back into the body. A smooth hill, a mixture
// and a substance that diffuses are left as they are.
//
// Sub-steps are so short that the first-order fluxes take at most `max_courant` of any cell. There is
// no splitting by direction: the fluxes of all three axes act at once.
//
// Symmetry: if the input is mirrored along any axis, or x and y are exchanged, so is the output, to the
// bit. Exchanging z with another axis changes the order of a sum of three, so there the symmetry holds
// only up to rounding. A constant density stays constant up to rounding where the flow has no
// divergence.
//
// Solids: a face has an aperture, 0 closed to 1 open, which multiplies its flux. Every cell that holds
// fluid counts as a whole cell. Near a closed face the flux is of third or first order, because the
// cells behind it cannot be read.
#pragma once
#include <array>
#include <cstdint>

#include "core/maths.h"
#include "core/team.h"
#include "fluid/detail/sums.h"
#include "fluid/rows.h"

namespace thaum::fluid {

/// Apertures of the faces (shares that no solid covers), at the positions of the velocities, and the order
/// that each flux may have. Made once.
struct FaceApertures {
    std::array<Samples, 3> aperture{};
    /// Weights of the flux's terms of higher order: `third` is 5 where the flux may have order 3, `fifth` is
    /// 1 where it may have order 5, else 0.
    std::array<Samples, 3> third{}, fifth{};
    Rows rows{};  ///< cells with open faces
    int cells{};  ///< number of cells with open faces
};

/// Makes the tables from apertures (open shares of faces) between 0 and 1, whose ghost cells are not read.
/// Faces on the lattice's own walls do not lower the order of a flux, because cells beyond them are mirrored.
FaceApertures make_face_apertures(const Lattice& lattice, const std::array<Samples, 3>& aperture);

/// A flow over a time: Courant numbers of the faces, the part of a cell that passes through each. It is
/// shared by all substances.
struct FaceFlow {
    std::array<Samples, 3> courant{};
    const FaceApertures* face_apertures{};  ///< tables of the faces; null: all faces are open
    Rows whole{};                           ///< rows of all cells, which are used if all faces are open
    /// Largest part of a cell's content that flows out; above 1 if the content is replaced more than once.
    double outflow{};
    double dt{};  ///< time over which the flow acts (s)

    const Rows& rows() const { return face_apertures != nullptr ? face_apertures->rows : whole; }
};

FaceFlow make_face_flow(const Lattice& lattice);

/// Sets the flow to the mean of two velocities (m/s) over dt (s), >= 0. The velocities must be finite,
/// with filled ghosts. Does not allocate. `face_apertures` must outlive `face_flow`.
///
/// `order` is the order of the divergence that is zero (pressure.h). At order 4 that divergence is a
/// difference of (26 u[0] - u[-1] - u[1]) / 24 between both sides of a cell, so this expression is the
/// flow. face_apertures must then be null.
void set_face_flow(const Lattice& lattice, const std::array<Samples, 3>& before,
                   const std::array<Samples, 3>& after, const FaceApertures* face_apertures, double dt,
                   FaceFlow& face_flow, Team& team, int order = 2);

/// Sums of the amounts that flow through the faces of a row in one sub-step, each in eight parts. The members
/// have the meaning of those of LevelCrossing (transport_rows.h).
struct CrossedSums {
    Floats8 density, flow, either, carried;
};

/// Scratch memory for any substances on one lattice with the same apertures of faces. Cells without open
/// faces stay zero.
struct TransportScratch {
    Samples first{}, second{}, part{}, room{};
    /// `flux`: sum of the fluxes of the stages, then the difference of fifth order minus first, then that
    /// difference limited. `donors`: fluxes of first order.
    std::array<Samples, 3> flux{}, donors{};
    std::vector<SegregationOfRow> segregation{};  ///< an element for each row
    /// For each axis, the amounts that cross the low faces of each row. Threads find them in any order; they
    /// are summed in the order of the rows.
    std::array<std::vector<CrossedSums>, 3> crossed{};
};

TransportScratch make_transport_scratch(const Lattice& lattice);

/// Largest share of a cell that first-order fluxes take in a sub-step.
inline constexpr double max_courant = 0.9;

/// Settings of one transport of a substance.
struct TransportSettings {
    double diffusion{};  ///< diffusion coefficient, finite, >= 0 (m^2/s)
    /// Largest number of sub-steps, >= 1. 10 are enough for a flow that moves by four cells along two axes at
    /// once.
    int max_substeps{10};
    /// A component is nonzero if TransportReport::moved is to be computed along that axis.
    vec3 moved_along{};
};

/// Result of one transport of a substance.
struct TransportReport {
    int substeps{};  ///< number of sub-steps; 0 if the density is zero or nothing moves it
    /// Part of dt over which the flow was followed; below 1 if the sub-steps were not enough.
    double carried{1};
    /// Part of the diffusion that was applied; below 1 if the sub-steps were not enough. At least half of
    /// the available sub-steps are reserved for the flow.
    double spread{1};
    /// Density that crossed the faces along each axis, positive upwards (cells). The first moment of the
    /// density along the axis grew by as much. A net flow of fluid through a level comes only from the error
    /// of the pressure solve, so the part that it would carry at the level's mean density is left out.
    vec3 moved{};
    std::int64_t cells{};  ///< number of cells that were processed, summed over all sub-steps
};

/// Transports the density of a substance by a flow. The density must be finite and >= 0. Fills the ghost
/// cells itself. Results below 1e-20 become 0.
TransportReport transport(const Lattice& lattice, const FaceFlow& face_flow,
                          const TransportSettings& settings, Samples& density, TransportScratch& scratch,
                          Team& team);

}  // namespace thaum::fluid
