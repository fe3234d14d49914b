#include "game/match/great_work.h"

#include <algorithm>

#include "game/components/crystal.h"
#include "game/components/potions.h"

namespace thaum::game::inline match {
namespace {

/// Starts or ends the time for which one player holds both halves of the Great Work, and records the event.
/// The halves are two rare things; to hold both long enough wins the round.
void follow(MatchContext& context, std::uint32_t player, bool holds_both, vec3 place, Tick tick) {
    auto& since = context.world.single<GreatWork>().since[player];
    if ((since != 0) == holds_both) return;
    since = holds_both ? std::max<Tick>(tick, 1) : 0;
    record(context, {.tick = tick,
                     .kind = holds_both ? EventKind::work_begun : EventKind::work_broken,
                     .subject = player,
                     .by = player,
                     .amount = holds_both ? seconds(context.data.crystal->work_lasts) : 0,
                     .place = place});
}

}  // namespace

std::uint32_t great_worker(const MatchContext& context, Tick tick) {
    if (context.world.count<GreatWork>() == 0) return no_player;
    for (std::uint32_t player = 0; player < players; ++player)
        if (held_both_for(context.world, player, tick) >= context.data.crystal->work_lasts) return player;
    return no_player;
}

Tick held_both_for(const ecs::World& world, std::uint32_t player, Tick tick) {
    const auto since = world.single<GreatWork>().since[player];
    return since == 0 || tick < since ? 0 : tick - since;
}

void add_great_work_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add(
        {.name = "great work",
         .period = gameplay_period,
         .reads = world.mask<Wizard, Motion, WorkHalf, Lens, Dead>(),
         .writes = world.mask<GreatWork, EventLog, resource::Journal>(),
         .needs = world.mask<GreatWork>(),
         .run = [&context](ecs::World& w, Tick tick) {
             w.view<const Wizard, const Motion, const WorkHalf, const Lens, ecs::Maybe<const Dead>>().each(
                 [&](const Wizard& wizard, const Motion& motion, const WorkHalf& half, const Lens& lens,
                     const Dead* dead) {
                     const bool both = half.held != 0 && lens.held != 0 && dead == nullptr;
                     follow(context, wizard.player, both, motion.position, tick);
                 });
         }});
}

}  // namespace thaum::game::inline match
