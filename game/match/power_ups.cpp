#include "game/match/power_ups.h"

#include <algorithm>
#include <limits>

namespace thaum::game {
namespace {

/// The wand with the least energy of its cap; null where there is none.
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

/// Who stands on it and would gain by it: the nearest.
struct Taker {
    ecs::Entity wizard;
    Gift gift;
    double distance = std::numeric_limits<double>::max();
};

Taker find_taker(Stage& stage, const PowerUp& power_up, vec3 place) {
    const auto& rules = stage.data.rules.power_ups[static_cast<std::size_t>(power_up.kind)];
    Taker best;
    stage.world.view<const Health, const WandBelt, const Motion, ecs::Without<Dead>>().each(
        [&](ecs::Entity e, const Health& health, const WandBelt& belt, const Motion& motion) {
            if (health.points <= 0) return;  // about to die in this very tick
            const auto distance = way_on_floor(stage.data.wizard, motion.position, place, rules.radius);
            if (!distance || *distance >= best.distance) return;
            const auto gift = gift_of(stage.data, power_up.kind, health, belt);
            if (gift.amount() >= least_gift) best = {e, gift, *distance};
        });
    return best;
}

void take(Stage& stage, const Taker& taker, PowerUp& power_up, vec3 place, Tick tick) {
    auto& world = stage.world;
    world.get<Health>(taker.wizard).points += taker.gift.health;
    world.get<WandBelt>(taker.wizard).energy[taker.gift.slot] += taker.gift.energy;
    power_up.back_at = tick + stage.data.rules.power_ups[static_cast<std::size_t>(power_up.kind)].again;
    const auto player = std::as_const(world).get<Wizard>(taker.wizard).player;
    record(world, {.tick = tick,
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

void add_power_up_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "power-ups",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Motion, Dead>(),
                  .writes = world.mask<PowerUp, Health, WandBelt, Chronicle>(),
                  .needs = world.mask<PowerUp>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      w.view<PowerUp, const Motion>().each([&](PowerUp& power_up, const Motion& motion) {
                          if (tick < power_up.back_at) return;
                          const auto taker = find_taker(stage, power_up, motion.position);
                          if (taker.wizard) take(stage, taker, power_up, motion.position, tick);
                      });
                  }});
}

}  // namespace thaum::game
