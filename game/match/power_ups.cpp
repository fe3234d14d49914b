#include "game/match/power_ups.h"

#include <algorithm>
#include <limits>

namespace thaum::game::inline match {
namespace {

/// The wand whose energy is the smallest share of its cap; null if no wand has a cap.
const LoadedWand* emptiest_wand(const MatchData& data, const WandBelt& belt) {
    const LoadedWand* found = nullptr;
    double least = std::numeric_limits<double>::max();
    for (const auto& wand : data.wands) {
        if (wand.stats.energy_cap <= 0) continue;
        const double share = belt.energy[wand.stats.energy_slot] / wand.stats.energy_cap;
        if (share < least) found = &wand, least = share;
    }
    return found;
}

/// The nearest wizard who stands on the power-up and can gain from it, with that gain.
struct Taker {
    ecs::Entity wizard;
    Gift gift;
    double distance = std::numeric_limits<double>::max();
};

Taker find_taker(MatchContext& context, const PowerUp& power_up, vec3 place) {
    const auto& rules = context.data.rules.power_ups[static_cast<std::size_t>(power_up.kind)];
    Taker best;
    context.world.view<const Health, const WandBelt, const Motion, ecs::Without<Dead>>().each(
        [&](ecs::Entity e, const Health& health, const WandBelt& belt, const Motion& motion) {
            if (health.points <= 0) return;  // the wizard is about to die in this tick
            const auto distance =
                distance_on_floor(context.data.wizard, motion.position, place, rules.radius);
            if (!distance || *distance >= best.distance) return;
            const auto gift = gift_of(context.data, power_up.kind, health, belt);
            if (gift.amount() >= min_gift) best = {e, gift, *distance};
        });
    return best;
}

void take(MatchContext& context, const Taker& taker, PowerUp& power_up, vec3 place, Tick tick) {
    auto& world = context.world;
    world.get<Health>(taker.wizard).points += taker.gift.health;
    world.get<WandBelt>(taker.wizard).energy[taker.gift.slot] += taker.gift.energy;
    power_up.back_at = tick + context.data.rules.power_ups[static_cast<std::size_t>(power_up.kind)].again;
    const auto player = std::as_const(world).get<Wizard>(taker.wizard).player;
    record(context, {.tick = tick,
                     .kind = EventKind::power_up,
                     .subject = player,
                     .by = player,
                     .detail = static_cast<std::uint32_t>(power_up.kind),
                     .amount = taker.gift.amount(),
                     .place = place});
}

}  // namespace

Gift gift_of(const MatchData& data, PowerUpKind kind, const Health& health, const WandBelt& belt) {
    const auto& rules = data.rules.power_ups[static_cast<std::size_t>(kind)];
    Gift gift;
    gift.health = std::max(0.0, std::min(rules.health, data.wizard.health_cap - health.points));
    if (const auto* wand = emptiest_wand(data, belt)) {
        const auto& stats = wand->stats;
        gift.slot = stats.energy_slot;
        gift.energy = std::max(0.0, std::min(rules.energy_share * stats.energy_cap,
                                             stats.energy_cap - belt.energy[stats.energy_slot]));
    }
    return gift;
}

void add_power_up_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "power-ups",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Motion, Dead>(),
                  .writes = world.mask<PowerUp, Health, WandBelt, EventLog, resource::Journal>(),
                  .needs = world.mask<PowerUp>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<PowerUp, const Motion>().each([&](PowerUp& power_up, const Motion& motion) {
                          if (tick < power_up.back_at) return;
                          const auto taker = find_taker(context, power_up, motion.position);
                          if (taker.wizard) take(context, taker, power_up, motion.position, tick);
                      });
                  }});
}

}  // namespace thaum::game::inline match
