#include "game/match/power_ups.h"

#include <limits>

#include "game/context/effects.h"

namespace thaum::game::inline match {
namespace {

const PowerUpRules& rules_of(const MatchContext& context, const PowerUp& power_up) {
    return context.data.rules.power_ups[static_cast<std::size_t>(power_up.kind)];
}

/// The nearest wizard who stands on the power-up and has some use for it.
struct Taker {
    ecs::Entity wizard;
    double gain{};  ///< what the wizard would gain by it (HP, energy and focus together)
    double distance = std::numeric_limits<double>::max();
};

Taker find_taker(MatchContext& context, const PowerUp& power_up, const EffectStart& start) {
    const auto& rules = rules_of(context, power_up);
    Taker best;
    context.world.view<const Health, const Motion, ecs::Without<Dead>>().each(
        [&](ecs::Entity e, const Health& health, const Motion& motion) {
            if (health.points <= 0) return;  // the wizard is about to die in this tick
            const auto distance =
                distance_on_floor(context.data.wizard, motion.position, start.place, rules.radius);
            if (!distance || *distance >= best.distance) return;
            const double gain = gain_of(context, e, rules.effects, start);
            if (gain >= min_gain || is_worth_taking(rules.effects)) best = {e, gain, *distance};
        });
    return best;
}

void take(MatchContext& context, const Taker& taker, PowerUp& power_up, const EffectStart& start) {
    const auto& rules = rules_of(context, power_up);
    begin_effects(context, taker.wizard, rules.effects, start);
    power_up.back_at = start.tick + rules.again;
    const auto player = std::as_const(context.world).get<Wizard>(taker.wizard).player;
    record(context, {.tick = start.tick,
                     .kind = EventKind::power_up,
                     .subject = player,
                     .by = player,
                     .detail = static_cast<std::uint32_t>(power_up.kind),
                     .amount = taker.gain,
                     .place = start.place});
}

}  // namespace

void add_power_up_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    auto reads = effect_reads(world);
    reads |= world.mask<Health>();
    auto writes = world.mask<PowerUp, EventLog, resource::Journal>();
    for (const auto& rules : context.data.rules.power_ups) writes |= effect_writes(world, rules.effects);
    schedule.add({.name = "power-ups",
                  .period = gameplay_period,
                  .reads = reads,
                  .writes = writes,
                  .needs = world.mask<PowerUp>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<PowerUp, const Motion>().each([&](PowerUp& power_up, const Motion& motion) {
                          if (tick < power_up.back_at) return;
                          const EffectStart start{.tick = tick, .place = motion.position};
                          const auto taker = find_taker(context, power_up, start);
                          if (taker.wizard) take(context, taker, power_up, start);
                      });
                  }});
}

}  // namespace thaum::game::inline match
