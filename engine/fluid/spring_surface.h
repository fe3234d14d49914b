// fluid/spring_surface.h: the brew's surface as a lattice of masses and springs. A probe can push it, break
// through and leave (paper 000, Mora and Lee 2008, section 5).
//
//     o---o---o     Structural springs lie along the sides of the lattice, shear springs along its
//     | X | X |     diagonals. All have rest length zero and are stretched, like a soap film. The force of
//     o---o---o     such a spring is its stiffness times the vector between its ends, so the three directions
//     | X | X |     are independent. A node that is pushed straight down moves straight down, exactly and at
//     o---o---o     any depth. Each node therefore needs only a height.
//
// With tension T and areal mass m the surface is a membrane with wave speed sqrt(T / m), for any number
// of nodes. By default a third of the tension is in the shear springs. Waves of all directions are then
// equally fast up to fourth order in their wave number. The stiffest mode is also softer than with
// structural springs alone.
//
// A spring connects the probe to the surface. Its end at the surface is the mean height under the probe,
// weighted more near its middle. If the force reaches `pop_through`, the probe breaks through and feels the
// surface no more. When the probe rises through it again, the surface clings to it and is pulled up. A
// smaller force, `cling`, tears the surface off the probe.
//
// Time stepping is classical Runge-Kutta of fourth order, in equal sub-steps. In each, the phase of the
// stiffest mode of oscillation advances by at most `max_phase` rad, so the energy never grows. The number of
// sub-steps of a call is bounded. If more are needed, the surface advances by less than the given time and
// reports that time. The surface is then in slow motion, but forces and energy stay right, whereas longer
// steps would be unstable.
//
// Frame: x and z from the centre of the square, y up from the level surface. All is plain data, without
// clocks, and without allocation after the first call. A surface that is its own mirror image, in any of
// eight ways, remains so to the bit.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::fluid {

/// Behaviour of the outermost nodes.
enum class Rim : std::uint32_t {
    pinned,  ///< the outermost nodes stay level
    /// Waves are reflected without inversion; only gravity (`level`) brings the surface back to level.
    free,
};

/// Settings of a spring surface; the defaults are valid.
struct SpringSurfaceSettings {
    std::uint32_t nodes{33};  ///< number of nodes on a side, 3 to 129; the paper has `classic_nodes`
    Rim rim{};                // rule for the outermost nodes
    double side{2};           ///< side length of the square, > 0 (m)
    double tension{600};      ///< total tension of the springs, >= 0 (N/m)
    double shear{1.0 / 3};    ///< share of the tension in the shear springs, 0 to 1
    double areal_mass{250};   ///< mass per area, > 0 (kg/m^2)
    /// Stiffness of the surface by gravity, which draws it level, for each unit of area: density times g, >=
    /// 0 (N/m^3).
    double level{};
    double damping{1};        ///< decay rate: velocity falls to 1/e in 1 / damping, >= 0 (1/s)
    double contact{5000};     ///< stiffness of the spring to the probe, >= 0 (N/m)
    double pop_through{200};  ///< force at which a probe breaks through the surface, >= 0 (N)
    double cling{40};         ///< pull that tears the surface off a leaving probe, >= 0 (N)
    /// Depth over which a push decays by a factor of e in the base fluid, see transmitted(), > 0 (m).
    double reach{0.3};
    /// Amplitude of waves that counts as still, >= 0 (m): the surface falls asleep if its energy is below
    /// tension times still^2.
    double still{1e-5};
    std::uint32_t max_steps{32};  ///< largest number of sub-steps of a call, 1 to 1000
};

inline constexpr std::uint32_t classic_nodes = 15;        ///< number of nodes on a side in the paper
inline constexpr std::size_t surface_probe_capacity = 4;  ///< largest number of probes
/// Longest time by which one call advances; longer times are cut to this (s).
inline constexpr double longest_surface_call = 0.1;

/// Checks settings. The error names the setting that is out of range or not finite.
Expected<SpringSurfaceSettings> checked(const SpringSurfaceSettings& settings);

/// A probe that touches the surface.
struct SurfaceProbe {
    vec2 place{};     ///< position, x and z (m)
    double height{};  ///< height of the probe's lowest point above the level surface (m)
    double radius{};  ///< radius, raised to at least 1.5 node spacings (m)
};

/// State of the surface: everything that decides its future.
struct SpringSurface {
    SpringSurfaceSettings settings{};
    /// Heights (m) and velocities (m/s): nodes + 2 rows of surface_row_stride values. Node (x, z) is at
    /// surface_node_index. The values around the nodes are mirror images at the rim.
    std::vector<double> height{}, velocity{};
    /// 1: the probe of this index has broken through the surface.
    std::array<std::uint32_t, surface_probe_capacity> inside{};
    std::uint32_t asleep{1};  ///< 1: the surface sleeps, since every height and velocity is exactly 0
};

/// Length of a row: the nodes, one value on each side, and padding so that rows divide into whole
/// vectors.
constexpr std::size_t surface_row_stride(const SpringSurfaceSettings& s) {
    return (s.nodes + std::size_t{7}) / 4 * 4;
}
/// Index of a node in the arrays of a SpringSurface; x and z count the nodes from 0.
constexpr std::size_t surface_node_index(const SpringSurfaceSettings& s, std::size_t x, std::size_t z) {
    return (z + 1) * surface_row_stride(s) + x + 1;
}
/// Distance between neighbouring nodes (m).
constexpr double surface_node_spacing(const SpringSurfaceSettings& s) { return s.side / (s.nodes - 1); }

/// Makes a level surface; the settings must be checked.
SpringSurface make_spring_surface(const SpringSurfaceSettings& settings);

/// Must be called after heights or velocities were changed from outside. Makes a pinned rim level
/// again, renews the mirror images and wakes the surface.
void refresh_after_edit(SpringSurface& surface);

/// Working memory, kept from call to call so that only the first one allocates. Its contents have no meaning
/// between calls.
struct SpringSurfaceScratch {
    std::vector<double> values{};
};

/// Effect of the surface on one probe during a call.
struct ProbeReaction {
    /// Upward force on the probe, at least -cling and at most pop_through (N). It is the mean over the call,
    /// so force times seconds is the impulse on the surface.
    double force{};
    double height{};  ///< height of the surface under the probe at the end (m)
    bool inside{};    ///< true: the probe has broken through the surface
};

/// Result of one call of advance().
struct SpringSurfaceStep {
    std::array<ProbeReaction, surface_probe_capacity> probes{};
    /// Time by which the surface advanced; less than dt if the sub-steps were not enough (s).
    double seconds{};
    std::uint32_t steps{};    ///< number of sub-steps; 0 while asleep
    std::uint32_t visited{};  ///< work of the call: number of nodes, summed over all sub-steps
};

/// Advances by dt (s) under probes that do not move. Probes are identified by their index from call to
/// call. A probe counts as absent if it is not finite, beside the surface, or beyond the capacity. Does
/// nothing unless dt > 0.
SpringSurfaceStep advance(SpringSurface& surface, SpringSurfaceScratch& scratch,
                          std::span<const SurfaceProbe> probes, double dt);

/// Energy of motion, of the springs and of gravity (J).
double energy(const SpringSurface& surface);

/// Upper bound for the angular frequencies of all oscillations of the surface without probes (rad/s).
double stiffest_frequency(const SpringSurfaceSettings& settings);

/// Angular frequency of the lattice's undamped mode (p, q), in closed form (rad/s). The mode's height at node
/// (x, z) is:
///
///     pinned, p and q from 1 to nodes - 2    sin(p pi x / (nodes - 1)) sin(q pi z / (nodes - 1))
///     free, p and q from 0 to nodes - 1      cos(p pi (x + 1/2) / nodes) cos(q pi (z + 1/2) / nodes)
double mode_frequency(const SpringSurfaceSettings& settings, std::uint32_t p, std::uint32_t q);

/// Height of the surface above its level state (m), linear between nodes; 0 beside the square.
double height_at(const SpringSurface& surface, vec2 place);

/// Share of the surface's displacement that reaches `depth` (m) in a fluid with `density` relative to the
/// base fluid: e^(-depth density / reach). 1 above the surface, 0 if an argument is not finite.
double transmitted(const SpringSurfaceSettings& settings, double depth, double density);

}  // namespace thaum::fluid
