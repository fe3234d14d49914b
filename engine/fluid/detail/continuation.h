// fluid/detail/continuation.h: velocity continued beyond solids along which the fluid slips freely.
//
// Advection reads velocities at the centres of faces on all sides of a face. Beside a solid, a closed face has no
// velocity, and that of a cut face belongs to the centre of its open part. If both counted as they are, every
// piece of wall would drag the flow, however fine the grid is: by a quarter in a second at 32 and at 48 cells. So
// advection reads values that continue the flow. They are those of a linear function, fitted to the velocities on
// the open faces around, at the centre of the face. A flow that turns as a rigid body is then advected exactly.
//
// A continued flow has some divergence, and nothing keeps its energy. So the faces beside it get two terms more:
// that of the divergence (momentum.h leaves it out), and a share of upwind differences. Both are zero for a rigid
// turn. The second takes the energy of waves that are too short for the grid.
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

    /// Replaces the velocities on cut faces, and on closed faces beside fluid, by continued ones. Neither reads
    /// nor writes ghosts.
    void apply(std::array<Samples, 3>& velocity);
    /// Adds the two terms to a stage that Momentum has computed from a continued velocity.
    void correct(const RungeKuttaStage& stage) const;

private:
    /// An open face and its part in a continued velocity.
    struct Source {
        std::uint32_t at{};  ///< index in the samples
        float weight{};
    };
    /// A face with a continued velocity.
    struct Target {
        std::uint32_t at{};  ///< index in the samples
        std::uint32_t
            first{};  ///< number of its first source; the last one stands before the next target's first
    };
    /// Faces of one component of the velocity.
    struct Component {
        std::vector<Target> targets;  ///< with one more at the end, which has no sources
        std::vector<Source> sources;  ///< for each target a multiple of four, filled up with weights of 0
        std::vector<std::uint32_t> beside;  ///< open faces whose advection reads continued velocities
    };

    void find_targets(const Solids& solids, std::size_t axis);
    void find_faces_beside(const Solids& solids);

    Lattice lattice_;
    std::array<Component, 3> components_;
    std::vector<float> values_;  ///< scratch: continued velocities of one component
};

}  // namespace thaum::fluid
