#include "game/match/touch.h"

#include "core/hash.h"
#include "game/cauldron/ladle.h"
#include "game/match/arm.h"
#include "game/match/bare_probe.h"

namespace thaum::game {
namespace {

using input::Button;

/// Forces in the wands' files are for a device with this peak, N.
constexpr double reference_peak = 3.3;
constexpr double metres_per_micrometre = 1e-6;

/// The first press is for everybody's panic, and gives true; the next takes one's own back.
bool note_panic_key(const Controls& controls, Grip& grip) {
    const bool held = (controls.held & bit(Button::panic)) != 0;
    const bool pressed = held && grip.panic_held == 0;
    grip.panic_held = held ? 1 : 0;
    const bool latched = grip.servo.safety.latched != 0;
    grip.rearm = pressed && latched ? 1 : 0;
    return pressed && !latched;
}

/// Whether anybody pressed the panic key just now.
bool note_panic_keys(ecs::World& world) {
    bool panic = false;
    world.view<const Controls, Grip>().each(
        [&](const Controls& controls, Grip& grip) { panic |= note_panic_key(controls, grip); });
    return panic;
}

/// Returns the force, N.
double feel(Stage& stage, ecs::Entity wizard, const Controls& controls, bool panic, Grip& grip) {
    const vec3 moved =
        vec3(controls.hand_right, controls.hand_up, controls.hand_back) * metres_per_micrometre;
    const auto& device = stage.touch.device;
    const auto player = std::as_const(stage.world).get<Wizard>(wizard).player;
    const auto& model = next_model(stage, wizard, grip, panic);
    const vec3 measured = haptics::measured_position(device, grip.device);
    const vec3 force = haptics::servo_step(stage.touch.servos[player], grip.servo, model, {measured, 0});
    // Who lets go of the ladle in the brew: its clutch is held.
    const bool relaxed =
        (controls.held & bit(Button::clutch)) != 0 && std::as_const(stage.world).has<Ladle>(wizard);
    grip.home = relaxed ? grip.device.position : glm::clamp(grip.home + moved, -device.reach, device.reach);
    grip.device = haptics::step(device, grip.device, grip.home + grip.pull, force);
    return glm::length(force);
}

/// What a newton of the wands' files is for this player's device and wish.
double felt_share(const Stage& stage, ecs::Entity wizard) {
    const auto player = stage.world.get<Wizard>(wizard).player;
    return stage.touch.servos[player].limits.cap / reference_peak;
}

}  // namespace

const haptics::HapticModel& next_model(Stage& stage, ecs::Entity wizard, Grip& grip, bool panic) {
    const auto player = std::as_const(stage.world).get<Wizard>(wizard).player;
    auto& model = stage.models[player];
    model.pulse = grip.kick;
    model.lean = grip.lean;
    model.tether = grip.tether;
    model.on = stage.touch.on[player];
    model.panic = panic;
    model.rearm = grip.rearm != 0;
    feel_about(stage, wizard, grip, model);
    if (auto* ladle = stage.world.find<Ladle>(wizard)) {
        feel_brew(stage, grip, player, *ladle, std::as_const(stage.world).single<Match>().played,
                  model.fluid);
    } else {
        model.fluid.number = 0;
    }
    return model;
}

Grip empty_grip() {
    Grip grip;
    grip.device = haptics::resting_at({});
    return grip;
}

void add_touch_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "touch",
                  .reads = world.mask<Wizard, Controls, Gaze, Motion, Dead, Match, Cauldron, BrewPage>(),
                  .writes = world.mask<Grip, Arm, Ladle>(),
                  .needs = world.mask<Grip>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      const bool panic = note_panic_keys(w);
                      tell_arms(w, panic);
                      w.view<const Wizard, const Controls, Grip>().each(
                          [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, Grip& grip) {
                              auto& trace = stage.felt[wizard.player];
                              const bool real = plays_by_arm(w, wizard.player);
                              trace[tick % trace.size()] =
                                  static_cast<float>(real ? glm::length(grip.servo.safety.output)
                                                          : feel(stage, e, controls, panic, grip));
                          });
                  }});
}

void kick(Stage& stage, ecs::Entity wizard, double newtons, Tick length) {
    kick(stage, wizard, vec3(0, 0, newtons), length);
}

void kick(Stage& stage, ecs::Entity wizard, vec3 newtons, Tick length) {
    auto& grip = stage.world.get<Grip>(wizard);
    grip.kick = {.peak = newtons * felt_share(stage, wizard),
                 .length = static_cast<std::uint32_t>(length),
                 .number = grip.kick.number + 1};
}

void lean(Stage& stage, ecs::Entity wizard, vec3 newtons) {
    stage.world.get<Grip>(wizard).lean.force = newtons * felt_share(stage, wizard);
}

void tether(Stage& stage, ecs::Entity wizard, const haptics::Tether& to) {
    auto& held = stage.world.get<Grip>(wizard).tether;
    const bool jumps = (held.stiffness > 0) != (to.stiffness > 0);
    const auto number = held.number + (jumps ? 1 : 0);
    held = to;
    held.number = number;
}

void let_go(Stage& stage, ecs::Entity wizard) {
    auto& grip = stage.world.get<Grip>(wizard);
    if (grip.lean.force != vec3(0)) grip.lean = {.force = {}, .number = grip.lean.number + 1};
    tether(stage, wizard, {});
    grip.pull = {};
}

vec3 wand_tip_of(double wand_per_hand, const Grip& grip) {
    const auto& servo = grip.servo;
    const bool touches = servo.surface.contacts != 0;
    return wand_tip + wand_per_hand * (touches ? servo.surface.proxy : grip.device.position + servo.shift);
}

std::uint64_t chained_force_hash(const ecs::World& world, std::uint64_t before) {
    world.view<const Grip>().each([&](const Grip& grip) {
        before = hash_bytes(std::as_bytes(std::span(&grip.servo.safety.output, 1)), before);
    });
    return before;
}

}  // namespace thaum::game
