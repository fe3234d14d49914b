#include "ecs/snapshot.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

std::uint64_t events_of(const Simulation& match) { return match.world().single<Chronicle>().count; }

TEST(GameMatch, TwoBotsFindEachOtherAndFightToTheEnd) {
    auto duel = make_duel(1);
    for (int s = 0; s < 245 && duel.match->match().phase == Phase::playing; ++s) duel.run(1000);
    EXPECT_EQ(duel.match->match().phase, Phase::over);
    std::uint32_t shots = 0;
    duel.match->world().view<const WandBelt>().each([&](const WandBelt& belt) { shots += belt.fired; });
    EXPECT_GT(shots, 50U);
    EXPECT_GT(events_of(*duel.match), 50U);
}

TEST(GameMatch, TheSameSeedGivesTheSameMatchAndAnotherSeedAnother) {
    auto a = make_duel(7), b = make_duel(7), c = make_duel(8);
    a.run(10000);
    b.run(10000);
    c.run(10000);
    EXPECT_EQ(a.match->state_hash(), b.match->state_hash());
    EXPECT_NE(a.match->state_hash(), c.match->state_hash());
}

TEST(GameMatch, TheArenaIsWhatTheDesignSays) {
    const auto data = duel_data();
    std::size_t props = 0;
    for (const auto& thing : data->arena.things) props += thing.prop ? 1U : 0U;
    EXPECT_EQ(props, 14U);
    EXPECT_EQ(data->arena.anchors.size(), 8U);
    EXPECT_EQ(data->arena.pads.size(), 4U);
    double total = 0;
    for (const auto& thing : data->arena.things) total += thing.position.z;
    EXPECT_EQ(total, 0.0) << "the court is not mirror-symmetric";
}

TEST(GameMatch, AnOverrideReplacesAValueAndAWrongOneIsOneClearLine) {
    EXPECT_EQ(duel_data({"quick.kills=7"})->round.kills, 7);
    const auto message = [](std::string override_text) {
        DataChoice choice;
        choice.overrides = {std::move(override_text)};
        const auto data = load_match_data(assets(), choice);
        return data ? std::string("accepted") : data.error().message;
    };
    EXPECT_NE(message("quick.kils=7").find("rules/quick.toml: has no key 'kils'"), std::string::npos);
    EXPECT_NE(message("quick.kills=0").find("'kills' is 0"), std::string::npos);
    EXPECT_NE(message("nothing.kills=3").find("--set nothing.kills=3"), std::string::npos);
    EXPECT_NE(message("quick.kills=[").find("no value"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test
