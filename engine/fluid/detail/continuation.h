// fluid/detail/continuation.h: velocity continued beyond solids along which the fluid slips freely.
//
// Advection reads velocities at the centres of faces on all sides of a face. Beside a solid, a closed face
// has no velocity, and that of a cut face belongs to the centre of its open part. If advection used these
// values, every piece of wall would drag the flow, however fine the grid is: by a quarter in a second at 32
// and at 48 cells. So advection reads values that continue the flow: a linear function is fitted to the
// velocities on the open faces around and evaluated at the centre of the face. A flow that turns as a rigid
// body is then advected exactly.
//
// A continued flow has some divergence, and its energy is not conserved. So the faces beside it get two
// additional terms: that of the divergence (momentum.h leaves it out), and a share of upwind differences.
// Both are zero for a rigid turn. The second takes the energy of waves that are too short for the grid.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fluid/detail/momentum.h"
#include "fluid/detail/solids.h"

namespace thaum::fluid {

/// The continuation of the flow beside the solids of one lattice. Made once.
class Continuation {
public:
    Continuation(const Lattice& lattice, const Solids& solids);

    /// Replaces the velocities on cut faces, and on closed faces beside fluid, by continued ones. Neither
    /// reads nor writes ghost cells.
    void apply(std::array<Samples, 3>& velocity);
    /// Adds the terms of divergence and upwind differences (see the top of this file) to a Runge-Kutta stage
    /// that Momentum has computed from a continued velocity.
    void correct(const RungeKuttaStage& stage) const;

private:
    /// An open face, and its weight in the continued velocity of another face.
    struct Source {
        std::uint32_t at{};  ///< index of the face in the samples
        float weight{};
    };
    /// A face whose velocity is continued: replaced by the weighted sum of the velocities of other faces, its
    /// sources.
    struct Target {
        std::uint32_t at{};  ///< index of the face in the samples
        /// Index of the target's first source; the sources end where those of the next target begin.
        std::uint32_t first{};
    };
    /// Continued velocities of one component, by their faces and the faces from which they are computed.
    struct Component {
        /// The faces with continued velocities, then an entry without sources. It marks the end of the last
        /// face's sources.
        std::vector<Target> targets;
        /// Sources of each target, padded to a multiple of four with weights of 0.
        std::vector<Source> sources;
        /// Indices of the open faces whose advection reads continued velocities.
        std::vector<std::uint32_t> beside;
    };

    void find_targets(const Solids& solids, std::size_t axis);
    void find_faces_beside(const Solids& solids);

    Lattice lattice_;
    std::array<Component, 3> components_;
    std::vector<float> values_;  ///< scratch memory: continued velocities of one component
};

}  // namespace thaum::fluid
