// haptics/fluid_touch.h: forces on a hand that stirs: from a fluid, its surface and its bowl (Mora and Lee
// 2008, "Real-time 3D fluid interaction with a haptic user interface", sections 4.1, 5 and 7). A part of the
// servo step.
//
//     FluidTouch (the model: flow round the probe, surface, bowl) --.
//     tip, velocity ------------------------------------------------+--> feel_fluid() --> forces on the hand
//     FluidTouchState ----------------------------------------------'                     by kind, and the
//                                                                                         force for the fluid
//
// There are two frames and two scales (HAPTICS.md, "Couplings and fluid"). The bowl frame has y up and an
// origin that the game chooses (m). Flow, surface and wall are in the bowl frame. x and v are position and
// velocity of the tip in the device frame, R the rotation to the bowl frame, s_x and s_f the scales of length
// and force (BowlFrame), F a force in the bowl frame:
//
//     place P = origin + R s_x x        velocity V = R s_x v        force on the hand f = s_f R^T F
//
// Each force is a mode with a strength w from 0 (off, at no cost) to 1. The flow at P has velocity u,
// viscosity mu and density rho (flow_patch.h). The immersed share of the ladle is i, 0 to 1. `viscous` (m)
// and `form` (m^3/s) are coefficients of the ladle's drag (LadleDrag). A spring has stiffness k, a damper b:
//
//     viscosity   F = - w_v i viscous mu V              (1)  as in a medium at rest: passive
//     flow        F = + w_f i viscous mu u              (2)  carries a relaxed hand: an active source
//     resistance  F = - w_r i form rho (V - u)          (3)  against the current: passive, its other end is
//                                                            the flow
//     surface     F = w_s clamp(k (h - P_y), 0, pop) y  (4)  from outside; from inside clamp(.., -cling, 0).
//                                                            The spring of fluid/spring_surface.h: passive,
//                                                            the surface moves its end
//     wall        F = w_b max(0, k |N - P| + b V_out)   (5)  inwards: passive. N: nearest place in the bowl,
//                                                            V_out: outward speed along P - N
//     inertia     F = w_m (k (M - P) + b (M' - V))      (6)  m M'' = -F: a mass of its own, felt as
//                                                            s_f s_x m; passive
//     recoil      a Pulse (servo.h), see recoil_peak()  (7)  active
//
// In (4), h is the height of the surface. The surface pushes a probe outside with at most `pop` until the
// probe breaks through, and pulls a probe inside with at most `cling`. In (6), the ladle's own mass m is at
// the place M and moves with the velocity M'.
//
// With equal strengths, (1) and (2) are the Stokes drag -viscous mu (V - u); a sphere of radius a has viscous
// = 6 pi a. (3) is the form drag C_d A rho U^2 / 2 of an obstacle with the drag coefficient C_d and the
// frontal area A, made proportional to the speed: form = C_d A U / 2 at the speed U of stirring. mu and rho
// already contain the sums over the substances. (1) alone resists the hand and (2) alone guides it. With (3)
// the hand fights the current until the flow has given way. These are the modes of section 7.
//
// The flow changes every 16 ticks, and the hand feels every tick. (1) to (3) are interpolated linearly in
// time between their values for the two newest fluid steps. A step is felt as 16 changes of 1/16 of its size,
// one fluid step late. The hand's push changes u one to two fluid steps later. With this delay, the loop from
// the hand through the fluid back to the hand oscillates. The oscillation decays while the loop's gain (w_f
// viscous mu + w_r form rho) T / stirred_mass is below 0.83, with T = 16 ms and a hand that is held fast. All
// drags are scaled down together so that the gain stays below `loop_gain`. They also keep the damping that
// the hand feels, s_f s_x (w_v viscous mu + w_r form rho), below the device's limit. The damper of the
// ladle's mass takes its share of that limit first, at most half.
//
// Energy (energy.h): for (3), the passivity observer is told the power F u in the newest step's flow, so it
// sees the energy that the delay creates. For (4), it is told the work F dh of a surface that rises by dh.
// The force (2) is within the budget of active sources.
//
// A game does the following in each tick for a player who stirs. For any other player FluidTouch::number is
// 0, which costs one compare. If all strengths are 0, nothing is felt, but the ladle's place is computed.
//
//   1. At the end of a fluid step: add_fluid_step(touch, patch_of(source, middle)). `middle` is the tip's
//      place in the bowl, moved on by its velocity for some 16 ms, because the patch is read for 32 ms. In
//      every other tick: ++touch.step_age. `older`, `newer` and `step_age` decide future forces and do not
//      follow from the fluid. They are state and belong in a component.
//   2. surface = the fluid's surface under the probe (ProbeReaction, SpringSurfaceSettings). Its velocity is
//      the change of its height over the time of a fluid step. Without a surface, `present` = 0.
//   3. Frame, drag, wall, ladle and modes from the game's data. The device must be able to render the felt
//      stiffnesses s_f s_x k of all springs. `number` counts from 1 and changes when the probe appears, or
//      when frame, modes or data jump.
//   4. After the servo step: -force_on_ladle(touch, state) is the force on the fluid at state.place in this
//      tick (N, bowl frame). fluid::push gets the sum over 16 ticks, times tick_seconds and divided by the
//      density. The limits of the force on the hand, by its largest allowed value and by the heat of the
//      motors, do not reduce it: the world gets all of it. The surface gets the probe's place and has its own
//      reaction. The ladle is drawn at state.place. If the device gives no sample in a tick, the state stays
//      unchanged, so the last force continues, as on the device.
//   5. When a substance is poured in: start a Pulse with the peak recoil_peak().
//
// Device frame unless stated otherwise. No allocation, no clock.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "core/maths.h"
#include "haptics/flow_patch.h"

namespace thaum::haptics {

/// Strengths of the forces that a fluid gives the hand, 0 (off) to 1. Each force is called a mode.
struct FluidModes {
    double viscosity{1}, flow{1}, resistance{1}, surface{1}, wall{1}, inertia{1}, recoil{1};
};

/// Name of a mode (one kind of force by a fluid), and the member of FluidModes that holds its strength.
struct FluidMode {
    std::string_view name;
    double FluidModes::*strength;
};
/// All modes, the kinds of force that a fluid gives. Their order is part of the format of recorded matches.
inline constexpr std::array<FluidMode, 7> fluid_modes{{{"viscosity", &FluidModes::viscosity},
                                                       {"flow", &FluidModes::flow},
                                                       {"resistance", &FluidModes::resistance},
                                                       {"surface", &FluidModes::surface},
                                                       {"wall", &FluidModes::wall},
                                                       {"inertia", &FluidModes::inertia},
                                                       {"recoil", &FluidModes::recoil}}};

/// Transform from the device frame to the bowl frame.
struct BowlFrame {
    vec3 origin{};                ///< origin of the device frame (m, bowl frame)
    mat3 turn{1.0};               ///< R: rotation from device frame to bowl frame, orthonormal
    double metres_per_metre{1};   ///< s_x: bowl length per device length, > 0
    double newtons_per_newton{};  ///< s_f: device force per world force, >= 0
};

/// Coefficients of the fluid's drag on a ladle.
struct LadleDrag {
    double viscous{};  ///< `viscous` in (1), (2): drag per viscosity and speed, >= 0 (m)
    double form{};     ///< `form` in (3): drag per density and relative speed, >= 0 (m^3/s)
    /// Mass of fluid that a push of the ladle moves (kg): the fluid's density divided by the peak of the
    /// kernel (1/m^3) over which the push is spread. For fluid::push with a radius r it is 32 pi / 105 r^3
    /// times the density. 0: the flow does not react, and no loop limits the drag.
    double stirred_mass{};
    /// Height of the part that dips in (m); the immersed share is (h - P_y) / height. 0: the ladle is
    /// immersed all at once.
    double height{};
};

/// Surface of the fluid under the probe (the tip's place in the bowl) when the haptic model was made.
struct BrewSurface {
    double height{};          ///< height h of the surface (m)
    double velocity{};        ///< upward velocity of the surface (m/s)
    double stiffness{};       ///< stiffness k of the surface's spring, >= 0 (N/m)
    double pop_through{};     ///< largest force on a probe that has not broken through the surface, >= 0 (N)
    double cling{};           ///< largest pull on a probe that has broken through the surface, >= 0 (N)
    std::uint32_t inside{};   ///< 1: the probe has broken through the surface
    std::uint32_t present{};  ///< 0: no surface; the ladle is fully immersed
};

inline constexpr std::size_t wall_points = 8;

/// Inside of a bowl: the space within its profile, rotated about the upright axis. The profile runs from the
/// rim down to the middle of the floor on the axis, and bends one way only. The inside is therefore convex,
/// with one nearest place for every point. The first piece continues above the rim.
struct BowlWall {
    vec3 centre{};  ///< point on the bowl's axis from which heights are measured (m)
    /// Distance from the axis, and height above the centre (m); the first `points` are in use.
    std::array<vec2, wall_points> profile{};
    std::uint64_t points{};  ///< number of profile points; below 2: no wall
    double stiffness{};      ///< stiffness of the wall, >= 0 (N/m)
    double damping{};        ///< damping of the wall, >= 0 (N s/m); felt as far as the device's damping limit
                             ///< allows
};

/// The ladle's own mass (equation 6), which a spring ties to the hand.
struct LadleMass {
    double mass{};       ///< mass (kg); 0: none
    double stiffness{};  ///< stiffness of the spring between mass and hand, > 0 (N/m)
    /// Damping of that spring, >= 0 (N s/m); at most half of the device's limit is rendered.
    double damping{};
};

inline constexpr std::uint32_t fluid_period = 16;  ///< time between two steps of the fluid (ticks)
/// Largest gain of the loop from the hand through the fluid back to the hand (see the top of this file).
inline constexpr double loop_gain = 0.4;

/// Fluid part of the haptic model: description of the fluid, its surface and its bowl for the servo.
struct FluidTouch {
    /// 0: no fluid. The number changes when the fluid appears or jumps. The safety stage then fades the force
    /// from the old to the new one.
    std::uint64_t number{};
    FluidModes modes{};
    BowlFrame frame{};
    LadleDrag drag{};
    BrewSurface surface{};
    BowlWall wall{};
    LadleMass ladle{};
    FlowPatch older{}, newer{};  ///< flow around the tip after the two newest fluid steps
    std::uint64_t step_age{};    ///< ticks since the flow patch `newer` was taken, 0 in the first tick
};
static_assert(sizeof(FluidTouch) == 58 * sizeof(double) + 2 * sizeof(FlowPatch), "no padding");

/// Adds the flow patch (flow around the tip) of a new fluid step: `newest` becomes `newer` and the patch
/// before it `older`. The first patch becomes both.
void add_fluid_step(FluidTouch& fluid, const FlowPatch& newest);

/// State of the forces by a fluid; no padding. All zero without a fluid.
struct FluidTouchState {
    /// Sum of viscosity (1), flow (2) and resistance (3) on the hand, before the limits by energy budget,
    /// largest allowed force and heat of the motors (N).
    vec3 force{};
    /// Place of the probe, kept inside the bowl even if the hand does not feel the wall (m, bowl frame).
    vec3 place{};
    vec3 wall{};                            ///< force of the wall on the hand, equation (5) (N)
    vec3 mass_position{}, mass_velocity{};  ///< position and velocity of the ladle's own mass (m, m/s)
    double surface_force{};   ///< upward force of the surface, equation (4), in the bowl frame (N)
    double surface_height{};  ///< height h of the surface at which `surface_force` acted (m)
    /// Energy that the flow gives by its resistance (3) in the coming tick, at the hand's scale (J).
    double flow_work{};
    double immersed{};  ///< immersed share of the ladle, 0 to 1
    /// FluidTouch::number of the last tick; 0: there was no fluid. If the present number differs, the fluid
    /// has appeared, ended or jumped.
    std::uint64_t number{};
    std::uint32_t inside{};  ///< 1: the probe had broken through the surface in the last tick
    std::uint32_t begun{};   ///< 0: the fluid is new, so mass and surface have no earlier values
};
static_assert(sizeof(FluidTouchState) == 5 * sizeof(vec3) + 5 * sizeof(double) + 2 * sizeof(std::uint32_t));

/// Motion of the tip, and limits for its forces (device frame).
struct FluidTip {
    vec3 position{}, velocity{};  ///< position and velocity of the tip (m, m/s)
    /// Ticks since the haptic model, from which the forces are computed, was made.
    std::uint32_t model_age{};
    double max_damping{};  ///< largest damping that the device renders (N s/m)
};

/// Forces on the hand (N), and energies for the passivity observer, which checks that passive forces create
/// none.
struct FluidForces {
    vec3 passive{}, active{};
    /// Energy held by the springs of surface, wall and ladle and by the ladle's mass, at the hand's scale
    /// (J).
    double stored{};
    /// Energy that flow and surface gave to the force commanded in the last tick (J).
    double supplied{};
};

/// Returns true if the fluid appeared, ended or jumped. The state is then reset.
bool detect_fluid_switch(FluidTouchState& state, const FluidTouch& fluid);

/// Computes the forces of one tick with a fluid. A part (flow, surface, wall or ladle) that is not finite
/// gives no force.
FluidForces feel_fluid(const FluidTouch& fluid, FluidTouchState& state, const FluidTip& tip);

/// Force of the flow on the ladle as commanded in the last tick (N, bowl frame). The fluid gets the opposite.
vec3 force_on_ladle(const FluidTouch& fluid, const FluidTouchState& state);

/// Sum of the forces of viscosity (1), flow (2) and resistance (3) on a ladle at full strengths, without any
/// limit by a device (N, bowl frame). It equals force_on_ladle if all strengths are full and the device can
/// render them. A world whose hands may feel less of this force, or nothing, gives the opposite of it to the
/// fluid.
vec3 full_drag(const FluidTouch& fluid, vec3 place, vec3 velocity, double immersed,
               std::uint32_t model_age = 0);

/// Peak (N, device frame) of a pulse of `length` ticks that gives the hand `impulse` (N s, bowl frame) times
/// the strength of the mode recoil. It is the kick that the hand feels when the ladle throws something in.
vec3 recoil_peak(const FluidTouch& fluid, vec3 impulse, std::uint32_t length);

/// A place of the device frame in the bowl's frame (m).
vec3 to_bowl(const BowlFrame& frame, vec3 device);

/// Nearest place in the bowl. A place inside, a place that is not finite, and any place without a wall is
/// returned unchanged.
vec3 nearest_in_bowl(const BowlWall& wall, vec3 place);

}  // namespace thaum::haptics
