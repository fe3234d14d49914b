// Tests of pictures taken from a replay: they show captions of what players hear and feel, as the live view
// does.
#include "game/app/shots.h"

#include "core/file.h"
#include "core/text.h"
#include "game/settings/recorded_names.h"
#include "unit/read_png.h"
#include "unit/replay_rig.h"

namespace thaum::game {
namespace {

/// Number of pixels that differ within a part of two pictures of equal size. The part is given in shares of
/// width and height.
std::size_t differing(const render::Image& a, const render::Image& b, fvec2 low, fvec2 high) {
    std::size_t count = 0;
    const auto pixel = [](float share, int size) {
        return static_cast<int>(share * static_cast<float>(size));
    };
    for (int y = pixel(low.y, a.height); y < pixel(high.y, a.height); ++y) {
        for (int x = pixel(low.x, a.width); x < pixel(high.x, a.width); ++x) {
            const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                 static_cast<std::size_t>(x));
            count += std::equal(a.rgb.begin() + static_cast<std::ptrdiff_t>(at),
                                a.rgb.begin() + static_cast<std::ptrdiff_t>(at + 3),
                                b.rgb.begin() + static_cast<std::ptrdiff_t>(at))
                         ? 0U
                         : 1U;
        }
    }
    return count;
}

TEST(ShotsTest, APictureShowsTheWordsAndTheFigureOfTheLiveView) {
    const game::test::RecordedDuel recorded("shots.thaumlog", 12000);
    auto playback = recorded.opened();
    const TemporaryFolder folder;
    ShotPlan plan{.folder = folder.path(), .size = {640, 360}};
    plan.on.at(static_cast<std::size_t>(game::hit_kind("bolt_hit"))) = true;
    const auto assets = game::test::assets();
    auto shots = Shots::create(plan, playback.match().data(), assets);
    ASSERT_TRUE(shots) << shots.error().message;
    while (shots->taken() == 0 && playback.step()) ASSERT_TRUE(shots->follow(playback));
    ASSERT_EQ(shots->taken(), 1U) << "nobody is hit";
    const auto hit = playback.match().now();
    for (Tick t = 0; t < 16; ++t) playback.step();
    // The captions in a picture are those of earlier ticks: the picture of the hit itself does not have the
    // hit's caption yet, the picture 16 ms later has it.
    shots = Shots::create({.folder = folder.path(), .at = {hit + 16}, .size = {640, 360}},
                          playback.match().data(), assets);
    ASSERT_TRUE(shots) << shots.error().message;
    playback = recorded.opened();
    while (shots->taken() == 0 && playback.step()) ASSERT_TRUE(shots->follow(playback));
    const auto file = folder.path() / text("shot_0000", hit + 16, ".png");
    const auto shown = render::read_png(file);
    ASSERT_TRUE(shown) << file;
    auto still = Still::create(playback.match().data(), assets, {640, 360}).value();
    const auto plain = still.draw(playback.match(), {.names = recorded_names(playback.log().header())});
    const auto words = differing(*shown, plain, {0, 0}, {0.35F, 1});
    const auto figure = differing(*shown, plain, {0.65F, 0}, {1, 1});
    EXPECT_GT(words, 100U) << "words at the left of a view";
    EXPECT_GT(figure, 100U) << "the figure at the right of a view";
}

}  // namespace
}  // namespace thaum::game
