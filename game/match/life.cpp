#include "game/match/life.h"

#include <algorithm>

#include "game/components/casting.h"
#include "game/context/effects.h"
#include "game/data/wand_slots.h"
#include "game/match/player/walk.h"

namespace thaum::game::inline match {
namespace {

/// Counts a kill for the killer. A death without a killer, or caused by the victim, reduces the victim's
/// kills by one.
void count_kill(ecs::World& world, std::uint32_t victim, std::uint32_t killer) {
    world.view<const Wizard, Score>().each([&](const Wizard& wizard, Score& score) {
        const bool suicide = killer == no_player || killer == victim;
        if (wizard.player == victim) {
            ++score.deaths;
            if (suicide) --score.kills;
        } else if (wizard.player == killer) {
            ++score.kills;
        }
    });
}

/// The player who hurt the victim last. If the last harm came from no player, the foe counts as the killer if
/// the foe hurt or pushed the victim in the last `blame` ticks. An example is a shot that pushed the victim
/// into a pit.
std::uint32_t killer_of(const Wizard& wizard, const Health& health, Tick blame, Tick tick) {
    const bool foes_deed = health.foe_did_at != 0 && tick <= health.foe_did_at + blame;
    return health.hurt_by >= players && foes_deed ? 1 - wizard.player : health.hurt_by;
}

void die(MatchContext& context, ecs::Entity e, const Wizard& wizard, const Health& health,
         const Motion& motion, Tick tick) {
    auto& world = context.world;
    const auto killer = killer_of(wizard, health, context.data.wizard.blame, tick);
    count_kill(world, wizard.player, killer);
    record(context, {.tick = tick,
                     .kind = EventKind::death,
                     .subject = wizard.player,
                     .by = killer,
                     .detail = health.hurt_how,
                     .place = motion.position});
    lose_effects(context, e, tick);
    world.commands().add(e, Dead{tick + context.data.round.respawn});
    world.commands().remove<Body>(e);
}

void return_to_life(MatchContext& context, ecs::Entity e, const Wizard& wizard, Health& health, Tick tick) {
    auto& world = context.world;
    const auto foe = wizard_of(world, 1 - wizard.player);
    const auto& const_world = std::as_const(world);
    const auto pad = farthest_pad(world, const_world.get<Motion>(foe).position);
    health = {.points = full_health(context.data.wizard, health),
              .shielded_until = tick + context.data.round.spawn_shield,
              .hurt_by = no_player,
              .limit = health.limit,
              .surge = health.surge};
    world.get<Motion>(e) = standing_at(context.data.wizard, pad.feet);
    world.get<Gaze>(e) = {pad.yaw, 0};
    world.get<Stance>(e) = {};
    world.get<Blows>(e) = {};
    if (context.data.casting) world.get<Focus>(e).points = context.data.casting->focus_cap;
    world.get<WandBelt>(e).energy = full_belt(context.data).energy;
    world.commands().remove<Dead>(e);
    world.commands().add(e, wizard_body(context.data.wizard));
    record(context, {.tick = tick,
                     .kind = EventKind::spawn,
                     .subject = wizard.player,
                     .detail = pad.number,
                     .place = pad.feet});
}

}  // namespace

Pad farthest_pad(const ecs::World& world, vec3 from) {
    Pad best;
    double best_distance = -1;
    world.view<const Pad>().each([&](const Pad& pad) {
        const double distance = glm::distance(pad.feet, from);
        if (distance > best_distance) best = pad, best_distance = distance;
    });
    return best;
}

void add_life_systems(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    auto writes = effect_writes(world, context.data.effects);
    writes |= world.mask<Health, Score>();
    schedule.add({.name = "deaths",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Motion, Dead>(),
                  .writes = writes,
                  .needs = world.mask<Health>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      const auto& rules = context.data.wizard;
                      const double loss = context.data.wizard.excess_loss * gameplay_dt;
                      w.view<const Wizard, Health, const Motion, ecs::Without<Dead>>().each(
                          [&](ecs::Entity e, const Wizard& wizard, Health& health, const Motion& motion) {
                              const double full = full_health(rules, health);
                              if (health.points > full) health.points = std::max(full, health.points - loss);
                              health.points = std::min(health.points, largest_health(rules, health));
                              if (health.points <= 0) {
                                  health.points = 0;
                                  die(context, e, wizard, health, motion, tick);
                              }
                          });
                  }});
    schedule.add(
        {.name = "resurrection",
         .period = gameplay_period,
         .reads = world.mask<Wizard, Pad, Dead>(),
         .writes =
             world.mask<Health, Motion, Gaze, Stance, Blows, WandBelt, Focus, EventLog, resource::Journal>(),
         .needs = world.mask<Dead>(),
         .run = [&context](ecs::World& w, Tick tick) {
             w.view<const Wizard, Health, const Dead>().each(
                 [&](ecs::Entity e, const Wizard& wizard, Health& health, const Dead& dead) {
                     if (tick >= dead.returns_at) return_to_life(context, e, wizard, health, tick);
                 });
         }});
}

}  // namespace thaum::game::inline match
