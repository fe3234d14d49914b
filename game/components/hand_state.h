// game/components/hand_state.h: the force feedback device in a wizard's hand, simulated together with the
// hand that holds it. Mouse, gamepad and bots move the target of that hand. Forces move the simulated device
// as they would move a real one.
#pragma once
#include "ecs/component.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace thaum::haptics {

constexpr auto fields_of(const SimulatedState*) {
    using S = SimulatedState;
    return std::tuple(ecs::field("position", &S::position), ecs::field("velocity", &S::velocity),
                      ecs::field("target", &S::target), ecs::field("force", &S::force),
                      ecs::field("commanded", &S::commanded));
}

constexpr auto fields_of(const SafetyState*) {
    using S = SafetyState;
    return std::tuple(ecs::field("output", &S::output), ecs::field("offset", &S::offset),
                      ecs::field("unrequested", &S::unrequested), ecs::field("tip", &S::tip),
                      ecs::field("initial_offset", &S::initial_offset),
                      ecs::field("fade_work", &S::fade_work), ecs::field("heat", &S::heat),
                      ecs::field("tick", &S::tick), ecs::field("bin", &S::bin),
                      ecs::field("gate_open", &S::gate_open), ecs::field("fade", &S::fade),
                      ecs::field("fast_ticks", &S::fast_ticks), ecs::field("latched", &S::latched),
                      ecs::field("excess_ticks", &S::excess_ticks),
                      ecs::field("excess_count", &S::excess_count), ecs::field("cause", &S::cause),
                      ecs::field("stale_ticks", &S::stale_ticks), ecs::field("episodes", &S::episodes));
}

constexpr auto fields_of(const Pulse*) {
    return std::tuple(ecs::field("peak", &Pulse::peak), ecs::field("length", &Pulse::length),
                      ecs::field("number", &Pulse::number));
}

constexpr auto fields_of(const PlayingPulse*) {
    return std::tuple(ecs::field("peak", &PlayingPulse::peak), ecs::field("length", &PlayingPulse::length),
                      ecs::field("at", &PlayingPulse::at));
}

constexpr auto fields_of(const SteadyForce*) {
    return std::tuple(ecs::field("force", &SteadyForce::force), ecs::field("number", &SteadyForce::number));
}

constexpr auto fields_of(const Detents*) {
    return std::tuple(ecs::field("axis", &Detents::axis), ecs::field("places", &Detents::places),
                      ecs::field("depth", &Detents::depth), ecs::field("width", &Detents::width));
}

constexpr auto fields_of(const Tether*) {
    using T = Tether;
    return std::tuple(ecs::field("anchor", &T::anchor), ecs::field("anchor_velocity", &T::anchor_velocity),
                      ecs::field("stiffness", &T::stiffness), ecs::field("damping", &T::damping),
                      ecs::field("detents", &T::detents), ecs::field("number", &T::number));
}

constexpr auto fields_of(const CommandedForce*) {
    using B = CommandedForce;
    return std::tuple(ecs::field("passive", &B::passive), ecs::field("active", &B::active),
                      ecs::field("world", &B::world), ecs::field("share", &B::share));
}

constexpr auto fields_of(const PassivityObserver*) {
    using B = PassivityObserver;
    return std::tuple(ecs::field("position", &B::position), ecs::field("forces", &B::forces),
                      ecs::field("created", &B::created), ecs::field("most_created", &B::most_created),
                      ecs::field("active_work", &B::active_work), ecs::field("newest", &B::newest),
                      ecs::field("has_position", &B::has_position));
}

constexpr auto fields_of(const SurfaceContact*) {
    return std::tuple(ecs::field("key", &SurfaceContact::key), ecs::field("part", &SurfaceContact::part),
                      ecs::field("force", &SurfaceContact::force));
}

constexpr auto fields_of(const SurfaceState*) {
    using S = SurfaceState;
    return std::tuple(ecs::field("proxy", &S::proxy), ecs::field("touched", &S::touched),
                      ecs::field("contacts", &S::contacts), ecs::field("sliding", &S::sliding),
                      ecs::field("begun", &S::begun), ecs::field("limited", &S::limited));
}

constexpr auto fields_of(const FluidTouchState*) {
    using S = FluidTouchState;
    return std::tuple(
        ecs::field("force", &S::force), ecs::field("place", &S::place), ecs::field("wall", &S::wall),
        ecs::field("mass_position", &S::mass_position), ecs::field("mass_velocity", &S::mass_velocity),
        ecs::field("surface_force", &S::surface_force), ecs::field("surface_height", &S::surface_height),
        ecs::field("flow_work", &S::flow_work), ecs::field("immersed", &S::immersed),
        ecs::field("number", &S::number), ecs::field("inside", &S::inside), ecs::field("begun", &S::begun));
}

constexpr auto fields_of(const ServoState*) {
    using S = ServoState;
    return std::tuple(ecs::field("safety", &S::safety), ecs::field("positions", &S::positions),
                      ecs::field("pulses", &S::pulses), ecs::field("proxy", &S::proxy),
                      ecs::field("next_position", &S::next_position), ecs::field("samples", &S::samples),
                      ecs::field("last_pulse", &S::last_pulse), ecs::field("next_pulse", &S::next_pulse),
                      ecs::field("primitives", &S::primitives), ecs::field("set_number", &S::set_number),
                      ecs::field("steady_force_number", &S::steady_force_number),
                      ecs::field("tether_number", &S::tether_number), ecs::field("energy", &S::energy),
                      ecs::field("surface", &S::surface), ecs::field("contact_offset", &S::contact_offset),
                      ecs::field("patch_number", &S::patch_number), ecs::field("fluid", &S::fluid),
                      ecs::field("viscosity", &S::viscosity));
}

}  // namespace thaum::haptics

namespace thaum::game {

using ecs::field;

struct HandState {
    haptics::SimulatedState device{};
    haptics::ServoState servo{};
    haptics::Pulse kick{};                ///< newest kick
    haptics::SteadyForce steady_force{};  ///< steady force set by the wand in hand
    /// Spring to a point, set by the wand in hand.
    haptics::Tether tether{};
    vec3 home{};  ///< hand position chosen by the player (m, device frame)
    /// Displacement from `home` that the wand in hand adds, for example a drawn sling (m, device frame).
    vec3 pull{};
    vec3 frame_origin{};           ///< origin of the device frame in the last tick (m, world)
    quat frame_turn{1, 0, 0, 0};   ///< orientation of the device frame in the last tick (device to world)
    std::uint64_t probe_number{};  ///< number of times that the wand's tip appeared or jumped
    /// 1: surfaces around the wand's tip were given to the servo in the last tick
    std::uint64_t probing{};
    std::uint32_t panic_held{};  ///< 1 while the player holds the panic key
    /// 1: in this tick the player pressed the panic key to switch forces on again
    std::uint32_t rearm{};
    static constexpr std::string_view name = "HandState";
    static constexpr auto fields() {
        return std::tuple(field("device", &HandState::device), field("servo", &HandState::servo),
                          field("kick", &HandState::kick), field("steady_force", &HandState::steady_force),
                          field("tether", &HandState::tether), field("home", &HandState::home),
                          field("pull", &HandState::pull), field("frame_origin", &HandState::frame_origin),
                          field("frame_turn", &HandState::frame_turn),
                          field("probe_number", &HandState::probe_number),
                          field("probing", &HandState::probing), field("panic_held", &HandState::panic_held),
                          field("rearm", &HandState::rearm));
    }
};

}  // namespace thaum::game
