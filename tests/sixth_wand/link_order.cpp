// Prints the numbers of all kinds of event and the hashes of a duel with six wands. The build links this
// program twice, with the object files of the wands in opposite order. Both programs must print the same.
#include <cstdio>

#include "game/bots/duel.h"
#include "tests/sixth_wand/assets.h"

int main() {
    using namespace thaum;
    const game::test::SixthWandAssets assets;
    const auto& kinds = game::event_kinds().kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        std::printf("%zu %s %zu\n", i, std::string(kinds[i].name).c_str(), kinds[i].cause_number);
    auto data = game::load_match_data(assets.path(), {});
    if (!data) return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;
    auto duel = game::make_bot_duel(assets.path(), std::make_shared<const game::MatchData>(std::move(*data)),
                                    {"level_3", "level_2"}, 11);
    if (!duel) return std::fprintf(stderr, "%s\n", duel.error().message.c_str()), 1;
    for (int second = 0; second < 12; ++second) {
        duel->run(1000);
        std::printf("%016llx %016llx\n", static_cast<unsigned long long>(duel->match->state_hash()),
                    static_cast<unsigned long long>(duel->match->force_hash()));
    }
    const auto& shots = duel->match->world().single<game::EventLog>().match_stats;
    const auto hail = game::cause_of(game::hit_kind("hail_hit"));
    std::printf("shots of hail %u\n", shots[0][hail].shots + shots[1][hail].shots);
    return shots[0][hail].shots + shots[1][hail].shots > 0 ? 0 : 1;
}
