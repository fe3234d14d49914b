#include "game/match/round.h"

namespace thaum::game {
namespace {

void end_round(ecs::World& world, Match& match, Ending ending, std::uint32_t winner, Tick tick) {
    match.phase = Phase::over;
    match.ending = ending;
    match.winner = winner;
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
                      auto& match = w.single<Match>();
                      const bool enough = kills[0] >= rules.kills || kills[1] >= rules.kills;
                      // Both in one tick: the one with more, or a draw.
                      if (enough) {
                          end_round(w, match, Ending::kills, leader(kills), tick);
                      } else if (match.played + 1 >= rules.length) {
                          end_round(w, match, Ending::time, leader(kills), tick);
                      }
                  }});
}

}  // namespace thaum::game
