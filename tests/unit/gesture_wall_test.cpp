// Tests of the gesture wall, where players of the practice range try and record gestures: a refused gesture,
// and strokes that the match does not recognise.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/wall_player.h"

namespace thaum::game {
namespace {

game::RangeFiles shipped_range() { return game::RangeFiles::open(THAUM_SOURCE_DIR "/assets", {}).value(); }

game::GestureWallPicture wall_of(Practice& practice) {
    auto picture = game::make_picture();
    game::take_picture(practice.match(), picture);
    practice.show(picture);
    return picture.practice.wall;
}

TEST(GestureWallOfTheRange, ARefusedGestureIsDrawnAgainAtOnce) {
    const auto range = shipped_range();
    Practice practice(range.data(), {input::DeviceSpec{}}, game::DummyKind::still, 1);
    WallPlayer player{practice};
    player.play(20);
    practice.wall().record("circle");
    for (int stroke = 0; stroke < 3; ++stroke) player.draw(800, triangle_on_wall);
    ASSERT_TRUE(practice.wall().take_recorded());
    // A fourth stroke, drawn before the three recorded ones are judged, must not count as one of them.
    player.draw(800, triangle_on_wall);
    EXPECT_EQ(wall_of(practice).lines[0].find("three strokes"), 0U);
    const auto before = &practice.match();
    practice.use_gestures({{}, {"not saved, since it is too like Star"}, Verdict::refused});
    EXPECT_EQ(&practice.match(), before);
    const auto lines = wall_of(practice).lines;
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], "not saved, since it is too like Star");
    EXPECT_EQ(lines[1], "try another shape: draw stroke 1 of 3");
    EXPECT_EQ(lines[2], "to give up: {pause}, then Give up drawing");
    EXPECT_TRUE(practice.wall().records());
    for (int stroke = 0; stroke < 3; ++stroke) {
        EXPECT_FALSE(practice.wall().take_recorded());
        player.draw(800, triangle_on_wall);
    }
    EXPECT_TRUE(practice.wall().take_recorded());
    practice.wall().give_up(practice.match());
    EXPECT_FALSE(practice.wall().records());
    EXPECT_EQ(wall_of(practice).lines[0], "given up: Circle is as it was before");
    practice.use_gestures({{}, {"not saved"}, Verdict::refused});
    EXPECT_FALSE(practice.wall().records()) << "who has given up is asked for nothing";
}

TEST(GestureWallOfTheRange, TheWallTellsAStrokeFromTheWrongEndAndOneLikeNone) {
    const auto range = shipped_range();
    Practice practice(range.data(), {input::DeviceSpec{}}, game::DummyKind::still, 1);
    WallPlayer player{practice};
    player.play(20);
    // Points of the game's S. The S is drawn first as the game has it, then from the other end.
    static std::vector<gesture::StrokePoint> ess;
    const auto& gestures = *range.data().match->gestures;
    ess = gestures.gestures()[*gestures.number("s")].strokes.front();
    const auto along_ess = [](int t) {
        const auto place = [](int at) {
            const double u = at / 1500.0 * static_cast<double>(ess.size() - 1);
            const auto i = std::min(static_cast<std::size_t>(u), ess.size() - 2);
            const vec3 at_u = glm::mix(ess[i].at, ess[i + 1].at, u - static_cast<double>(i));
            return vec2(std::round(1e4 * at_u.x), std::round(1e4 * at_u.y));
        };
        return place(t + 1) - place(t);
    };
    player.draw(1500, along_ess);
    auto wall = wall_of(practice);
    ASSERT_GE(wall.chosen, 0);
    EXPECT_GT(wall.scores[static_cast<std::size_t>(wall.chosen)], 0);
    std::reverse(ess.begin(), ess.end());
    player.play(3000);  // waits until the spell that was cast has ended
    player.draw(1500, along_ess);
    wall = wall_of(practice);
    ASSERT_GE(wall.lines.size(), 2U);
    EXPECT_LT(wall.scores[static_cast<std::size_t>(wall.chosen)], 0) << "a refused stroke has no score";
    EXPECT_EQ((*wall.gestures)[static_cast<std::size_t>(wall.chosen)].name, "S");
    EXPECT_EQ(wall.lines[0], "not read, but it has the shape of S");
    EXPECT_EQ(wall.lines[1], "draw it from the other end");
    player.draw(1200, [](int t) {
        const int zigzag = t / 120 % 2 == 0 ? 5 : -5;
        return vec2(zigzag, t % 2);
    });
    wall = wall_of(practice);
    EXPECT_EQ(wall.chosen, -1);
    EXPECT_EQ(wall.lines[0], "not read: it is like none of these");
    ASSERT_EQ(wall.lines.size(), 2U) << "the wall always says what to do";
    EXPECT_EQ(wall.lines[1], "follow a pale line to its end");
}

}  // namespace
}  // namespace thaum::game
