// Tests of what keys and mouse do during a replay, without window, threads and clock.
#include "game/live/replay_view.h"

#include "game/hud/layout.h"
#include "game/hud/overlay.h"

#include "unit/live_rig.h"
#include "unit/overlay_items.h"
#include "unit/replay_rig.h"

namespace thaum::game {
namespace {

using game::Kill;
using game::Watch;

constexpr Tick replay_length = 60'000;
const std::vector<Kill> kills{{1500, 0, 1}, {20'000, 1, 0}, {40'000, 0, 0}};

ReplayView after(ReplayView view, std::initializer_list<std::string_view> pressed) {
    for (const auto name : pressed) {
        const auto deed = replay_deed_of(rig::key(name));
        EXPECT_TRUE(deed) << name;
        if (deed) view = after(view, *deed, replay_length, kills);
    }
    return view;
}

TEST(ReplayView, SpacePausesAndGoesOnAndStartsAgainAtTheEnd) {
    EXPECT_TRUE(after({.at = 100}, {"space"}).paused);
    EXPECT_FALSE(after({.at = 100}, {"space", "space"}).paused);
    EXPECT_EQ(after({.at = 100}, {"space"}).at, 100U);
    EXPECT_EQ(after({.at = replay_length}, {"space"}), ReplayView{});
    EXPECT_EQ(after({.at = replay_length, .paused = true}, {"space"}), ReplayView{});
}

TEST(ReplayView, ArrowsJumpWithinTheReplay) {
    EXPECT_EQ(after({.at = 20'000}, {"right"}).at, 25'000U);
    EXPECT_EQ(after({.at = 20'000}, {"left"}).at, 15'000U);
    EXPECT_EQ(after({.at = 20'000}, {"right", "right", "left"}).at, 25'000U);
    EXPECT_EQ(after({.at = 3000}, {"left"}).at, 0U);
    EXPECT_EQ(after({.at = replay_length - 1}, {"right"}).at, replay_length);
    EXPECT_EQ(after({.at = 3000}, {"home"}).at, 0U);
    EXPECT_EQ(after({.at = 3000}, {"end"}).at, replay_length);
    EXPECT_TRUE(after({.at = 3000, .paused = true}, {"right", "end", "home"}).paused)
        << "a jump does not go on";
}

TEST(ReplayView, ArrowsChangeTheSpeedWithinItsBounds) {
    EXPECT_EQ(after({}, {"up"}).speed, 2);
    EXPECT_EQ(after({}, {"up", "up", "up"}).speed, 8);
    EXPECT_EQ(after({}, {"up", "up", "up", "up", "up", "up"}).speed, fastest_replay);
    EXPECT_EQ(after({}, {"down", "down", "down", "down"}).speed, slowest_replay);
    EXPECT_EQ(after({.speed = 3}, {"up"}).speed, 4) << "from a speed of the command line";
    EXPECT_EQ(after({.speed = 3}, {"down"}).speed, 2);
}

TEST(ReplayView, PagesGoToKillsAndABitBeforeThem) {
    EXPECT_EQ(after({}, {"page_down"}).at, 18'000U)
        << "the first kill is not ahead: it is seen from the start";
    EXPECT_EQ(after({}, {"page_down", "page_down"}).at, 38'000U);
    EXPECT_EQ(after({.at = 50'000}, {"page_down"}).at, 50'000U) << "no kill is ahead";
    EXPECT_EQ(after({.at = 50'000}, {"page_up"}).at, 38'000U);
    EXPECT_EQ(after({.at = 38'500}, {"page_up"}).at, 18'000U) << "just there, so the one before";
    EXPECT_EQ(after({.at = 10'000}, {"page_up"}).at, 0U);
    EXPECT_EQ(after({.at = 500}, {"page_up"}).at, 500U);
}

TEST(ReplayView, StepsPause) {
    EXPECT_EQ(after({.at = 100}, {"period"}), (ReplayView{.at = 100 + replay_step, .paused = true}));
    EXPECT_EQ(after({.at = 100}, {"comma"}), (ReplayView{.at = 100 - replay_step, .paused = true}));
    EXPECT_EQ(after({.at = 3}, {"comma"}).at, 0U);
    EXPECT_EQ(after({.at = replay_length}, {"period"}).at, replay_length);
}

TEST(ReplayView, TheEyesCycle) {
    EXPECT_EQ(after({}, {"v"}).watch, Watch::first);
    EXPECT_EQ(after({}, {"v", "v"}).watch, Watch::second);
    EXPECT_EQ(after({}, {"v", "v", "v"}).watch, Watch::both);
}

TEST(ReplayView, OtherKeysDoNothing) {
    EXPECT_LE(game::width_of(replay_keys(), 1), game::replay_keys_wide) << "the bar has room for them";
    EXPECT_FALSE(replay_deed_of(rig::key("w")));
    EXPECT_FALSE(replay_deed_of(-1));
}

TEST(ReplayView, NoKeyIsPartedFromItsWordsAtAnySizeOfText) {
    for (const render::Size window : {render::Size{640, 480}, {1280, 720}, {1920, 1080}, {400, 300}}) {
        for (const double scale : {1.0, 1.5, 2.0, 2.5}) {
            const auto bar = game::lay_out_replay_bar(scale, window);
            render::Overlay overlay;
            game::add_replay_bar(
                overlay, {.length = 1000, .eyes = "both views", .keys = replay_keys(), .kills = {}}, 0, bar);
            std::string all;
            for (const auto* line : game::hud_tests::items_of<render::TextItem>(overlay)) {
                if (line->position.y < bar.keys.low.y - 1) continue;
                if (line->colour != game::paints.soft) continue;  // skips the text's shadow
                all += text(all.empty() ? "" : "   ", line->text);
            }
            EXPECT_EQ(all, replay_keys()) << window.width << ", " << scale;
        }
    }
}

TEST(ReplayView, EveryLengthHasPlaces) {
    for (const auto deed :
         {ReplayDeed::pause, ReplayDeed::back, ReplayDeed::forward, ReplayDeed::end, ReplayDeed::next_kill,
          ReplayDeed::previous_kill, ReplayDeed::step, ReplayDeed::step_back})
        EXPECT_EQ(after({}, deed, 0, {}).at, 0U);
}

// ---- the viewer of a replay -------------------------------------------------------------------------------

class ReplayViewerTest : public testing::Test {
protected:
    static constexpr Tick ticks = 3000;

    void press(std::string_view name) { viewer_.key(rig::key(name)); }
    fvec2 on_track(float share) const {
        const auto& track = layout_.track;
        return {track.low.x + share * (track.high.x - track.low.x), (track.low.y + track.high.y) / 2};
    }
    void cursor(fvec2 place) { viewer_.cursor(place, rig::window, 1); }
    void button(bool pressed, int which = 0) { viewer_.mouse_button(which, pressed, rig::window, 1); }
    Tick taken() { return requests_.target.exchange(ReplayRequests::nowhere); }

    game::test::RecordedDuel duel_{"viewer.thaumlog", ticks};
    game::Playback playback_ = duel_.opened();
    game::ReplayIndex index_{playback_};
    ReplayRequests requests_{};
    ReplayViewer viewer_{index_, ticks, requests_};
    const game::ReplayBarLayout layout_ = game::lay_out_replay_bar(1, rig::window);
};

TEST_F(ReplayViewerTest, KeysStartFromThePlaceThatTheReplayIsOnItsWayTo) {
    requests_.now = 2900;
    press("comma");
    press("comma");
    EXPECT_EQ(taken(), 2900 - 2 * replay_step);
    press("home");
    press("period");
    EXPECT_EQ(requests_.target, replay_step);
    EXPECT_TRUE(requests_.paused);
}

TEST_F(ReplayViewerTest, PauseSpeedAndEyesAskForNoPlace) {
    requests_.now = 100;
    for (const auto* key : {"space", "up", "v", "w"}) press(key);
    EXPECT_EQ(requests_.target, ReplayRequests::nowhere);
    EXPECT_TRUE(requests_.paused);
    EXPECT_EQ(requests_.speed, 2);
    EXPECT_EQ(viewer_.watch(), Watch::first);
    EXPECT_EQ(viewer_.bar().eyes, "Ember's eyes");
    EXPECT_EQ(viewer_.bar().speed, 2);
    EXPECT_FALSE(viewer_.bar().target);
}

TEST_F(ReplayViewerTest, APressOnTheBarGoesThereAndDraggingFollows) {
    cursor(on_track(0.5F));
    EXPECT_EQ(requests_.target, ReplayRequests::nowhere) << "no button is held";
    button(true);
    EXPECT_NEAR(static_cast<double>(taken()), 0.5 * ticks, 3);
    cursor(on_track(0.25F));
    EXPECT_NEAR(static_cast<double>(taken()), 0.25 * ticks, 3);
    cursor({-50, 0});
    EXPECT_EQ(taken(), 0U) << "above and beside the bar a drag goes on";
    cursor({5000, 0});
    EXPECT_EQ(taken(), ticks);
    button(false);
    cursor(on_track(0.75F));
    EXPECT_EQ(requests_.target, ReplayRequests::nowhere);
}

TEST_F(ReplayViewerTest, APressElsewhereOrOfAnotherButtonDoesNothing) {
    cursor({640, 300});
    button(true);
    cursor(on_track(0.5F));
    button(false);
    button(true, 1);
    EXPECT_EQ(requests_.target, ReplayRequests::nowhere);
}

TEST_F(ReplayViewerTest, TheBarShowsHowFarTheIndexIs) {
    EXPECT_EQ(viewer_.bar().indexed, 0U);
    index_.fill(duel_.opened(), game::test::never);
    EXPECT_EQ(viewer_.bar().indexed, ticks);
    EXPECT_EQ(viewer_.bar().length, ticks);
    requests_.target = 2000;
    EXPECT_EQ(viewer_.bar().target, 2000U);
}

}  // namespace
}  // namespace thaum::game
