#include "game/match/round.h"
#include "game/casting/free_casting.h"

#include "game/components/casting.h"
#include "game/components/stroke_reading.h"
#include "game/context/hand_forces.h"
#include "game/data/wand_slots.h"
#include "game/match/great_work.h"
#include "game/match/hand/arm_system.h"
#include "game/match/haptic_setup.h"
#include "game/match/player/walk.h"
#include "game/match/spawn.h"
#include "game/stations/cauldron/brewing.h"
#include "game/stations/orb/orb.h"

namespace thaum::game::inline match {
namespace {

/// Ticks before a player can request the next round, so that a player who is still shooting does not start it
/// by accident.
constexpr Tick soonest = ticks(0.8);

/// Removes all entities except the one with the match, its random numbers and its event log.
void clear_scene(ecs::World& world) {
    const auto match = world.single<Match>();
    const auto dice = world.single<Dice>();
    const auto event_log = world.single<EventLog>();
    world.clear();
    world.create(match, dice, event_log);
}

void spawn_wizards(MatchContext& context) {
    auto& world = context.world;
    std::array<Pad, players> starts;
    world.view<const Pad>().each([&](const Pad& pad) {
        if (pad.player < players) starts[pad.player] = pad;
    });
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& pad = starts[player];
        const auto& rules = context.data.wizard;
        const auto e = world.create(Wizard{player}, Controls{}, Gaze{pad.yaw, 0}, Stance{},
                                    Health{.points = rules.health, .hurt_by = no_player}, Blows{},
                                    full_belt(context.data), empty_hand_state(), Score{},
                                    Look{Surface::wizard}, standing_at(rules, pad.feet));
        world.add(e, Effects{});
        if (context.data.cauldron) world.add(e, WorkHalf{});
        if (context.data.crystal) world.add(e, Lens{});
        for (const auto& wand : context.data.wands)
            if (is_first_of_kind(context.data, wand)) wand.rules->outfit(world, e);
        if (context.data.casting) world.add(e, Focus{context.data.casting->focus_cap});
        if (context.data.casting) world.add(e, LastProp{});
        if (context.data.casting) world.add(e, LastReading{.gesture = no_gesture, .nearest = no_gesture});
        if (casts_freely(context, player)) {
            world.add(e, FreeHand{});
            world.add(e, NearMiss{.gesture = no_gesture});
        }
        world.add(e, wizard_body(rules));
    }
}

bool decided(const Match& match, std::uint32_t rounds) {
    return match.rounds_won[0] > rounds / 2 || match.rounds_won[1] > rounds / 2 || match.round + 1 >= rounds;
}

void end_round(MatchContext& context, Ending ending, std::uint32_t winner, Tick tick) {
    auto& world = context.world;
    auto& match = world.single<Match>();
    match.ending = ending;
    match.winner = winner;
    if (winner < players) ++match.rounds_won[winner];
    match.phase = decided(match, context.data.round.rounds) ? Phase::over : Phase::between;
    match.waited = 0;
    record(context, {.tick = tick,
                     .kind = EventKind::round_end,
                     .subject = winner,
                     .detail = static_cast<std::uint32_t>(ending)});
}

/// Records an event that happens to both players.
void tell_both(MatchContext& context, EventKind kind, double amount, Tick tick) {
    for (std::uint32_t player = 0; player < players; ++player)
        record(context, {.tick = tick, .kind = kind, .subject = player, .amount = amount});
}

/// Sets the factor on the players' harm to that of the present surge, and tells when it changes.
void surge(MatchContext& context, Tick age, Tick tick) {
    const double factor = surge_at(context.data.round, age);
    bool changed = false;
    context.world.view<const Wizard, Health>().each([&](const Wizard&, Health& health) {
        changed = changed || health.surge != factor;
        health.surge = factor;
    });
    if (changed) tell_both(context, surge_event(), factor, tick);
}

/// Lets a round whose time is up go on until the next death, with little health for both.
void boil_over(MatchContext& context, Tick tick) {
    const auto& rules = context.data.round.boil_over;
    context.world.single<Match>().boils_over_since = std::max<Tick>(tick, 1);
    context.world.view<const Wizard, Health>().each([&](ecs::Entity wizard, const Wizard&, Health& health) {
        health.limit = rules.health;
        if (!context.world.has<Dead>(wizard)) health.points = rules.health;
    });
    tell_both(context, tied_event(), seconds(rules.length), tick);
}

void end_by_great_work(MatchContext& context, std::uint32_t worker, Tick tick) {
    record(context, {.tick = tick, .kind = EventKind::work_done, .subject = worker, .by = worker});
    end_round(context, Ending::great_work, worker, tick);
}

std::uint32_t leader(const std::array<std::int32_t, players>& kills) {
    if (kills[0] == kills[1]) return no_player;
    return kills[0] > kills[1] ? 0 : 1;
}

std::array<std::int32_t, players> kills_of(const ecs::World& world) {
    std::array<std::int32_t, players> kills{};
    world.view<const Wizard, const Score>().each(
        [&](const Wizard& wizard, const Score& score) { kills[wizard.player] = score.kills; });
    return kills;
}

/// Ends the round if it is decided. Kills come before the Great Work (another way to win), and this before
/// the time. If both players reach the limit of kills in one tick, the one with more kills wins; equal
/// kills are a draw.
void judge(MatchContext& context, Tick tick) {
    const auto& rules = context.data.round;
    const auto& match = std::as_const(context.world).single<Match>();
    const auto kills = kills_of(context.world);
    const auto first = leader(kills);
    const auto worker = great_worker(context, tick);
    const bool boils_over = match.boils_over_since != 0;
    const bool late = match.played + 1 >= round_ends_at(rules, match);
    if (boils_over && first < players) return end_round(context, Ending::boil_over, first, tick);
    if (kills[0] >= rules.kills || kills[1] >= rules.kills)
        return end_round(context, Ending::kills, first, tick);
    if (worker < players) return end_by_great_work(context, worker, tick);
    if (late && !boils_over && first == no_player && rules.boil_over.length > 0)
        boil_over(context, tick);
    else if (late)
        return end_round(context, boils_over ? Ending::boil_over : Ending::time, first, tick);
    surge(context, match.played + 1 - match.round_began, tick);
}

}  // namespace

void open_round(MatchContext& context, BrewSolver& solver, CrystalBodies& crystals) {
    const auto arms = arms_in(context.world);
    const auto faders = moved_faders_in(context.world);
    std::optional<DrawnOrders> orders;
    if (context.world.count<DrawnOrders>() > 0) orders = std::as_const(context.world).single<DrawnOrders>();
    const auto seeds = next_seeds(context.world);
    const auto orb = orb_memory(context.world);
    clear_scene(context.world);
    spawn_arena(context.world, context.data.arena);
    spawn_cauldron(context, solver);
    spawn_crystals(context, crystals, seeds);
    spawn_niches(context);
    spawn_wizards(context);
    add_arms(context, arms);
    if (faders) context.world.create(*faders);
    if (orders) context.world.create(*orders);
    if (context.data.crystal && context.data.cauldron) context.world.create(GreatWork{});
    if (orb) spawn_next_orb(context, *orb);
}

void add_round_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "round",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Score, GreatWork, Dead>(),
                  .writes = world.mask<Match, Health, EventLog, resource::Journal>(),
                  .needs = world.mask<Score>(),
                  .run = [&context](ecs::World&, Tick tick) { judge(context, tick); }});
}

void add_interval_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "interval",
                  .reads = world.mask<Controls>(),
                  .writes = world.mask<Match>(),
                  .needs = world.mask<Controls>(),
                  .run = [&context](ecs::World& w, Tick) {
                      auto& match = w.single<Match>();
                      if (match.phase != Phase::between) return;
                      ++match.waited;
                      std::uint32_t pressed = 0;
                      w.view<const Controls>().each([&](const Controls& c) { pressed |= c.pressed; });
                      const bool asked = (pressed & static_cast<std::uint32_t>(input::Button::confirm)) != 0;
                      if (asked && match.waited >= soonest)
                          match.waited = static_cast<std::uint32_t>(context.data.round.interval);
                  }});
}

bool next_round_is_due(const MatchContext& context) {
    const auto& match = context.world.single<Match>();
    return match.phase == Phase::between && match.waited >= context.data.round.interval;
}

void begin_next_round(MatchContext& context, BrewSolver& solver, CrystalBodies& crystals) {
    open_round(context, solver, crystals);
    auto& match = context.world.single<Match>();
    match.phase = Phase::playing;
    match.round_began = match.played;
    match.boils_over_since = 0;
    ++match.round;
    record(context, {.tick = match.played, .kind = EventKind::round_begin, .detail = match.round});
    context.physics.write().rebuild();
}

}  // namespace thaum::game::inline match
