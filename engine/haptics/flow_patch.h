// haptics/flow_patch.h: the piece of a flow round the probe that the haptic model carries, so that the servo can read the flow at
// 1 kHz without knowing the fluid:
//
//     fields of the fluid (field/field.h) --patch_of()--> FlowPatch (64 nodes) --flow_at()--> velocity, viscosity, density
//
// Between nodes linear along each axis; beyond the outermost all is as at the nearest place within. A patch stands where it was
// taken. Its nodes stand at whole spacings from the first sample of the velocity's x, so that patches which overlap have the
// same nodes, and a flow that rests reads the same from each.
//
// Plain data, no allocation. Frame: the bowl's (haptics/fluid_touch.h), m.
#pragma once
#include <array>
#include <cstddef>

#include "core/maths.h"
#include "field/field.h"

namespace thaum::haptics {

inline constexpr int flow_nodes = 4;  ///< along each axis
inline constexpr std::size_t flow_substances = 3;

struct FlowNode {
    fvec3 velocity{};   ///< m/s
    float viscosity{};  ///< Pa s, of the mixture
    float density{};    ///< kg/m^3, of the mixture
};

/// Node (i, j, k) is nodes[i + 4 j + 16 k] and stands at origin + spacing (i, j, k).
struct FlowPatch {
    vec3 origin{};     ///< m
    double spacing{};  ///< m; 0: no patch has been taken, which reads as nothing at rest
    std::array<FlowNode, std::size_t{flow_nodes} * flow_nodes * flow_nodes> nodes{};
};
static_assert(sizeof(FlowPatch) == 4 * sizeof(double) + 64 * 5 * sizeof(float));

/// What a place in a flow feels like.
struct FlowSample {
    vec3 velocity{};     ///< m/s
    double viscosity{};  ///< Pa s
    double density{};    ///< kg/m^3
};

/// Finite where the nodes about it are; nothing for a place that is not finite.
FlowSample flow_at(const FlowPatch& patch, vec3 place) noexcept;

/// A substance in the mixture: where its amount is 1 it adds so much.
struct FlowSubstance {
    field::Grid amount{};  ///< without samples: there is none of it
    double viscosity{};    ///< Pa s
    double density{};      ///< kg/m^3
};

/// What a patch is taken of. The mixture is weighted by amounts (Mora and Lee 2008, 4.1): what a place adds to viscosity and density
/// is the sum over the substances of amount times theirs. Never below 0.
struct FlowSource {
    field::StaggeredGrid velocity{};  ///< m/s; the kernels are not asked, all is read linearly
    double viscosity{};               ///< Pa s, of the base fluid
    double density{};                 ///< kg/m^3, likewise
    std::array<FlowSubstance, flow_substances> substances{};
};

/// With the spacing of the velocity's samples, so that `middle` (m) is within its middle cell. Empty where that is not finite or there
/// are no samples of the velocity.
FlowPatch patch_of(const FlowSource& source, vec3 middle) noexcept;

}  // namespace thaum::haptics
