// haptics/flow_patch.h: the part of a flow around the probe that the haptic model carries. The servo reads
// the flow from it at 1 kHz without access to the fluid:
//
//     fields of the fluid (field/field.h) -patch_of()-> FlowPatch (64 nodes)
//                                         -flow_at()--> velocity, viscosity, density
//
// Values are linear between nodes along each axis. Beyond the outermost nodes, the value is that of the
// nearest place within. A patch stays where it was taken. Its nodes are whole spacings away from the first
// sample of the velocity's x component. Overlapping patches therefore have the same nodes, and a flow at rest
// reads the same from each.
//
// Plain data, no allocation. Frame: that of the bowl (haptics/fluid_touch.h), in m.
#pragma once
#include <array>
#include <cstddef>

#include "core/maths.h"
#include "field/field.h"

namespace thaum::haptics {

inline constexpr int flow_nodes = 4;  ///< number of nodes of a flow patch along each axis
inline constexpr std::size_t flow_substances = 3;

/// The fluid at one place.
struct FlowNode {
    fvec3 velocity{};   ///< velocity of the flow (m/s)
    float viscosity{};  ///< viscosity of the mixture (Pa s)
    float density{};    ///< density of the mixture (kg/m^3)
};

/// Nodes of a flow. Node (i, j, k) is nodes[i + 4 j + 16 k] at origin + spacing (i, j, k).
struct FlowPatch {
    vec3 origin{};  ///< position of node (0, 0, 0) (m)
    /// Distance between nodes (m); 0: no patch was taken, which reads as zero everywhere.
    double spacing{};
    std::array<FlowNode, std::size_t{flow_nodes} * flow_nodes * flow_nodes> nodes{};
};
static_assert(sizeof(FlowPatch) == 4 * sizeof(double) + 64 * 5 * sizeof(float));

/// Values of a flow at one place.
struct FlowSample {
    vec3 velocity{};     ///< velocity (m/s)
    double viscosity{};  ///< viscosity (Pa s)
    double density{};    ///< density (kg/m^3)
};

/// Reads the flow at a place. Finite if the nodes around it are; all zero if the place is not finite.
FlowSample flow_at(const FlowPatch& patch, vec3 place) noexcept;

/// A substance in the mixture. It adds its viscosity and density in proportion to its amount.
struct FlowSubstance {
    field::Grid amount{};  ///< amount of the substance; no samples: none of it
    double viscosity{};    ///< viscosity that the amount 1 adds (Pa s)
    double density{};      ///< density that the amount 1 adds (kg/m^3)
};

/// Fields of the fluid from which a patch is taken. The mixture is weighted by amounts (Mora and Lee 2008,
/// 4.1): viscosity and density at a place grow by the sum of amount times value over the substances.
/// Viscosity and density are never below 0.
struct FlowSource {
    field::StaggeredGrid velocity{};  ///< velocity (m/s); read linearly, whatever kernel its grids name
    double viscosity{};               ///< viscosity of the base fluid (Pa s)
    double density{};                 ///< density of the base fluid (kg/m^3)
    std::array<FlowSubstance, flow_substances> substances{};
};

/// Takes a patch with the spacing of the velocity's samples (their smallest one along any axis). `middle` (m)
/// lies in its middle cell. The patch is empty if `middle` is not finite or the velocity has no samples.
FlowPatch patch_of(const FlowSource& source, vec3 middle) noexcept;

}  // namespace thaum::haptics
