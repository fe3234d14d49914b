#include "haptics/fluid_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "haptics/coupling.h"
#include "haptics/energy.h"
#include "haptics/safety.h"

namespace thaum::haptics {
namespace {

/// Factors from quantities of the bowl's frame to those at the hand (HAPTICS.md, "Units, frames and state").
struct HandScale {
    /// Factor from stiffness, damping and mass in the bowl to those at the hand: the scale of forces times
    /// that of lengths, s_f s_x (BowlFrame).
    double stiffness{};
    double energy{};  ///< factor from energy in the bowl to that at the hand: s_f / s_x (BowlFrame)
};

HandScale hand_scale(const BowlFrame& frame) {
    return {frame.newtons_per_newton * frame.metres_per_metre,
            frame.newtons_per_newton / frame.metres_per_metre};
}

vec3 force_to_hand(const BowlFrame& frame, vec3 bowl) {
    return frame.newtons_per_newton * (glm::transpose(frame.turn) * bowl);
}

/// Part of the damping that the device can render which no force has used yet in this tick (N s/m, at the
/// hand).
struct DampingBudget {
    double left{};

    double take(double wanted, double most) {
        const double taken = std::max(0.0, std::min(wanted, most));
        left -= taken;
        return taken;
    }
};

bool asks_for_flow(const FluidModes& modes) {
    return modes.viscosity > 0 || modes.flow > 0 || modes.resistance > 0;
}

vec3 finite_or_zero_force(vec3 v) { return is_finite(v) ? v : vec3(0); }

/// Adds the force and the stored energy of one part (surface, wall or ladle), unless they are not finite.
void add(FluidForces& feel, vec3 passive, double stored) {
    if (!is_finite(passive) || !std::isfinite(stored)) return;
    feel.passive += passive;
    feel.stored += stored;
}

// ---- the ladle's own mass ---------------------------------------------------------------------------------

bool has_mass(const FluidTouch& fluid) {
    const auto& [mass, stiffness, damping] = fluid.ladle;
    return fluid.modes.inertia > 0 && mass > 0 && stiffness > 0 && damping >= 0;
}

/// Computes the motion of the ladle's mass over the coming tick, tied to a tip that keeps its velocity, and
/// the mean force during it. A force from the present positions alone would be a tick late.
void feel_mass(const FluidTouch& fluid, FluidTouchState& state, const FluidTip& tip, DampingBudget& damping,
               FluidForces& feel) {
    if (!has_mass(fluid)) return;
    const double scale = fluid.modes.inertia * hand_scale(fluid.frame).stiffness;
    const double mass = scale * fluid.ladle.mass, stiffness = scale * fluid.ladle.stiffness;
    const double taken = damping.take(scale * fluid.ladle.damping, damping.left / 2);
    const bool follows = state.begun != 0 && glm::length(state.mass_position - tip.position) <= longest_step;
    if (!follows || !is_finite(state.mass_velocity)) {
        state.mass_position = tip.position;
        state.mass_velocity = tip.velocity;
    }
    if (!(std::isfinite(stiffness) && std::isfinite(taken) && mass > 0 && std::isfinite(1 / mass))) return;
    const vec3 off = tip.position - state.mass_position;
    const double stored =
        (mass * glm::dot(state.mass_velocity, state.mass_velocity) + stiffness * glm::dot(off, off)) / 2;
    const auto step = coupling_step({stiffness, taken, 0}, 1 / mass, 0, tick_seconds);
    const auto pulled = couple(step, {.hand = tip.position,
                                      .hand_velocity = tip.velocity,
                                      .object = state.mass_position,
                                      .object_velocity = state.mass_velocity});
    state.mass_position += pulled.displacement;
    state.mass_velocity += pulled.velocity_change;
    add(feel, -pulled.mean_force, stored);
}

// ---- surface ----------------------------------------------------------------------------------------------

/// Upward force (N, bowl frame) and energy (J) of the surface's spring, stretched by `gap` metres
/// (fluid/spring_surface.h).
struct SurfacePull {
    double force{}, stored{};
};

SurfacePull pull_of(const BrewSurface& surface, double gap) {
    const double most = surface.inside != 0 ? surface.cling : surface.pop_through;
    const double stretch = surface.inside != 0 ? std::max(0.0, -gap) : std::max(0.0, gap);
    const double force = std::min(surface.stiffness * stretch, most);
    if (!(force > 0)) return {};
    // Beyond the largest force, energy grows in proportion to the stretch.
    const double stored = force * stretch - force * force / (2 * surface.stiffness);
    return {surface.inside != 0 ? -force : force, stored};
}

/// Present height of a moving surface (m, bowl frame), extrapolated while the haptic model is fresh.
double height_now(const BrewSurface& surface, std::uint32_t age) {
    return surface.height + surface.velocity * (std::min(age, freshest_ticks) * tick_seconds);
}

/// Immersed share of the ladle, 0 to 1.
double immersed_part(const FluidTouch& fluid, double depth) {
    if (fluid.surface.present == 0) return 1;
    if (fluid.surface.inside == 0) return 0;
    return fluid.drag.height > 0 ? std::clamp(depth / fluid.drag.height, 0.0, 1.0) : 1;
}

void feel_surface(const FluidTouch& fluid, FluidTouchState& state, double height, double place_height,
                  FluidForces& feel) {
    const double step = (height - state.surface_height) / fluid.frame.metres_per_metre;
    if (state.begun != 0 && std::abs(step) <= longest_step) feel.supplied += state.surface_force * step;
    state.surface_height = height;
    state.surface_force = 0;
    state.inside = fluid.surface.inside;
    if (fluid.surface.present == 0 || !(fluid.modes.surface > 0)) return;
    const SurfacePull pull = pull_of(fluid.surface, height - place_height);
    const double force = fluid.modes.surface * fluid.frame.newtons_per_newton * pull.force;
    if (!std::isfinite(force)) return;
    state.surface_force = force;
    const vec3 up = glm::transpose(fluid.frame.turn) * vec3(0, 1, 0);
    add(feel, force * up, fluid.modes.surface * hand_scale(fluid.frame).energy * pull.stored);
}

// ---- flow -------------------------------------------------------------------------------------------------

/// Coefficients of the three drags of a flow on the ladle: viscosity, flow and resistance, equations (1) to
/// (3) in fluid_touch.h (N s/m, bowl frame).
struct Drags {
    double viscosity{}, flow{}, resistance{};
};

/// Computes the drags. They are scaled down together, so that their ratio stays, if the device cannot render
/// their damping or if the loop from the hand through the fluid back to the hand would oscillate. `most` is
/// the damping that the device can render (N s/m, bowl frame).
Drags drags_of(const FluidModes& modes, const LadleDrag& drag, const FlowSample& sample, double immersed,
               double most) {
    const double stokes = immersed * drag.viscous * sample.viscosity;
    const Drags drags{.viscosity = std::max(0.0, modes.viscosity) * stokes,
                      .flow = std::max(0.0, modes.flow) * stokes,
                      .resistance = std::max(0.0, modes.resistance) * immersed * drag.form * sample.density};
    const double slope = drags.viscosity + drags.resistance;
    const double gain = (drags.flow + drags.resistance) * fluid_period * tick_seconds;
    double share = 1;
    if (slope > most) share = most / slope;
    if (drag.stirred_mass > 0 && share * gain > loop_gain * drag.stirred_mass)
        share = loop_gain * drag.stirred_mass / gain;
    return {share * drags.viscosity, share * drags.flow, share * drags.resistance};
}

/// Forces of the flow on the hand (N).
struct FlowForces {
    vec3 viscosity{}, flow{}, resistance{};
    double slope{};  ///< damping that the hand feels by the flow's forces (N s/m)
};

FlowForces forces_of(const FluidTouch& fluid, const FlowSample& sample, vec3 velocity, double immersed,
                     double max_damping) {
    const double scale = hand_scale(fluid.frame).stiffness;
    const double most = scale > 0 ? max_damping / scale : std::numeric_limits<double>::infinity();
    const Drags drags = drags_of(fluid.modes, fluid.drag, sample, immersed, most);
    const auto felt_of = [&](double drag, vec3 way) { return force_to_hand(fluid.frame, drag * way); };
    return {felt_of(drags.viscosity, -velocity), felt_of(drags.flow, sample.velocity),
            felt_of(drags.resistance, sample.velocity - velocity),
            scale * (drags.viscosity + drags.resistance)};
}

/// Forces between those in the older flow `a` and those in the newer one `b`. The forces are mixed, not the
/// flows, so that the force changes linearly in time even if the fluid's viscosity changes together with its
/// velocity.
FlowForces mixed(const FlowForces& a, const FlowForces& b, double share) {
    return {glm::mix(a.viscosity, b.viscosity, share), glm::mix(a.flow, b.flow, share),
            glm::mix(a.resistance, b.resistance, share), glm::mix(a.slope, b.slope, share)};
}

/// Share of the newest fluid step in the force, 0 to 1; the step before it has the rest. It grows from 1/16
/// in the first tick to 1 in the sixteenth, so that the force does not jump.
double share_of_newer(std::uint64_t step_age, std::uint32_t model_age) {
    const std::uint64_t age = std::min<std::uint64_t>(step_age, fluid_period) + model_age;
    return static_cast<double>(std::min<std::uint64_t>(age + 1, fluid_period)) / fluid_period;
}

void feel_flow(const FluidTouch& fluid, FluidTouchState& state, const FluidTip& tip, DampingBudget& damping,
               FluidForces& feel) {
    state.force = {};
    state.flow_work = 0;
    if (!asks_for_flow(fluid.modes) || !(state.immersed > 0)) return;
    const vec3 velocity = fluid.frame.turn * (fluid.frame.metres_per_metre * tip.velocity);
    const FlowSample newest = flow_at(fluid.newer, state.place);
    const auto of = [&](const FlowSample& sample) {
        return forces_of(fluid, sample, velocity, state.immersed, damping.left);
    };
    const FlowForces forces = mixed(of(flow_at(fluid.older, state.place)), of(newest),
                                    share_of_newer(fluid.step_age, tip.model_age));
    const vec3 force = forces.viscosity + forces.flow + forces.resistance;
    const vec3 step =
        glm::transpose(fluid.frame.turn) * newest.velocity * (tick_seconds / fluid.frame.metres_per_metre);
    if (!is_finite(force) || !is_finite(step)) return;
    damping.take(forces.slope, damping.left);
    state.force = force;
    // If the flow seems to move farther than `longest_step` in a tick, its velocity is taken for an error,
    // and its work does not count.
    if (glm::length(step) <= longest_step) state.flow_work = glm::dot(forces.resistance, step);
    feel.passive += forces.viscosity + forces.resistance;
    feel.active += forces.flow;
}

// ---- wall -------------------------------------------------------------------------------------------------

/// Adds the wall's force. `place` is the true place P of the tip, `state.place` the nearest place in the
/// bowl.
void feel_wall(const FluidTouch& fluid, FluidTouchState& state, vec3 place, vec3 velocity,
               DampingBudget& damping, FluidForces& feel) {
    state.wall = {};
    // Displacement from the tip's true place to the nearest place in the bowl (m).
    const vec3 off = state.place - place;
    const double depth = glm::length(off);
    if (!(fluid.modes.wall > 0) || !(depth > 0) || !std::isfinite(depth)) return;
    const double scale = hand_scale(fluid.frame).stiffness * fluid.modes.wall;
    const double damps = damping.take(scale * fluid.wall.damping, damping.left);
    const vec3 in = glm::transpose(fluid.frame.turn) * (off / depth);
    const double stretch = depth / fluid.frame.metres_per_metre;
    const double push = scale * fluid.wall.stiffness * stretch - damps * glm::dot(velocity, in);
    const vec3 force = std::max(0.0, push) * in;
    state.wall = finite_or_zero_force(force);
    add(feel, force, scale * fluid.wall.stiffness * stretch * stretch / 2);
}

/// Nearest point inside the bowl's profile, its outline in a half plane through the axis (r outwards, y up).
vec2 held_in_profile(const BowlWall& wall, vec2 place) {
    const std::size_t points = std::min<std::size_t>(wall.points, wall_points);
    vec2 nearest = place;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < points; ++i) {
        const vec2 from = wall.profile[i], way = wall.profile[i + 1] - from, off = place - from;
        const double length2 = glm::dot(way, way);
        const bool outside = -way.y * off.x + way.x * off.y > 0;
        if (!outside || !(length2 > 0)) continue;
        const double along = glm::dot(off, way) / length2;
        // The first piece of the profile, at the rim, continues upwards, at most to the axis.
        const double first = i != 0 ? 0 : way.x > 0 ? -from.x / way.x : -HUGE_VAL;
        const vec2 foot = from + std::min(std::max(along, first), 1.0) * way;
        const double distance2 = glm::dot(place - foot, place - foot);
        if (!(distance2 < least)) continue;
        least = distance2;
        nearest = {std::max(0.0, foot.x), foot.y};
    }
    return nearest;
}

}  // namespace

vec3 nearest_in_bowl(const BowlWall& wall, vec3 place) {
    if (wall.points < 2 || !is_finite(place)) return place;
    const vec3 off = place - wall.centre;
    const double r = std::sqrt(off.x * off.x + off.z * off.z);
    const vec2 held = held_in_profile(wall, {r, off.y});
    if (held == vec2(r, off.y)) return place;
    const double in = r > 0 ? held.x / r : 0;
    const vec3 result = wall.centre + vec3(in * off.x, held.y, in * off.z);
    return is_finite(result) ? result : place;
}

vec3 to_bowl(const BowlFrame& frame, vec3 device) {
    return frame.origin + frame.turn * (frame.metres_per_metre * device);
}

void add_fluid_step(FluidTouch& fluid, const FlowPatch& newest) {
    fluid.older = fluid.newer.spacing > 0 ? fluid.newer : newest;
    fluid.newer = newest;
    fluid.step_age = 0;
}

bool detect_fluid_switch(FluidTouchState& state, const FluidTouch& fluid) {
    if (fluid.number == state.number) return false;
    state = {.number = fluid.number};
    return true;
}

FluidForces feel_fluid(const FluidTouch& fluid, FluidTouchState& state, const FluidTip& tip) {
    const vec3 place = to_bowl(fluid.frame, tip.position);
    if (!is_finite(place) || !is_finite(tip.velocity)) {
        state = {.number = fluid.number};
        return {};
    }
    FluidForces feel{.supplied = state.begun != 0 ? state.flow_work : 0};
    DampingBudget damping{tip.max_damping};
    state.place = nearest_in_bowl(fluid.wall, place);
    const double height = height_now(fluid.surface, tip.model_age);
    state.immersed = immersed_part(fluid, height - state.place.y);
    feel_mass(fluid, state, tip, damping, feel);
    feel_surface(fluid, state, height, place.y, feel);
    feel_flow(fluid, state, tip, damping, feel);
    feel_wall(fluid, state, place, tip.velocity, damping, feel);
    state.begun = 1;
    return feel;
}

vec3 force_on_ladle(const FluidTouch& fluid, const FluidTouchState& state) {
    const double scale = fluid.frame.newtons_per_newton;
    return scale > 0 ? fluid.frame.turn * state.force / scale : vec3(0);
}

vec3 full_drag(const FluidTouch& fluid, vec3 place, vec3 velocity, double immersed, std::uint32_t model_age) {
    const auto of = [&](const FlowPatch& patch) {
        const FlowSample sample = flow_at(patch, place);
        const Drags drags =
            drags_of(FluidModes{}, fluid.drag, sample, immersed, std::numeric_limits<double>::infinity());
        return (drags.flow + drags.resistance) * (sample.velocity - velocity);
    };
    return finite_or_zero_force(
        glm::mix(of(fluid.older), of(fluid.newer), share_of_newer(fluid.step_age, model_age)));
}

vec3 recoil_peak(const FluidTouch& fluid, vec3 impulse, std::uint32_t length) {
    if (!(fluid.modes.recoil > 0) || length == 0) return vec3(0);
    // A half sine has the impulse 2 / pi times peak times duration.
    return fluid.modes.recoil * force_to_hand(fluid.frame, impulse) * (pi / 2 / (length * tick_seconds));
}

}  // namespace thaum::haptics
