// haptics/fluid_touch.h: what a hand feels that stirs: a fluid, its surface and the bowl it stands in (Mora and Lee 2008, "Real-time 3D
// fluid interaction with a haptic user interface", sections 4.1, 5 and 7). A part of the servo step.
//
//     FluidTouch (the model: flow round the probe, surface, bowl) --.
//     tip, velocity ------------------------------------------------+--> feel_fluid() --> forces on the hand, by kind
//     FluidTouchState ----------------------------------------------'                     and the force for the fluid
//
// Two frames, two scales (haptics.md). Bowl frame: m, y up, its origin the game's choice; flow, surface and wall are all in it. With x
// and v of the tip in the device frame, R = `turn` and s_x, s_f:
//
//     place P = origin + R s_x x        velocity V = R s_x v        force on the hand f = s_f R^T F
//
// What is felt has modes, each with a strength w from 0 (off, at no cost) to 1. With the flow's velocity u, viscosity mu
// and density rho at P (flow_patch.h), and i the immersed part of the ladle, 0 to 1:
//
//     viscosity     F = - w_v i viscous mu V               (1)  as if the medium were at rest: passive
//     flow          F = + w_f i viscous mu u               (2)  carries a relaxed hand: an active source
//     resistance    F = - w_r i form rho (V - u)           (3)  against the current; passive, the flow is its other end
//     surface       F = w_s clamp(k (h - P_y), 0, pop) y   (4)  from outside, and clamp(.., -cling, 0) from inside:
//                                                               the spring of fluid/spring_surface.h; passive, the surface moves its end
//     wall          F = w_b max(0, k |N - P| + b V_out)    (5)  inwards; N the nearest place in the bowl, V_out the speed outwards
//                                                               along P - N; passive
//     inertia       F = w_m (k (M - P) + b (M' - V))       (6)  m M'' = minus that: a mass of its own, felt as s_f s_x m; passive
//     recoil        a Pulse (servo.h), see recoil_peak()   (7)  active
//
// (1) and (2) at one strength are the Stokes drag -viscous mu (V - u) (a sphere of radius a has viscous = 6 pi a); (3) is the
// form drag of an obstacle, with its slope at the speed of stirring (C_d A U / 2). Sums over substances are in mu and rho. (1) alone
// challenges the hand, (2) alone guides it, (3) makes it fight the current until the flow has given way: section 7's modes.
//
// The flow comes in steps of 16 ticks, the hand feels each tick. Between what the two newest steps make of them, (1) to (3) go
// linearly in time: a step makes 16 changes of 1/16 of its size, and is felt one step late. What the hand gives comes back in u after
// one to two steps more, and a loop so late rings: it fades while (w_f viscous mu + w_r form rho) T / stirred_mass < 0.83 (with T
// 16 ms; the hand held fast). All drags together are scaled down so that this stays below `loop_gain`, and their slope at the hand,
// s_f s_x (w_v viscous mu + w_r form rho), below the device's own most damping less what the ladle's spring takes of it (at most half).
//
// Energy (energy.h): the book is brought F u from the newest step's flow for (3), so what the lateness creates is seen by
// it, and F dh for (4). (2) is within the budget of active sources.
//
// What the game does with it, each tick, for a player who stirs (else, number 0: it costs one compare; with all strengths 0 nothing is
// felt, and where the ladle is is told all the same):
//
//   1. Where a fluid step ends: newest_step(touch, patch_of(source, middle)), middle = the tip's place in the bowl, led by the velocity
//      by some 16 ms: the patch is read for 32 ms. In each other tick ++touch.step_age. older, newer and step_age decide forces to come
//      and do not follow from the fluid: they are state, to be kept in a component.
//   2. surface = that of the sheet under the probe (ProbeReaction, SpringSurfaceSettings); velocity by difference; `there` = 0 without one.
//   3. Frame, drag, wall, ladle and modes from its data, with felt stiffnesses s_f s_x k that the device can render. Another
//      `number` (from 1, never 0) where the probe comes, or where frame, modes or data jump.
//   4. After the servo step: -force_on_ladle(touch, state) is the force on the fluid, N in the bowl frame, at state.place, for
//      this tick; the sum over 16 ticks, times tick_seconds and per density, is what fluid::push gets. It is not cut by cap or
//      heat: the world gets all of it. The sheet takes the probe's place, and has its own reaction. state.place is where the
//      ladle is drawn, too. A sample that did not come leaves the state, so the last force goes on, as the arm's does.
//   5. A substance that is poured in: kick with recoil_peak().
//
// Device frame where nothing else is said. No allocation, no clock.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "core/maths.h"
#include "haptics/flow_patch.h"

namespace thaum::haptics {

/// Strengths, 0 to 1.
struct FluidModes {
    double viscosity{1}, flow{1}, resistance{1}, surface{1}, wall{1}, inertia{1}, recoil{1};
};

struct FluidMode {
    std::string_view name;
    double FluidModes::*strength;
};
/// All of them. The order is part of the log's format.
inline constexpr std::array<FluidMode, 7> fluid_modes{{{"viscosity", &FluidModes::viscosity},
                                                       {"flow", &FluidModes::flow},
                                                       {"resistance", &FluidModes::resistance},
                                                       {"surface", &FluidModes::surface},
                                                       {"wall", &FluidModes::wall},
                                                       {"inertia", &FluidModes::inertia},
                                                       {"recoil", &FluidModes::recoil}}};

/// From the device's frame to the bowl's.
struct BowlFrame {
    vec3 origin{};                ///< m, bowl frame: where the device's origin is
    mat3 turn{1.0};               ///< R, orthonormal
    double metres_per_metre{1};   ///< s_x, bowl per device, > 0
    double newtons_per_newton{};  ///< s_f, device per world, >= 0
};

struct LadleDrag {
    double viscous{};  ///< m, >= 0
    double form{};     ///< m^3/s, >= 0
    /// kg of fluid that a push moves: its density over the peak of the push's kernel (per m^3), which for fluid::push with a radius r is
    /// 32 pi / 105 r^3 times the density. 0: the flow does not answer, and no loop limits the drag.
    double stirred_mass{};
    double height{};  ///< m, of the part that dips in: immersed is (h - P_y) / height of it; 0: all at once
};

/// Under the probe, as the model's tick has it.
struct BrewSurface {
    double height{};         ///< m, h
    double velocity{};       ///< m/s, up
    double stiffness{};      ///< N/m, >= 0
    double pop_through{};    ///< N, >= 0
    double cling{};          ///< N, >= 0
    std::uint32_t inside{};  ///< 1: the probe has broken through
    std::uint32_t there{};   ///< 0: no surface; the ladle is immersed wherever it is
};

inline constexpr std::size_t wall_points = 8;

/// A bowl's inside: what lies within its profile turned about the upright axis. The profile goes from the rim down to the floor's middle
/// on the axis and turns one way only, so that what is within is convex and has one nearest place to each. Its first piece goes on above
/// the rim.
struct BowlWall {
    vec3 centre{};  ///< m, on the axis
    std::array<vec2, wall_points>
        profile{};           ///< m: how far from the axis, and how high above the centre; the first `points`
    std::uint64_t points{};  ///< below 2: no wall
    double stiffness{};      ///< N/m, >= 0
    double damping{};        ///< N s/m, >= 0; what the device can render of it
};

struct LadleMass {
    double mass{};       ///< kg; 0: none
    double stiffness{};  ///< N/m, > 0: of the spring that ties it to the hand
    double damping{};    ///< N s/m, >= 0: of which the device renders at most half of what it can
};

inline constexpr std::uint32_t fluid_period = 16;  ///< ticks, of a fluid step
inline constexpr double loop_gain = 0.4;

/// What the model has of a fluid.
struct FluidTouch {
    std::uint64_t number{};  ///< 0: there is none; another one where it comes or jumps, which is a switch
    FluidModes modes{};
    BowlFrame frame{};
    LadleDrag drag{};
    BrewSurface surface{};
    BowlWall wall{};
    LadleMass ladle{};
    FlowPatch older{}, newer{};  ///< of the two newest steps
    std::uint64_t step_age{};    ///< ticks since `newer` came: 0 in the first
};
static_assert(sizeof(FluidTouch) == 58 * sizeof(double) + 2 * sizeof(FlowPatch), "no padding");

/// A fluid step has ended: `newest` becomes the newer of the two (both, if it is the first).
void newest_step(FluidTouch& touch, const FlowPatch& newest);

/// All that a tick leaves behind; no padding. All zero where there is no fluid.
struct FluidTouchState {
    vec3 force{};                           ///< N: (1) + (2) + (3) on the hand, before budget, cap and heat
    vec3 place{};                           ///< m, bowl frame: of the probe, held in by the wall, felt or not
    vec3 wall{};                            ///< N: (5)
    vec3 mass_position{}, mass_velocity{};  ///< m, m/s: of the ladle's own mass
    double surface_force{};                 ///< N, of (4), up in the bowl
    double surface_height{};                ///< m, h as it was used
    double flow_work{};      ///< J, that the flow gives in the coming tick by (3), at the hand's scale
    double immersed{};       ///< 0 to 1
    std::uint64_t number{};  ///< of the model; 0: there was none
    std::uint32_t inside{};  ///< of the surface
    std::uint32_t begun{};   ///< 0: mass and surface begin anew
};
static_assert(sizeof(FluidTouchState) == 5 * sizeof(vec3) + 5 * sizeof(double) + 2 * sizeof(std::uint32_t));

struct FluidTip {
    vec3 position{}, velocity{};  ///< m, m/s
    std::uint32_t model_age{};    ///< ticks
    double most_damping{};        ///< N s/m, that the device can render
};

/// On the hand, N, and what the books need.
struct FluidFeel {
    vec3 passive{}, active{};
    double stored{};   ///< J, held by surface, wall and ladle at the hand's scale
    double brought{};  ///< J, that flow and surface gave in the last tick by what was commanded then
};

/// True where it came, went or jumped; the state then begins anew.
bool note_fluid(FluidTouchState& state, const FluidTouch& touch);

/// One tick, where there is a fluid. A part that is not finite is not felt.
FluidFeel feel_fluid(const FluidTouch& touch, FluidTouchState& state, const FluidTip& tip);

/// N, bowl frame, of the fluid's flow on the ladle, as commanded in the last tick; the fluid gets the opposite.
vec3 force_on_ladle(const FluidTouch& touch, const FluidTouchState& state);

/// N, bowl frame: (1), (2) and (3) on a ladle there, all at full strength and no device asked: what a world whose hands may feel less of
/// it, or none, gives the fluid the opposite of. The same as force_on_ladle at full strengths that the device can render.
vec3 whole_drag(const FluidTouch& touch, vec3 place, vec3 velocity, double immersed,
                std::uint32_t model_age = 0);

/// N, device frame: the peak of a pulse of `length` ticks by which a hand gets the impulse (N s, bowl frame) that the ladle does
/// when it throws something in, at the mode's strength.
vec3 recoil_peak(const FluidTouch& touch, vec3 impulse, std::uint32_t length);

vec3 to_bowl(const BowlFrame& frame, vec3 device);

/// The nearest place in the bowl; the place itself where it is within, there is no wall or it is not finite.
vec3 held_in(const BowlWall& wall, vec3 place);

}  // namespace thaum::haptics
