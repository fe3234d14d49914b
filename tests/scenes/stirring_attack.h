// tests/scenes/stirring_attack.h: a hostile stirring hand, for benchmark and test. The flow changes its
// direction in each fluid step, the surface is simulated, the bowl is narrow, and models arrive late. The
// energy that the hand gains is computed independently of the servo's own energy observer.
#pragma once
#include <algorithm>
#include <cmath>
#include <deque>

#include "core/random.h"
#include "fluid/spring_surface.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace thaum::bench {

/// A flow with the same velocity, viscosity and density everywhere.
inline haptics::FlowPatch uniform_flow(vec3 velocity, double viscosity, double density) {
    haptics::FlowPatch patch{.origin = vec3(-1), .spacing = 0.5};
    patch.nodes.fill({fvec3(velocity), static_cast<float>(viscosity), static_cast<float>(density)});
    return patch;
}

/// A bowl of half an ellipsoid, whose outline has as many points as a BowlWall can hold. The rim is at the
/// height of the origin.
inline haptics::BowlWall round_bowl(double radius, double depth) {
    haptics::BowlWall wall{.points = haptics::wall_points};
    for (std::size_t i = 0; i < haptics::wall_points; ++i) {
        const double angle = pi / 2 * static_cast<double>(i) / (haptics::wall_points - 1);
        wall.profile[i] = {radius * det::cos(angle), -depth * det::sin(angle)};
    }
    return wall;
}

struct StirredWorld {
    /// Forces of the fluid that act on the hand. Only passive ones are chosen, and viscosity only if the flow
    /// is at rest.
    haptics::FluidModes modes{};
    double flow{};          ///< largest velocity along each axis, random in each step (m/s)
    bool waves{};           ///< true: pushes on the surface make waves
    std::uint32_t delay{};  ///< age of each model when the servo gets it (ticks)
};

struct StirredEnergy {
    /// Energy created: work on the hand minus energy given by the world and stored in springs (J).
    double created{};
    double most_created{};  ///< largest value of `created` (J)
    /// Energy that passed through the hand in both directions (J); if 0, the test proves nothing.
    double moved{};
};

class StirringAttack {
public:
    /// The device must never reach a limit, because then the hand would not get all energy that the fluid
    /// gives, and the balance of energy would be wrong.
    StirringAttack(const StirredWorld& world, const haptics::DeviceSpec& spec)
        : world_(world),
          stiffness_(std::min(spec.max_stiffness, 1000.0)),  // limited to the largest stiffness in matches
          device_(simulated_device(spec, haptics::Hand{})),
          servo_(servo_of(spec, 1)) {
        servo_.limits.max_speed = 1e9;
        servo_.limits.slew = 1e12;
        constexpr double felt = metres_per_metre * newtons_per_newton;
        auto& fluid = model_.fluid;
        fluid.number = 1;
        fluid.modes = world.modes;
        fluid.frame = {.turn = mat3(rotation(glm::normalize(vec3(1, 2, -0.5)), 0.9)),
                       .metres_per_metre = metres_per_metre,
                       .newtons_per_newton = newtons_per_newton};
        fluid.drag = {.viscous = 4 / felt, .form = 1.5 / felt, .stirred_mass = 10, .height = 0.2};
        fluid.wall = round_bowl(0.5, 0.4);
        fluid.wall.stiffness = stiffness_ / felt;
        fluid.wall.damping = spec.max_damping / 2 / felt;
        fluid.ladle = {.mass = ladle_mass / felt, .stiffness = stiffness_ / 2 / felt, .damping = 2 / felt};
        settings_.contact = stiffness_ / felt;
        surface_ = make_spring_surface(settings_);
    }

    StirredEnergy run(int ticks) {
        for (int tick = 0; tick < ticks; ++tick) advance(tick);
        return energy_;
    }

private:
    static constexpr double metres_per_metre = 20, newtons_per_newton = 0.00375;
    static constexpr double ladle_mass = 0.1;  // mass as felt by the hand (kg)

    vec3 any(double size) {
        return {random_.uniform(-size, size), random_.uniform(-size, size), random_.uniform(-size, size)};
    }

    void advance(int tick) {
        move_world(tick);
        past_.push_back(model_);
        if (past_.size() > world_.delay + 1) past_.pop_front();
        const auto age = static_cast<std::uint32_t>(past_.size() - 1);
        const auto& fluid = past_.front().fluid;
        const vec3 force = servo_step(servo_, state_, past_.front(), {measured_position(device_, tip_), age});
        count(fluid, fluid.surface.height + fluid.surface.velocity * age * tick_seconds);
        if (tick % 40 == 0) goal_ = any(0.05);
        const vec3 from = tip_.position;
        tip_ = haptics::step(device_, tip_, goal_, force);
        const double out = glm::dot(tip_.force, tip_.position - from);
        energy_.moved += std::abs(out);
        // The newest flow carries the ladle along. The ladle gets energy from it through resistance, the only
        // force of a flow here.
        const vec3 flow = flow_at(fluid.newer, state_.fluid.place).velocity;
        last_ =
            out - glm::dot(fluid.frame.turn * state_.fluid.force, flow) * (tick_seconds / metres_per_metre);
    }

    /// Accounts for the energy of the last tick, after the surface has moved its end of the spring.
    void count(const haptics::FluidTouch& fluid, double height) {
        energy_.created += last_ - surface_force_ * (height - height_) / metres_per_metre;
        energy_.created = std::max(energy_.created, -held(fluid, height));
        energy_.most_created = std::max(energy_.most_created, energy_.created);
        surface_force_ = state_.fluid.surface_force;
        height_ = height;
    }

    /// Energy stored in the ladle and in the springs to wall and surface (J). Only this much may return;
    /// energy lost to damping may not.
    double held(const haptics::FluidTouch& fluid, double height) const {
        const auto& state = state_.fluid;
        const vec3 place = to_bowl(fluid.frame, tip_.position);
        const double in = glm::length(nearest_in_bowl(fluid.wall, place) - place) / metres_per_metre;
        const vec3 off = state.mass_position - tip_.position, speed = state.mass_velocity;
        const double ladle = ladle_mass * glm::dot(speed, speed) + stiffness_ / 2 * glm::dot(off, off);
        return (fluid.modes.wall * stiffness_ * in * in + fluid.modes.inertia * ladle) / 2 +
               std::abs(state.surface_force * (height - place.y)) / metres_per_metre;
    }

    void move_world(int tick) {
        auto& fluid = model_.fluid;
        if (tick % static_cast<int>(haptics::fluid_period) == 0)
            add_fluid_step(fluid, uniform_flow(any(world_.flow), random_.uniform(), random_.uniform()));
        else
            ++fluid.step_age;
        if (!world_.waves) return;
        const vec3 place = to_bowl(fluid.frame, tip_.position);
        const std::array probe{
            fluid::SurfaceProbe{.place = {place.x, place.z}, .height = place.y, .radius = 0.1}};
        const auto reaction = fluid::advance(surface_, scratch_, probe, tick_seconds).probes[0];
        fluid.surface = {.height = reaction.height,
                         .velocity = (reaction.height - fluid.surface.height) / tick_seconds,
                         .stiffness = settings_.contact,
                         .pop_through = settings_.pop_through,
                         .cling = settings_.cling,
                         .inside = reaction.inside ? 1U : 0U,
                         .present = 1};
    }

    StirredWorld world_;
    double stiffness_;
    haptics::SimulatedDevice device_;
    haptics::Servo servo_;
    haptics::ServoState state_{};
    haptics::HapticModel model_{};
    std::deque<haptics::HapticModel> past_{};
    haptics::SimulatedState tip_ = haptics::resting_at({});
    vec3 goal_{};
    Random random_{12};
    fluid::SpringSurfaceSettings settings_{};
    fluid::SpringSurface surface_{};
    fluid::SpringSurfaceScratch scratch_{};
    StirredEnergy energy_{};
    double last_{}, surface_force_{}, height_{};
};

/// Cases for the attack: each passive mode (kind of force) of the fluid alone, and all modes that can be
/// combined.
struct StirredCase {
    const char* name{};
    StirredWorld world{};
};

inline std::array<StirredCase, 6> stirred_cases() {
    constexpr haptics::FluidModes none{0, 0, 0, 0, 0, 0, 0};
    const auto with = [none](double haptics::FluidModes::*mode) {
        auto modes = none;
        modes.*mode = 1;
        return modes;
    };
    using Modes = haptics::FluidModes;
    return {{{"viscosity", {.modes = with(&Modes::viscosity)}},
             {"resistance", {.modes = with(&Modes::resistance), .flow = 2}},
             {"surface", {.modes = with(&Modes::surface), .waves = true}},
             {"wall", {.modes = with(&Modes::wall)}},
             {"inertia", {.modes = with(&Modes::inertia)}},
             {"all", {.modes = {0, 0, 1, 1, 1, 1, 0}, .flow = 2, .waves = true}}}};
}

}  // namespace thaum::bench
