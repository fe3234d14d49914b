#include "game/match/hand/hand_system.h"

#include "core/hash.h"
#include "game/components/casting.h"
#include "game/context/arms.h"
#include "game/context/stations.h"
#include "game/match/hand/arm_system.h"
#include "game/match/hand/bare_probe.h"
#include "game/stations/cauldron/ladle.h"
#include "game/stations/crystal/chisel.h"
#include "game/stations/orb/worn_modes.h"

namespace thaum::game::inline match {
namespace {

using input::Button;

constexpr double metres_per_micrometre = 1e-6;

/// Handles the panic key of one player. Returns true for a press that switches off the forces of all
/// players. The player's next press switches this player's own forces on again.
bool note_panic_key(const Controls& controls, HandState& hand_state) {
    const bool held = (controls.held & bit(Button::panic)) != 0;
    const bool pressed = held && hand_state.panic_held == 0;
    hand_state.panic_held = held ? 1 : 0;
    const bool latched = hand_state.servo.safety.latched != 0;
    hand_state.rearm = pressed && latched ? 1 : 0;
    return pressed && !latched;
}

/// Whether any player pressed the panic key in this tick.
bool note_panic_keys(ecs::World& world) {
    bool panic = false;
    world.view<const Controls, HandState>().each([&](const Controls& controls, HandState& hand_state) {
        panic |= note_panic_key(controls, hand_state);
    });
    return panic;
}

/// Computes the force on the hand (the servo step) and moves the simulated device. Returns the magnitude of
/// the force (N).
double feel(MatchContext& context, const BrewResource& brew, ecs::Entity wizard, const Controls& controls,
            bool panic, HandState& hand_state) {
    const vec3 moved =
        vec3(controls.hand_right, controls.hand_up, controls.hand_back) * metres_per_micrometre;
    const auto& setup = context.input.haptic_setup;
    const auto& device = setup.device;
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    const auto& model = next_model(context, brew, wizard, hand_state, panic);
    const vec3 measured = haptics::measured_position(device, hand_state.device);
    const vec3 force = haptics::servo_step(setup.servos[player], hand_state.servo, model, {measured, 0});
    // While the button Clutch is held at a station, the hand does not resist the device, so a ladle drifts
    // with the brew.
    const bool relaxed = (controls.held & bit(Button::clutch)) != 0 && at_station(context.world, wizard);
    const vec3 wanted = hand_state.home + moved;
    hand_state.home = relaxed ? hand_state.device.position : glm::clamp(wanted, -device.reach, device.reach);
    if (auto* trace = context.world.find<DrawnStroke>(wizard); trace != nullptr && !relaxed)
        trace->beyond += wanted - hand_state.home;
    hand_state.device = haptics::step(device, hand_state.device, hand_state.home + hand_state.pull, force);
    return glm::length(force);
}

/// Sets the haptic primitives (simple forces) of the model: those of the orb or crystal at which the hand
/// works, otherwise none.
void feel_station(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
                  haptics::HapticModel& model) {
    model.field_motion = 0;
    if (context.world.has<Scrying>(wizard)) return feel_orb(context, wizard, hand_state, model);
    if (context.world.has<Chisel>(wizard)) return feel_crystal(context, wizard, hand_state, model);
    if (model.set_number == 0) return;
    const haptics::HapticModel fresh;
    model.primitives = fresh.primitives;
    model.coupling = fresh.coupling;
    model.set_number = 0;
}

}  // namespace

const haptics::HapticModel& next_model(MatchContext& context, const BrewResource& brew, ecs::Entity wizard,
                                       HandState& hand_state, bool panic) {
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    auto& model = context.output.models.write()[player];
    model.pulse = hand_state.kick;
    model.steady_force = hand_state.steady_force;
    model.tether = hand_state.tether;
    model.on = context.input.haptic_setup.on[player];
    model.force_percent = context.input.haptic_setup.force_percent[player];
    model.panic = panic;
    model.rearm = hand_state.rearm != 0;
    const auto& world = std::as_const(context.world);
    const bool draws = world.has<DrawnStroke>(wizard) && !world.has<Ladle>(wizard);
    model.viscosity = draws ? context.data.casting->viscosity : 0;
    feel_station(context, wizard, hand_state, model);
    fill_probe_model(context, wizard, hand_state, model);
    if (auto* ladle = context.world.find<Ladle>(wizard)) {
        feel_brew(context, *brew.read().work, wizard, *ladle, world.single<Match>().played, model.fluid);
    } else if (model.fluid.number != 0) {
        model.fluid = {};
    }
    return model;
}

void add_hand_system(MatchContext& context, const BrewResource& brew, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add(
        {.name = "touch",
         .reads = world.mask<Wizard, Controls, Gaze, Motion, Dead, Match, AtStation, Cauldron, BrewSamples,
                             Scrying, WornModes, Orb, Chisel, Crystal, CrystalDensity, resource::Brew,
                             resource::Physics>(),
         .writes = world.mask<HandState, Arm, Ladle, DrawnStroke, resource::Models, resource::Forces>(),
         .needs = world.mask<HandState>(),
         .run = [&context, &brew](ecs::World& w, Tick tick) {
             const bool panic = note_panic_keys(w);
             tell_arms(w, panic);
             w.view<const Wizard, const Controls, HandState>().each(
                 [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, HandState& hand_state) {
                     auto& trace = context.output.forces.write()[wizard.player];
                     const bool real = plays_by_arm(w, wizard.player);
                     trace[tick % trace.size()] =
                         static_cast<float>(real ? glm::length(hand_state.servo.safety.output)
                                                 : feel(context, brew, e, controls, panic, hand_state));
                 });
         }});
}

std::uint64_t chained_force_hash(const ecs::World& world, std::uint64_t before) {
    world.view<const HandState>().each([&](const HandState& hand_state) {
        before = hash_bytes(std::as_bytes(std::span(&hand_state.servo.safety.output, 1)), before);
    });
    return before;
}

}  // namespace thaum::game::inline match
