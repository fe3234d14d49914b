#include "game/match/round.h"

#include "game/arena/spawn.h"
#include "game/cauldron/brewing.h"
#include "game/match/arm.h"
#include "game/match/touch.h"
#include "game/player/walk.h"
#include "game/wands/belt.h"

namespace thaum::game {
namespace {

/// Ticks before a player may ask for the next round, so that who was just shooting does not.
constexpr Tick soonest = ticks(0.8);

/// Everything but the match itself.
void clear_scene(ecs::World& world) {
    const auto match = world.single<Match>();
    const auto dice = world.single<Dice>();
    const auto chronicle = world.single<Chronicle>();
    world.clear();
    world.create(match, dice, chronicle);
}

void spawn_wizards(Stage& stage) {
    auto& world = stage.world;
    std::array<Pad, players> starts;
    world.view<const Pad>().each([&](const Pad& pad) {
        if (pad.player < players) starts[pad.player] = pad;
    });
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& pad = starts[player];
        const auto& rules = stage.data.wizard;
        const auto e =
            world.create(Wizard{player}, Controls{}, Gaze{pad.yaw, 0}, Stance{},
                         Health{.points = rules.health, .hurt_by = no_player}, Blows{}, full_belt(stage.data),
                         empty_grip(), Score{}, Look{Surface::wizard}, standing_at(rules, pad.feet));
        for (const auto& wand : stage.data.wands) wand.kind->outfit(world, e);
        world.add(e, wizard_body(rules));
    }
}

bool decided(const Match& match, std::uint32_t rounds) {
    return match.rounds_won[0] > rounds / 2 || match.rounds_won[1] > rounds / 2 || match.round + 1 >= rounds;
}

void end_round(Stage& stage, Ending ending, std::uint32_t winner, Tick tick) {
    auto& world = stage.world;
    auto& match = world.single<Match>();
    match.ending = ending;
    match.winner = winner;
    if (winner < players) ++match.rounds_won[winner];
    match.phase = decided(match, stage.data.round.rounds) ? Phase::over : Phase::between;
    match.waited = 0;
    record(world, {.tick = tick,
                   .kind = EventKind::round_end,
                   .subject = winner,
                   .detail = static_cast<std::uint32_t>(ending)});
}

std::uint32_t leader(const std::array<std::int32_t, players>& kills) {
    if (kills[0] == kills[1]) return no_player;
    return kills[0] > kills[1] ? 0 : 1;
}

}  // namespace

void open_round(Stage& stage) {
    const auto arms = arms_in(stage.world);
    clear_scene(stage.world);
    spawn_arena(stage.world, stage.data.arena);
    spawn_cauldron(stage);
    spawn_niches(stage);
    spawn_wizards(stage);
    add_arms(stage, arms);
}

void add_round_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "round",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Score>(),
                  .writes = world.mask<Match, Chronicle>(),
                  .needs = world.mask<Score>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      std::array<std::int32_t, players> kills{};
                      w.view<const Wizard, const Score>().each([&](const Wizard& wizard, const Score& score) {
                          kills[wizard.player] = score.kills;
                      });
                      const auto& rules = stage.data.round;
                      const auto& match = std::as_const(w).single<Match>();
                      const bool enough = kills[0] >= rules.kills || kills[1] >= rules.kills;
                      // Both in one tick: the one with more, or a draw.
                      if (enough) {
                          end_round(stage, Ending::kills, leader(kills), tick);
                      } else if (match.played + 1 >= match.round_began + rules.length) {
                          end_round(stage, Ending::time, leader(kills), tick);
                      }
                  }});
}

void add_interval_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "interval",
                  .reads = world.mask<Controls>(),
                  .writes = world.mask<Match>(),
                  .needs = world.mask<Controls>(),
                  .run = [&stage](ecs::World& w, Tick) {
                      auto& match = w.single<Match>();
                      if (match.phase != Phase::between) return;
                      ++match.waited;
                      std::uint32_t pressed = 0;
                      w.view<const Controls>().each([&](const Controls& c) { pressed |= c.pressed; });
                      const bool asked = (pressed & static_cast<std::uint32_t>(input::Button::confirm)) != 0;
                      if (asked && match.waited >= soonest)
                          match.waited = static_cast<std::uint32_t>(stage.data.round.interval);
                  }});
}

bool next_round_is_due(const Stage& stage) {
    const auto& match = stage.world.single<Match>();
    return match.phase == Phase::between && match.waited >= stage.data.round.interval;
}

void begin_next_round(Stage& stage) {
    open_round(stage);
    auto& match = stage.world.single<Match>();
    match.phase = Phase::playing;
    match.round_began = match.played;
    ++match.round;
    record(stage.world, {.tick = match.played, .kind = EventKind::round_begin, .detail = match.round});
    stage.physics.rebuild();
}

}  // namespace thaum::game
