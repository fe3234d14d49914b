#include "game/match/player/walk.h"

#include <algorithm>

#include "game/components/crystal.h"
#include "game/stations/cauldron/brewing.h"

namespace thaum::game::inline match {
namespace {

/// Sideways speed that the player asks for, -127 to 127; 0 at a crystal, where the same keys turn the crystal
/// instead.
std::int32_t strafe_of(const Controls& controls, const Chisel* chisel) {
    return chisel == nullptr ? controls.strafe : 0;
}

vec3 wish_of(const Controls& controls, std::int32_t strafe, const Gaze& gaze, double speed) {
    vec3 wish{strafe / 127.0, 0, -controls.forward / 127.0};
    const double length = glm::length(wish);
    if (length > 1) wish /= length;  // so that walking diagonally is no faster
    return rotation({0, 1, 0}, gaze.yaw) * wish * speed;
}

/// Settings of physics::Mover for this wizard in this tick. `pace`: factor on the wizard's walking speed.
physics::MoverSettings abilities_of(const WizardRules& rules, const Stance& stance, double pace, Tick tick) {
    auto abilities = rules.walk;
    if (tick < stance.loose_until) abilities.ground_acceleration *= rules.loose_grip;
    abilities.walk_speed *= std::max(1.0, pace);  // the mover limits the requested speed to walk_speed
    return abilities;
}

}  // namespace

Body wizard_body(const WizardRules& rules) {
    Body body{physics::mover_body};
    body.size = {rules.radius, rules.height / 2 - rules.radius, 0};
    body.mass = rules.mass;
    body.layer = layer::wizard;
    return body;
}

Motion standing_at(const WizardRules& rules, vec3 feet) {
    Motion motion;
    motion.position = feet + vec3(0, rules.height / 2, 0);
    return motion;
}

void add_walk_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add(
        {.name = "walk",
         .period = physics_period,
         .reads = world.mask<Wizard, Gaze, Motion, Body, Dead, Cauldron, Effects, Chisel>(),
         .writes = world.mask<Controls, Stance, Health, EventLog, resource::Journal, resource::Physics>(),
         .needs = world.mask<Wizard>(),
         .run = [&context](ecs::World& w, Tick tick) {
             const auto& rules = context.data.wizard;
             w.view<Controls, const Gaze, Stance, const Motion, const Body, ecs::Maybe<const Effects>,
                    ecs::Maybe<const Chisel>, ecs::Without<Dead>>()
                 .each([&](ecs::Entity e, Controls& controls, const Gaze& gaze, Stance& stance,
                           const Motion& motion, const Body&, const Effects* effects, const Chisel* chisel) {
                     const auto strafe = strafe_of(controls, chisel);
                     const auto jump = input::bit(input::Button::jump);
                     const bool wishes =
                         strafe != 0 || controls.forward != 0 || (controls.pressed & jump) != 0;
                     // The body is at rest and no motion is requested, so the mover has nothing to do.
                     if (motion.asleep != 0 && !wishes) return;
                     const double pace = pace_at(context.data, std::as_const(w), motion.position) *
                                         factors_of(context.data.effects, effects, tick).pace;
                     const auto abilities = abilities_of(rules, stance, pace, tick);
                     const auto result = physics::move(
                         context.physics.write(), e.index,
                         {.wish_velocity = wish_of(controls, strafe, gaze, pace * rules.walk.walk_speed),
                          .jump = (controls.pressed & jump) != 0,
                          .rope_lift = stance.rope_lift},
                         abilities, stance, physics_dt);
                     if (result.jumped) controls.pressed &= ~jump;
                     const double excess = result.landing_speed - rules.fall_safe;
                     if (excess > 0) {
                         hurt(context, e, tick,
                              {.points = excess * rules.fall_damage,
                               .how = EventKind::fall,
                               .place = motion.position});
                     }
                 });
         }});
}

}  // namespace thaum::game::inline match
