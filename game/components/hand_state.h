// game/components/hand_state.h: the force feedback device in a wizard's hand, simulated together with the
// hand that holds it. Mouse, gamepad and bots move the target of that hand. Forces move the simulated device
// as they would move a real one.
#pragma once
#include "ecs/component.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace thaum::haptics {

THAUM_FIELDS_OF(SimulatedState, position, velocity, target, force, commanded)

THAUM_FIELDS_OF(SafetyState, output, offset, active_offset, unrequested, tip, initial_offset, fade_work,
                fade_budget, cap, heat, tick, bin, gate_open, fade, fast_ticks, latched, excess_ticks,
                excess_count, cause, ramp_ticks, episodes, remnant, heat_limit)

THAUM_FIELDS_OF(Pulse, peak, length, number)

THAUM_FIELDS_OF(PlayingPulse, peak, length, at)

THAUM_FIELDS_OF(SteadyForce, force, number)

THAUM_FIELDS_OF(Detents, axis, places, depth, width)

THAUM_FIELDS_OF(Tether, anchor, anchor_velocity, stiffness, damping, detents, number)

THAUM_FIELDS_OF(CommandedForce, passive, active, world, share)

THAUM_FIELDS_OF(ActiveBin, sum, most)

THAUM_FIELDS_OF(PassivityObserver, position, forces, created, most_created, active_work, active, reserve,
                work_reserve, active_bin, active_tick, newest, has_position, held_back, unsettled, brake,
                spring_force)

THAUM_FIELDS_OF(SurfaceContact, key, part, force)

THAUM_FIELDS_OF(SurfaceState, proxy, touched, contacts, sliding, begun, limited)

THAUM_FIELDS_OF(FluidTouchState, force, place, wall, mass_position, mass_velocity, surface_force,
                surface_height, flow_work, immersed, number, inside, begun)

THAUM_FIELDS_OF(Settling, tip, rest, step, balance, pace, bound, straight, force, lag, pull)

THAUM_FIELDS_OF(SeenBodies, stiffness, keys, count)

THAUM_FIELDS_OF(ServoState, safety, positions, pulses, proxy, next_position, samples, last_pulse, next_pulse,
                primitives, set_number, steady_force_number, tether_number, energy, surface, contact_offset,
                patch_number, fluid, viscosity, settling, seen)

}  // namespace thaum::haptics

namespace thaum::game::inline components {

struct HandState {
    haptics::SimulatedState device{};
    haptics::ServoState servo{};
    haptics::Pulse kick{};                ///< newest kick, such as a recoil
    haptics::SteadyForce steady_force{};  ///< steady force set by the wand in hand
    /// Spring to a point, set by the wand in hand.
    haptics::Tether tether{};
    vec3 home{};  ///< position to which the player's input moves the hand, without what a wand adds (m,
                  ///< device frame)
    /// Displacement from `home` that the wand in hand adds, for example a drawn sling (m, device frame).
    vec3 pull{};
    vec3 frame_origin{};           ///< origin of the device frame in the last tick (m, world)
    quat frame_turn{1, 0, 0, 0};   ///< orientation of the device frame in the last tick (device to world)
    std::uint64_t probe_number{};  ///< number that changes whenever the wand's tip has appeared or jumped
    /// 1: surfaces around the wand's tip were among the servo's inputs for the force in the last tick
    std::uint64_t probing{};
    std::uint32_t panic_held{};  ///< 1 while the player holds the panic key, which switches forces off
    /// 1: in this tick the player pressed the panic key to switch forces on again
    std::uint32_t rearm{};
    THAUM_COMPONENT(HandState, device, servo, kick, steady_force, tether, home, pull, frame_origin,
                    frame_turn, probe_number, probing, panic_held, rearm);
};

}  // namespace thaum::game::inline components
