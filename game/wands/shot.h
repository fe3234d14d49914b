// game/wands/shot.h: what the wands that shoot have in common: where a shot leaves, what it costs and how it bursts.
#pragma once
#include "game/match/stage.h"
#include "game/wands/wand.h"

namespace thaum::game {

/// A number that grows with how far a wand is charged or drawn.
struct Growing {
    double least{}, most{};
    double at(double share) const { return least + (most - least) * share; }
};
/// From NAME and, for the most, from FULL.
Growing read_growing(const ConfigTable& table, std::string_view name, std::string_view full, Range range);

/// True while fire is held, and at the first look after it was pressed.
bool holds_fire(const Controls& controls);

/// Where the crosshair is, from the wizard's eye.
struct Sight {
    vec3 eye{};    ///< m, world
    vec3 ahead{};  ///< unit
};
/// Reads Gaze.
Sight sight_of(const Stage& stage, ecs::Entity wizard);

/// Where a shot leaves, and which way.
struct Muzzle {
    vec3 tip{};    ///< m, world: the wand's tip; the eye, where something stands between the two
    vec3 ahead{};  ///< unit: where the wizard looks
    vec3 aim{};    ///< unit: from the tip to what the crosshair is on
};
/// For a shot of that radius, m.
Muzzle muzzle_of(const WandUse& use, double radius);

/// Somebody pressed fire without the energy for a shot. Writes Chronicle.
void note_dry(const WandUse& use);
/// A shot has left; `hit` is the kind of event that its hits are. Who attacks is no longer protected. Writes WandBelt, Health and
/// Chronicle.
void note_shot(const WandUse& use, EventKind hit, vec3 tip);

/// Hurts and pushes whatever is near. A body is as far away as its surface on the straight line to its middle (a wizard: to the
/// nearest point of the capsule's axis). All falls evenly from its full value at distance zero to nothing at `radius`; a body behind
/// another is spared; who shot gives the others no cover, and is not spared.
struct Burst {
    vec3 place{};             ///< m, middle of the missile
    double size{};            ///< m, radius of the missile: what it touches is at distance zero
    double radius{};          ///< m
    double damage{};          ///< HP
    double impulse{};         ///< N s
    double fastest{};         ///< m/s: nothing gains more speed by it
    std::uint32_t player{};   ///< whose shot it was
    std::uint32_t shooter{};  ///< key of the body
    EventKind how{};
    std::uint32_t struck = physics::no_key;  ///< key of a body that takes `struck_damage` instead
    double struck_damage{};                  ///< HP
};
/// Records it too. Reads Body, Motion, Wizard and Dead; writes Health, Chronicle and Prop.
void burst(Stage& stage, const Burst& burst, Tick tick);

}  // namespace thaum::game
