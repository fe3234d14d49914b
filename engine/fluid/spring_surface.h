// fluid/spring_surface.h: the brew's surface, a sheet of masses and springs that a probe can push, break through and leave (paper
// 000, section 5).
//
//     o---o---o     structural springs along the sides of the lattice, shear springs along its diagonals; all of no rest
//     | X | X |     length and drawn tight, as a soap film is. The force of such a spring is stiffness times the vector
//     o---o---o     between its ends, so the three directions do not know of each other: what is pushed straight down moves
//     | X | X |     straight down, at any depth and exactly, and a node needs its height alone.
//     o---o---o
//
// With tension T and areal mass m it is a membrane of wave speed sqrt(T / m), at any number of nodes. A third of the
// tension in the shear springs makes the waves of all directions equally fast but for the fourth order of their number,
// and the stiffest mode softer than structural springs alone would: that is the default.
//
// A probe holds the sheet by a spring between itself and the height under it, a mean weighted by its footprint. Pushed
// beyond the pop-through force it is inside and feels the surface no more; when it rises through it the surface clings to it and is
// pulled up, until a smaller force tears it off: the last ripple.
//
// Time: classical Runge-Kutta of fourth order, in equal sub-steps that the stiffest mode chooses: `longest_step` rad of it each.
// The energy then never grows. The sub-steps of a call are bounded; a sheet that asks for more advances by less time than it was given, and
// says so: slow motion, in which forces and energy stay right, instead of a sheet that flies apart.
//
// Frame: x and z from the middle of the square, y up from the level surface. Plain data; no clock, no allocation after the first call.
// A sheet that has its eight mirror images' symmetry keeps it to the bit.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::fluid {

enum class Rim : std::uint32_t {
    pinned,  ///< the outermost nodes stay level
    free,    ///< waves are thrown back as they came; needs `level` or it will not come back to level itself
};

struct SpringSurfaceSettings {
    std::uint32_t nodes{33};  ///< on a side, 3 to 129; `classic_nodes` as in the paper
    Rim rim{};                //
    double side{2};           ///< m, > 0
    double tension{600};      ///< N/m, >= 0
    double shear{1.0 / 3};    ///< the part of the tension in the shear springs, 0 to 1
    double areal_mass{250};   ///< kg/m^2, > 0
    double level{};           ///< N/m per m^2, >= 0: what gravity adds, density times g
    double damping{1};        ///< 1/s, >= 0: velocity falls by e^-1 in 1 / damping
    double contact{5000};     ///< N/m, >= 0: of the spring to the probe
    double pop_through{200};  ///< N, >= 0
    double cling{40};         ///< N, >= 0: the pull that tears it off a probe that leaves
    double reach{0.3};        ///< m, > 0: how deep a push is felt, see transmitted()
    double still{1e-5};  ///< m, >= 0: a sheet with less energy than tension times this squared falls asleep
    std::uint32_t most_steps{32};  ///< sub-steps of a call, 1 to 1000
};

inline constexpr std::uint32_t classic_nodes = 15;
inline constexpr std::size_t surface_probe_capacity = 4;
inline constexpr double longest_surface_call = 0.1;  ///< s; more than that counts as that

/// The error names the setting that is out of its range or not finite.
Expected<SpringSurfaceSettings> checked(const SpringSurfaceSettings& settings);

/// What touches the sheet.
struct SurfaceProbe {
    vec2 place{};     ///< m, x and z
    double height{};  ///< m, of its lowest point above the level surface
    double radius{};  ///< m; less than one and a half spacings counts as that
};

/// State: all that decides the future.
struct SpringSurface {
    SpringSurfaceSettings settings{};
    /// m and m/s, (nodes + 2) rows of surface_row_stride: node (x, z) at surface_node_index; outside the nodes lies what the rim mirrors.
    std::vector<double> height{}, velocity{};
    std::array<std::uint32_t, surface_probe_capacity> inside{};  ///< 1: this probe has broken through
    std::uint32_t asleep{1};  ///< 1: every height and velocity is exactly 0
};

/// Room for what lies outside and, so that no row of vectors needs a remainder, for three more.
constexpr std::size_t surface_row_stride(const SpringSurfaceSettings& s) {
    return (s.nodes + std::size_t{7}) / 4 * 4;
}
constexpr std::size_t surface_node_index(const SpringSurfaceSettings& s, std::size_t x, std::size_t z) {
    return (z + 1) * surface_row_stride(s) + x + 1;
}
/// m, between neighbours.
constexpr double surface_node_spacing(const SpringSurfaceSettings& s) { return s.side / (s.nodes - 1); }

/// A level sheet; settings must be checked.
SpringSurface make_spring_surface(const SpringSurfaceSettings& settings);

/// To be called after heights or velocities were written from outside: a pinned rim is level again, what a free one mirrors
/// follows, the sheet is awake.
void refresh_after_edit(SpringSurface& surface);

/// To be kept from call to call; what it holds means nothing.
struct SpringSurfaceScratch {
    std::vector<double> values{};
};

struct ProbeReaction {
    double
        force{};  ///< N, up on the probe; the mean over the call, so that force times seconds is the impulse the sheet got. At most
                  ///< pop_through, at least -cling
    double height{};  ///< m, of the sheet under the probe, at the end
    bool inside{};
};

struct SpringSurfaceStep {
    std::array<ProbeReaction, surface_probe_capacity> probes{};
    double seconds{};         ///< by which it advanced; less than dt where the sub-steps were not enough
    std::uint32_t steps{};    ///< sub-steps; 0 while asleep
    std::uint32_t visited{};  ///< nodes, over all sub-steps
};

/// Advances by dt s under probes that stay where they are. Probes are known from call to call by their number; one that
/// is not finite is not there, nor is one beside the sheet, or beyond the capacity. dt that is not above 0 does nothing.
SpringSurfaceStep advance(SpringSurface& surface, SpringSurfaceScratch& scratch,
                          std::span<const SurfaceProbe> probes, double dt);

/// J: of motion, springs and level.
double energy(const SpringSurface& surface);

/// rad/s: above every frequency that the sheet has by itself.
double stiffest_frequency(const SpringSurfaceSettings& settings);

/// rad/s: of the lattice's mode (p, q), undamped, in closed form. Pinned, from 1 to nodes - 2: sin(p pi x / (nodes - 1)) sin(q pi z / (nodes - 1)) at node
/// (x, z). Free, from 0 to nodes - 1: cos(p pi (x + 1/2) / nodes) cos(...).
double mode_frequency(const SpringSurfaceSettings& settings, std::uint32_t p, std::uint32_t q);

/// m, above level, between the nodes linearly; 0 beside the sheet.
double height_at(const SpringSurface& surface, vec2 place);

/// The part of the surface's displacement that reaches a layer at `depth` m, of `density` relative to the base fluid's: e^(-depth
/// density / reach). 1 above the surface, 0 for what is not finite.
double transmitted(const SpringSurfaceSettings& settings, double depth, double density);

}  // namespace thaum::fluid
