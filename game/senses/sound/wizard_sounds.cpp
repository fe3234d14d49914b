#include <algorithm>
#include <cmath>

#include "game/components/crystal.h"
#include "game/data/wand_slots.h"
#include "game/senses/sound/scene_parts.h"

namespace thaum::game::inline senses {
namespace {

constexpr double jump_speed = 2;  ///< upward speed above which leaving the ground counts as a jump (m/s)
/// Speeds from which on a landing is audible, and has full loudness (m/s).
constexpr double land_speed = 2, hard_landing = 9;
constexpr double slow_heart_hz = 1.2, fast_heart_hz = 2.4;
constexpr double loud_hold_n = 1200;  ///< holding force of a wand at which its sound has full loudness (N)

/// Present state of one living wizard.
struct WizardNow {
    ecs::Entity entity;
    std::uint32_t player{};
    const Motion& motion;
    const WandBelt& belt;
    const LoadedWand* wand{};
    std::size_t wand_number{};  ///< index in MatchData::wands of the wand in hand
};

vec3 feet_of(const SoundWriting& writing, const WizardNow& wizard) {
    return wizard.motion.position - vec3(0, writing.match.data().wizard.height / 2, 0);
}

/// Material of the ground under the wizard.
Material ground_of(const SoundWriting& writing, const WizardNow& wizard) {
    constexpr double below = 0.3;
    const vec3 feet = feet_of(writing, wizard);
    const auto hit = writing.match.physics().ray(feet + vec3(0, below, 0), feet - vec3(0, below, 0),
                                                 layer::ground | layer::prop, wizard.entity.index);
    const auto thing = hit ? writing.match.world().entity(hit->key) : ecs::Entity{};
    const auto* look = thing ? writing.match.world().find<Look>(thing) : nullptr;
    return look != nullptr ? material_of(look->surface) : Material::stone;
}

void add_steps(SoundWriting& writing, const WizardNow& wizard, WizardSoundMemory& memory) {
    const auto& stance = writing.match.world().get<Stance>(wizard.entity);
    const bool grounded = stance.grounded != 0;
    const vec3 feet = feet_of(writing, wizard);
    const vec3 speed = wizard.motion.velocity;
    if (memory.grounded && !grounded && speed.y > jump_speed) begin(writing, Cue::jump, {.place = feet});
    if (!memory.grounded && grounded && memory.falling > land_speed)
        begin(writing, Cue::land, {.place = feet, .gain = std::min(1.0, memory.falling / hard_landing)});
    if (memory.stride.walks(stance, wizard.motion, seconds(audio::frame_ticks))) {
        const double share = std::hypot(speed.x, speed.z) / writing.match.data().wizard.walk.walk_speed;
        begin(writing, step_on(ground_of(writing, wizard)),
              {.place = feet, .gain = std::clamp(share, 0.2, 1.0)});
    }
    memory.grounded = grounded;
    memory.falling = std::max(0.0, -speed.y);
}

vec3 tip_of(const SoundWriting& writing, const WizardNow& wizard) {
    const auto& gaze = writing.match.world().get<Gaze>(wizard.entity);
    return eye_of(writing.match.data().wizard, wizard.motion.position) +
           look_rotation(gaze.yaw, gaze.pitch) * wand_tip;
}

void add_held(SoundWriting& writing, const WizardNow& wizard, const WandSoundNumbers& sounds,
              WizardSoundMemory& memory) {
    const auto& world = writing.match.world();
    const auto held = wizard.wand->rules->held_at(world, wizard.entity);
    if (held && !memory.holds) begin(writing, sounds.take, {.place = *held});
    memory.holds = held.has_value();
    if (!held) return;
    const double gravity = writing.match.data().wizard.gravity;
    const double force = wizard.wand->rules->holding_force(world, wizard.entity, gravity);
    const double load = std::min(1.0, force / loud_hold_n);
    last(writing, sounds.hold, lasting::hold + wizard.player,
         {.place = *held, .gain = 0.25 + 0.75 * load, .pitch = 1.3 - 0.6 * load});
}

void add_wand(SoundWriting& writing, const WizardNow& wizard, WizardSoundMemory& memory) {
    if (memory.selected != wizard.belt.selected)
        begin(writing, Cue::wand_change, {.heard_by = writing.ears_of(wizard.player), .at_ear = true});
    memory.selected = wizard.belt.selected;
    const bool fired = memory.fired != wizard.belt.fired;
    memory.fired = wizard.belt.fired;
    if (wizard.wand == nullptr) {
        memory.holds = false;
        return;
    }
    const auto& sounds = writing.sounds.wands[wizard.wand_number];
    if (fired) begin(writing, sounds.fire, {.place = tip_of(writing, wizard)});
    const auto ready = wizard.wand->rules->readiness(writing.match.world(), wizard.entity);
    if (ready && *ready > 0)
        last(writing, sounds.ready, lasting::ready + wizard.player,
             {.place = tip_of(writing, wizard), .gain = 0.3 + 0.7 * *ready, .pitch = 0.7 + 0.8 * *ready});
    add_held(writing, wizard, sounds, memory);
}

void add_heart(SoundWriting& writing, const WizardNow& wizard, WizardSoundMemory& memory) {
    const auto& health = writing.match.world().get<Health>(wizard.entity);
    const double share = health.points / writing.match.data().wizard.health;
    if (!(share < loud_heart_health) || !(share > 0) || writing.played() < memory.heart_at) return;
    begin(writing, Cue::heartbeat, {.heard_by = writing.ears_of(wizard.player), .at_ear = true});
    const double hz = fast_heart_hz + (slow_heart_hz - fast_heart_hz) * share / loud_heart_health;
    memory.heart_at = writing.played() + ticks(1 / hz);
}

void add_ladle(SoundWriting& writing, const WizardNow& wizard, WizardSoundMemory& memory) {
    // speeds of the ladle for full loudness, and for a splash (m/s)
    constexpr double fast_stir = 1.5, splash_speed = 0.3;
    const auto* ladle = writing.match.world().find<Ladle>(wizard.entity);
    const auto& cauldron = writing.match.world().single<Cauldron>();
    const bool inside = ladle != nullptr && cauldron.inside.at(wizard.player) != 0;
    const double speed = ladle != nullptr ? glm::length(ladle->velocity) : 0;
    if (inside != memory.ladle_inside && speed > splash_speed)
        begin(writing, Cue::splash, {.place = ladle->place, .gain = std::min(1.0, speed / fast_stir)});
    memory.ladle_inside = inside;
    if (!inside) return;
    const double thick = std::clamp(std::log2(std::max(cauldron.viscosity, 1e-3)), -3.0, 6.0);
    last(writing, writing.sounds.cues.at(static_cast<std::size_t>(Cue::stir)), lasting::stir + wizard.player,
         {.place = ladle->place, .gain = std::min(1.0, speed / fast_stir), .pitch = 1 - 0.08 * thick});
}

/// The scrape of a tool in a crystal: louder the harder it is pressed and the faster it moves.
void add_chisel(SoundWriting& writing, const WizardNow& wizard, WizardSoundMemory& memory) {
    constexpr double fast = 0.4, hard_n = 1.5;  // speed (m/s) and force (N) of the tool for full loudness
    const auto* chisel = writing.match.world().find<Chisel>(wizard.entity);
    const auto before = memory.chisel;
    memory.chisel = chisel != nullptr ? std::optional(chisel->place) : std::nullopt;
    if (chisel == nullptr || !before) return;
    const double speed = glm::distance(chisel->place, *before) / seconds(audio::frame_ticks);
    const double moves = std::min(1.0, speed / fast),
                 presses = std::min(1.0, glm::length(chisel->force) / hard_n);
    const double gain = chisel->cutting != 0 ? 0.3 + 0.7 * std::max(moves, presses) : 0.5 * moves * presses;
    if (gain < 0.02) return;
    last(writing, writing.sounds.cues.at(static_cast<std::size_t>(Cue::carve)),
         lasting::carve + wizard.player, {.place = chisel->place, .gain = gain, .pitch = 0.85 + 0.3 * moves});
}

void add_living(SoundWriting& writing, const WizardNow& wizard) {
    auto& memory = writing.memory.wizards.at(wizard.player);
    add_steps(writing, wizard, memory);
    add_wand(writing, wizard, memory);
    add_heart(writing, wizard, memory);
    if (writing.match.data().cauldron) add_ladle(writing, wizard, memory);
    if (writing.match.data().crystal) add_chisel(writing, wizard, memory);
}

}  // namespace

void add_wizard_sounds(SoundWriting& writing) {
    const auto& data = writing.match.data();
    writing.match.world().view<const Wizard, const Motion, const WandBelt, ecs::Without<Dead>>().each(
        [&](ecs::Entity e, const Wizard& wizard, const Motion& motion, const WandBelt& belt) {
            const auto* wand = wand_in_hand(data, belt);
            const auto number = wand != nullptr ? static_cast<std::size_t>(wand - data.wands.data()) : 0;
            add_living(writing, {e, wizard.player, motion, belt, wand, number});
        });
}

}  // namespace thaum::game::inline senses
