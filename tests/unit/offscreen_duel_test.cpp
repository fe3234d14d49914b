// Tests of duels without a window.
#include "game/app/offscreen_duel.h"

#include <unistd.h>

#include "core/file.h"
#include "game/match/playback.h"
#include "unit/game_duel.h"

namespace thaum::game {
namespace {

TEST(OffscreenDuelTest, TheLogGoesOnForHalfASecondAfterTheEndAsThatOfALiveMatch) {
    const TemporaryFolder out;
    testing::internal::CaptureStdout();
    const int code = play_offscreen_duel({.assets = game::test::assets(),
                                          .out = out.path(),
                                          .data = {.overrides = {"quick.kills=1", "bolt.shot.damage=100"}},
                                          .seed = 5,
                                          .bots = {"level_3", "level_3"}});
    const auto said = testing::internal::GetCapturedStdout();
    EXPECT_EQ(code, 0) << said;
    auto playback = game::Playback::open(out.path() / "duel.thaumlog", game::test::assets()).value();
    std::optional<Tick> over_at;
    while (playback.step()) {
        if (!over_at && playback.match().match().phase == game::Phase::over) over_at = playback.match().now();
    }
    ASSERT_TRUE(over_at) << said;
    EXPECT_EQ(playback.match().now(), *over_at + 500);
    EXPECT_FALSE(playback.divergence());
}

TEST(OffscreenDuelTest, ADuelThatIsNotOverEndsAtItsTime) {
    const TemporaryFolder out;
    testing::internal::CaptureStdout();
    const int code = play_offscreen_duel({.assets = game::test::assets(), .out = out.path(), .seconds = 0.5});
    const auto said = testing::internal::GetCapturedStdout();
    EXPECT_EQ(code, 0) << said;
    const auto playback = game::Playback::open(out.path() / "duel.thaumlog", game::test::assets()).value();
    EXPECT_EQ(playback.log().ticks(), 500U);
}

}  // namespace
}  // namespace thaum::game
