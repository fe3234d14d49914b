// game/context/shot.h: common parts of wands that shoot: the muzzle, the cost of a shot and its burst.
#pragma once
#include "game/context/match_context.h"
#include "game/data/wand.h"

namespace thaum::game::inline context {

/// A number that grows linearly from its least to its greatest value while the charge or draw of a wand grows
/// from 0 to 1.
struct GrowingValue {
    double least{}, most{};
    double at(double share) const { return least + (most - least) * share; }
};
/// Reads the least value (of an uncharged wand) from key `name` and the greatest from key `full`.
GrowingValue read_growing(const ConfigTable& table, std::string_view name, std::string_view full,
                          Range range);

/// True while fire is held, and in the first gameplay tick after fire was pressed.
bool holds_fire(const Controls& controls);

/// Line of sight through the crosshair.
struct Sight {
    vec3 eye{};    ///< position of the eye (m, world)
    vec3 ahead{};  ///< direction of the view (unit, world)
};
/// Returns the wizard's line of sight. Reads Gaze and resource::Physics.
Sight sight_of(const MatchContext& context, ecs::Entity wizard);

/// Start and direction of a shot.
struct Muzzle {
    /// Position of the wand's tip, or of the eye if something stands between eye and tip (m, world).
    vec3 tip{};
    vec3 ahead{};  ///< direction of view (unit, world)
    vec3 aim{};    ///< direction from the tip to the point under the crosshair (unit, world)
};
/// Start and direction of a shot whose missile has this radius (m). Reads Wizard, Gaze, Motion, HandState and
/// resource::Physics.
Muzzle muzzle_of(const WandUse& use, double radius);

/// Turns the muzzle's aim by the player's aim assist (context/aim_assist.h), for a straight shot of this
/// speed (m/s). Reads Wizard, Dead, Arm and resource::Physics.
void help_aim(const WandUse& use, double speed, Muzzle& muzzle);

/// Records that fire was pressed without enough energy for a shot. Writes EventLog and resource::Journal.
void note_dry(const WandUse& use);
/// Records a shot and ends the shooter's protection after a return to life. `hit`: kind of event as which
/// hits by this shot will be recorded. Writes WandBelt, Health, EventLog and resource::Journal.
void note_shot(const WandUse& use, EventKind hit, vec3 tip);

/// A burst, a missile's explosion, hurts and pushes all bodies near it. The distance of a body is measured to
/// its surface, on the straight line to its middle. For a wizard, the line goes to the nearest point of the
/// capsule's axis. The effect falls linearly from its full value at distance zero to nothing at `radius`. A
/// body behind another one is not affected. The shooter's body gives no cover to others, and is affected
/// itself.
struct Burst {
    vec3 place{};      ///< middle of the missile (m, world)
    double size{};     ///< radius of the missile (m); bodies that the missile touches are at distance zero
    double radius{};   ///< distance up to which the burst has an effect (m)
    double damage{};   ///< harm to a body at distance zero (HP)
    double impulse{};  ///< impulse that the burst gives to a body at distance zero (N s)
    double fastest{};  ///< largest speed that a body gains by the burst (m/s)
    std::uint32_t player{};   ///< player who fired the shot
    std::uint32_t shooter{};  ///< key (number) of the shooter's body in the physics
    EventKind how{};
    /// Physics key (number) of a body that takes `struck_damage` instead of `damage`, because the missile
    /// struck it.
    std::uint32_t struck = physics::no_key;
    double struck_damage{};  ///< harm to the body with the key `struck` (HP)
    bool pierces{};          ///< true: the Shield spell absorbs none of the harm
    double venom{};          ///< harm by poison to each wizard whom the burst hurts (HP/s); 0: none
    Tick venom_lasts{};      ///< duration of the poison (ticks)
};
/// Applies a burst to all bodies near it and records the event. Reads Body, Motion, Wizard, Effects, Dead and
/// Crystal. Writes Health, Stance, EventLog, Prop, resource::Journal and resource::Physics.
void burst(MatchContext& context, const Burst& burst, Tick tick);

}  // namespace thaum::game::inline context
