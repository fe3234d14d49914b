// field/analytic.h: fields given by formulas, with their exact derivatives.
//
//     scalar    Sphere, Plane, Gyroid        depth below a surface, or a wave; the surface is at 0
//     vector    RankineVortex, BeltramiFlow  flows with a known curl
//               VortexFlow                   three Rankine vortices and noise, from a seed (the game's orb)
//
// Each can be called with a place, so `field_of<Scalar>(Sphere{...})` makes a field. They fill procedural
// volumes (field/volume.h) and are the exact values against which sampled fields are measured. Results have
// the same bits on every processor.
//
// The Rankine vortex is a core that turns as a rigid body in a flow without curl (Rankine 1858). In a
// Beltrami flow the curl is parallel to the velocity; this one is Arnold's, Beltrami's and Childress's (ABC).
//
// Functions are plain and do not allocate. Lengths are in m, speeds in m/s.
#pragma once
#include <array>
#include <cstdint>

#include "field/field.h"

namespace thaum::field {

/// Depth inside a sphere: positive inside, negative outside (m).
struct Sphere {
    vec3 middle{};
    double radius{1};

    Scalar operator()(vec3 place) const;
};

/// Depth below a plane: positive on the side away from `normal` (m).
struct Plane {
    vec3 through{};        ///< any point on the plane
    vec3 normal{0, 1, 0};  ///< normal of the plane, a unit vector

    Scalar operator()(vec3 place) const;
};

/// The gyroid wave sin x cos y + sin y cos z + sin z cos x, scaled to the same period along each axis. Its
/// values lie between -1.5 and 1.5.
struct Gyroid {
    double period{1};  ///< length of a period along each axis (m)
    vec3 phase{};      ///< place at which the value is 0 and each of the three sines begins to rise (m)

    Scalar operator()(vec3 place) const;
};

/// A straight vortex. Its speed rises with the distance from the axis up to `radius` and falls as the inverse
/// of the distance beyond.
struct RankineVortex {
    vec3 middle{};  ///< any point on the axis
    /// Axis of the flow, a unit vector; the flow turns about the axis by the right-hand rule.
    vec3 axis{0, 1, 0};
    double radius{1};  ///< radius of the core, which turns like a rigid body; > 0 (m)
    double speed{1};   ///< speed at the edge of the core, where it is greatest (m/s)

    Vector operator()(vec3 place) const;
};

/// A periodic flow whose curl is `wave` times its velocity.
struct BeltramiFlow {
    vec3 strength{1};  ///< strengths A, B and C of the three waves that make up the flow (m/s)
    double wave{1};    ///< wave number (1/m)

    Vector operator()(vec3 place) const;
};

/// A transverse wave: its velocity is at right angles to its direction, so it has no divergence.
struct FlowWave {
    vec3 wave{};      ///< wave number along each axis (1/m)
    vec3 velocity{};  ///< velocity at a crest (m/s); at a right angle to `wave`
    double phase{};   ///< angle of the wave at the origin (rad)

    Vector operator()(vec3 place) const;
};

/// A flow that is the sum of three vortices and weak noise.
struct VortexFlow {
    std::array<RankineVortex, 3> vortices{};
    std::array<FlowWave, 6> noise{};

    Vector operator()(vec3 place) const;
};

/// Makes a flow about the origin from a seed. The axes pass within 0.3 extents of the origin, and the first
/// vortex is the strongest: 1 m/s at the edge of its core. `extent` is the edge length of the box that the
/// flow fills (m).
VortexFlow make_vortex_flow(double extent, std::uint64_t seed);

}  // namespace thaum::field
