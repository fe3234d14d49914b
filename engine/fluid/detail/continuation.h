// fluid/detail/continuation.h: a velocity that continues the flow into solids along which it slips freely,
// for advection to read there.
//
// Advection reads velocities at the centres of faces on all sides of a face. Beside a solid, a closed face
// has no velocity, and that of a cut face belongs to the centre of its open part. If advection used these
// values, every piece of wall would drag the flow, however fine the grid is: within a second the error of a
// turning flow grew to more than a quarter, at 32 as at 48 cells across. So advection reads values that
// continue the flow: a linear function is fitted to the velocities on the open faces around and evaluated at
// the centre of the face. A flow that turns as a rigid body is then advected exactly.
//
// A continued flow has some divergence, and its energy is not conserved. So the rates of change on the faces
// beside it get two additional terms: that of the divergence (momentum.h leaves it out), and a share of
// upwind differences. Both terms are zero for a rigid turn. The upwind differences damp waves that are too
// short for the grid.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fluid/detail/momentum.h"
#include "fluid/detail/solids.h"

namespace thaum::fluid {

/// Continues the flow into the solids of one lattice, so that advection beside them reads velocities that do
/// not brake it. Made once.
class Continuation {
public:
    Continuation(const Lattice& lattice, const Solids& solids);

    /// Replaces the velocities on cut faces (covered in part), and on closed faces beside fluid, by values
    /// fitted to the open faces around. Neither reads nor writes ghost cells.
    void apply(std::array<Samples, 3>& velocity);
    /// Adds the terms of divergence and upwind differences (see the top of this file) to the rate of change
    /// that a Runge-Kutta stage has got from a continued velocity.
    void correct(const RungeKuttaStage& stage) const;

private:
    /// An open face, and the weight of its velocity in the fitted velocity of another face, which a solid
    /// covers.
    struct Source {
        std::uint32_t at{};  ///< index of the face in the samples
        float weight{};
    };
    /// A face that a solid covers in part or wholly. Its velocity is replaced by the weighted sum of the
    /// velocities of open faces, its sources.
    struct Target {
        std::uint32_t at{};  ///< index of the face in the samples
        /// Index of the target's first source; the sources end where those of the next target begin.
        std::uint32_t first{};
    };
    /// For one component of the velocity: the faces whose velocities are fitted, and the open faces to whose
    /// velocities they are fitted.
    struct Component {
        /// The faces whose velocities are fitted, then an entry without sources. It marks the end of the last
        /// face's sources.
        std::vector<Target> targets;
        /// The open faces from which each of the targets is computed, padded to a multiple of four with
        /// weights of 0.
        std::vector<Source> sources;
        /// Indices of the open faces whose advection reads fitted velocities of faces in solids.
        std::vector<std::uint32_t> beside;
    };

    void find_targets(const Solids& solids, std::size_t axis);
    void find_faces_beside(const Solids& solids);

    Lattice lattice_;
    std::array<Component, 3> components_;
    /// Scratch memory: for one component, the fitted velocities of faces in solids
    std::vector<float> values_;
};

}  // namespace thaum::fluid
