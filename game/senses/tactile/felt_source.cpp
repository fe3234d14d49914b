#include "game/senses/tactile/felt_source.h"

#include "game/components/crystal.h"
#include "game/components/orb.h"
#include "game/components/station.h"

namespace thaum::game::inline senses {
namespace {

vec3 recoil_of(const haptics::ServoState& servo) {
    vec3 force{};
    for (const auto& pulse : servo.pulses) {
        if (pulse.at < pulse.length) force += pulse.peak * haptics::half_sine(pulse.at, pulse.length);
    }
    return force;
}

vec3 spring_of(const HandState& hand_state) {
    const auto& tether = hand_state.tether;
    if (!(tether.stiffness > 0)) return {};
    return tether.stiffness * (tether.anchor - hand_state.device.position);
}

vec3 wall_of(const haptics::SurfaceState& surface) {
    vec3 force{};
    for (std::uint32_t i = 0; i < surface.contacts; ++i) force += surface.touched.at(i).force;
    return force;
}

}  // namespace

HandForces forces_on(const HandState& hand_state) {
    const auto& servo = hand_state.servo;
    const auto& fluid = servo.fluid;
    return {recoil_of(servo),
            spring_of(hand_state),
            hand_state.steady_force.force,
            wall_of(servo.surface),
            fluid.force,
            fluid.wall,
            vec3(0, fluid.surface_force, 0),
            vec3(0),
            vec3(0)};
}

HandForces forces_on(const ecs::World& world, ecs::Entity wizard) {
    auto forces = forces_on(world.get<HandState>(wizard));
    const auto* station = world.find<AtStation>(wizard);
    if (station == nullptr) return forces;
    const quat to_hand = glm::inverse(look_rotation(station->yaw, 0));
    if (const auto* scrying = world.find<Scrying>(wizard))
        forces.at(static_cast<std::size_t>(ForceSource::flow)) = to_hand * scrying->force;
    if (const auto* chisel = world.find<Chisel>(wizard))
        forces.at(static_cast<std::size_t>(ForceSource::crystal)) = to_hand * chisel->force;
    return forces;
}

FeltSource strongest_source(const HandForces& forces, std::string_view steady_name) {
    const std::array<std::string_view, force_sources> names{
        "Recoil", "Spring", steady_name, "Wall", "Current", "Wall", "Surface", "Flow", "Crystal"};
    FeltSource strongest;
    for (std::size_t i = 0; i < force_sources; ++i) {
        const double newtons = glm::length(forces.at(i));
        if (newtons > strongest.newtons) strongest = {names.at(i), newtons};
    }
    return strongest;
}

}  // namespace thaum::game::inline senses
