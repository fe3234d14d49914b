#include "game/context/effects.h"

#include <algorithm>

namespace thaum::game::inline context {
namespace {

/// Time between two losses of health by poison.
constexpr Tick poison_period = ticks(1.0);

/// Records that a potion is over, once none of its effects acts any more.
void note_end(MatchContext& context, const EffectUse& use, std::uint32_t potion, std::uint32_t player) {
    const auto& effects = std::as_const(context.world).get<Effects>(use.wizard);
    if (potion >= context.data.recipes.size()) return;
    if (end_of(context.data.recipes[potion].effects, effects) != 0) return;
    record(context, {.tick = use.tick,
                     .kind = EventKind::potion_over,
                     .subject = player,
                     .by = player,
                     .detail = potion,
                     .place = use.place});
}

/// Whether any effect of a kind acts on a wizard.
bool acts(const MatchContext& context, const Effects& effects, const EffectKind* kind) {
    return std::ranges::any_of(context.data.effects, [&](const ListedEffect& one) {
        return one.kind == kind && effects.until[one.number] != 0;
    });
}

/// Ends the effects whose time is up, and lets the others act.
void run_effects(MatchContext& context, ecs::Entity wizard, std::uint32_t player, vec3 place, Tick tick) {
    auto& effects = context.world.get<Effects>(wizard);
    for (const auto& one : context.data.effects) {
        auto& until = effects.until[one.number];
        if (until == 0) continue;
        const EffectUse use{context, wizard, effects.strength[one.number], one.lasts, tick, place};
        if (tick < until) {
            one.rules->step(use);
            continue;
        }
        until = 0;
        effects.strength[one.number] = 0;
        if (!acts(context, effects, one.kind)) one.rules->over(use);
        if (one.potion != no_potion) note_end(context, use, one.potion, player);
    }
}

/// Hurts a poisoned wizard, once a second.
void hurt_by_poison(MatchContext& context, ecs::Entity e, const Health& health, vec3 place, Tick tick) {
    if (tick >= health.poisoned_until) return;
    // The first hit comes a second after the poisoning, the last one in the last gameplay tick.
    if ((health.poisoned_until - tick - 1) % poison_period >= gameplay_period) return;
    hurt(context, e, tick,
         {.points = health.poison * seconds(poison_period),
          .by = health.poisoned_by,
          .how = EventKind::poison,
          .place = place});
}

/// Lets effects act on the weight of wizards. Where there is a brew, its system does so, since the brew acts
/// on the weight, too (stations/cauldron/brewing.h).
void add_weight_system(MatchContext& context, ecs::Schedule& schedule) {
    if (context.data.cauldron) return;
    const auto& world = context.world;
    schedule.add({.name = "weight",
                  .reads = world.mask<Body, Effects, Dead>(),
                  .writes = world.mask<resource::Physics>(),
                  .needs = world.mask<Effects>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<const Body, const Effects, ecs::Without<Dead>>().each(
                          [&](ecs::Entity e, const Body& body, const Effects& effects) {
                              leave_weight(context, e, body,
                                           factors_of(context.data.effects, &effects, tick).gravity);
                          });
                  }});
}

}  // namespace

void leave_weight(MatchContext& context, ecs::Entity wizard, const Body& body, double share) {
    if (share == 1) return;
    auto& physics = context.physics.write();
    physics.apply_central_impulse(wizard.index,
                                  -(1 - share) * body.mass * physics_dt * physics.settings().gravity);
}

void begin_effects(MatchContext& context, ecs::Entity wizard, const EffectList& list,
                   const EffectStart& start) {
    for (const auto& one : list) {
        if (one.lasts > 0) {
            auto& effects = context.world.get<Effects>(wizard);
            effects.until[one.number] = start.tick + one.lasts;
            effects.strength[one.number] = start.strength;
        }
        one.rules->begin({context, wizard, start.strength, one.lasts, start.tick, start.place});
    }
}

double gain_of(MatchContext& context, ecs::Entity wizard, const EffectList& list, const EffectStart& start) {
    double gain = 0;
    for (const auto& one : list)
        gain += one.rules->gain({context, wizard, start.strength, one.lasts, start.tick, start.place});
    return gain;
}

void lose_effects(MatchContext& context, ecs::Entity wizard, Tick tick) {
    const vec3 place = std::as_const(context.world).get<Motion>(wizard).position;
    context.world.get<Effects>(wizard) = {};
    const auto& all = context.data.effects;
    for (const auto& one : all)
        if (std::ranges::find(all, one.kind, &ListedEffect::kind)->number == one.number)
            one.rules->lost({context, wizard, 1, one.lasts, tick, place});
}

ecs::Mask effect_reads(const ecs::World& world) { return world.mask<Wizard, Motion, Dead>(); }

ecs::Mask effect_writes(const ecs::World& world, const EffectList& list) {
    auto writes = world.mask<Effects, EventLog, resource::Journal>();
    for (const auto& one : list) writes |= one.rules->writes(world);
    return writes;
}

void add_effect_systems(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    auto writes = effect_writes(world, context.data.effects);
    writes |= world.mask<Health>();
    schedule.add({.name = "effects",
                  .period = gameplay_period,
                  .reads = effect_reads(world),
                  .writes = writes,
                  .needs = world.mask<Effects>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<const Wizard, const Motion, Effects, const Health, ecs::Without<Dead>>().each(
                          [&](ecs::Entity e, const Wizard& wizard, const Motion& motion, Effects&,
                              const Health& health) {
                              run_effects(context, e, wizard.player, motion.position, tick);
                              hurt_by_poison(context, e, health, motion.position, tick);
                          });
                  }});
    add_weight_system(context, schedule);
}

}  // namespace thaum::game::inline context
