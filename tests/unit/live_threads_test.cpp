// Tests of a session's main thread together with its simulation thread, without a window. The main thread
// waits until the simulation thread wakes it.
#include <gtest/gtest.h>

#include <semaphore>
#include <thread>

#include "game/live/session.h"
#include "game/match/playback.h"
#include "game/match/record.h"
#include "unit/live_rig.h"

namespace thaum::game {
namespace {

class LiveThreadsTest : public testing::Test {
protected:
    LiveThreadsTest() {
        plan_.data = std::make_shared<const game::MatchData>(
            game::load_match_data(THAUM_SOURCE_DIR "/assets", {}).value());
        plan_.assets = THAUM_SOURCE_DIR "/assets";
        plan_.seats = {rig::mouse_seat, rig::first_pad_seat};
        shared_.ready = true;
        session_.emplace(shared_, plan_);
    }

    /// Ends the match even if a test has failed.
    ~LiveThreadsTest() override { shared_.stop = true; }

    void start_match(Recording recording, const std::string& fault = {}) {
        session_->take_seats(pads_);
        MatchStart first{.data = plan_.data, .recording = std::move(recording), .fault = fault};
        simulating_ = std::jthread([this, start = std::move(first)]() mutable {
            run_simulation(plan_, shared_, std::move(start), [this] { woken_.release(); });
        });
        session_->begin_match(pads_);
    }
    void end_match() {
        shared_.requests.end = true;
        simulating_.join();
    }
    /// Waits until the match reaches a state. Returns false after a time that is exceeded only by a hang.
    bool becomes(PlayState state) {
        while (shared_.progress.state != state) {
            if (!woken_.try_acquire_for(std::chrono::seconds(600))) return false;
        }
        session_->step_match(pads_, monotonic_ns());
        return true;
    }
    void press(std::string_view name) {
        session_->key(rig::key(name), true, monotonic_ns());
        session_->key(rig::key(name), false, monotonic_ns());
    }
    void step(Pads pads) {
        pads_ = std::move(pads);
        session_->step_match(pads_, monotonic_ns());
    }

    LivePlan plan_;
    LiveShared shared_;
    std::optional<LiveSession> session_;
    Pads pads_{rig::pad_with()};
    std::counting_semaphore<> woken_{0};
    std::jthread simulating_{};  ///< last member, so that the thread ends while the other members still exist
};

TEST_F(LiveThreadsTest, AMatchPausesGoesOnAndEndsAndItsLogReplays) {
    const rig::TestPath file("match.thaumlog");
    const auto seats = take_seats(plan_.settings, planned_seats(plan_.seats, pads_));
    const game::MatchSetup setup{1, devices_of(seats, {})};
    auto recording =
        record_match({.named = file.path}, 1, game::log_header(*plan_.data, setup, {"human", "human"}))
            .value();
    start_match(std::move(recording));
    press("escape");
    ASSERT_TRUE(becomes(PlayState::paused));
    EXPECT_EQ(session_->menu().picture().line, "by Ember");
    press("escape");
    step({rig::pad_with()});
    ASSERT_TRUE(becomes(PlayState::playing)) << "a request that follows the pause at once";
    EXPECT_FALSE(session_->menu().is_open());
    step({});
    ASSERT_TRUE(becomes(PlayState::paused));
    EXPECT_EQ(session_->menu().picture().title, pause_words({.lost_pad = {std::nullopt, 0}}).head);
    step({rig::pad_with({input::PadButton::a})});
    ASSERT_TRUE(becomes(PlayState::playing));
    end_match();
    EXPECT_TRUE(shared_.progress.ended);
    EXPECT_FALSE(shared_.stop) << "the session may go on";
    auto replay = game::Playback::open(file.path, plan_.assets).value();
    while (replay.step()) EXPECT_FALSE(replay.divergence());
    EXPECT_GT(replay.match().now(), 0U);
    EXPECT_EQ(replay.missing_hashes(), "");
}

TEST_F(LiveThreadsTest, WhileAForceIsSoughtTheWholeForceComesOut) {
    plan_.settings.players[0].force = 0;  // player 1 wants no forces
    plan_.seats = {rig::mouse_seat, live::Seat{.kind = SeatKind::dummy}};
    plan_.practice = game::DummyKind::still;
    session_.emplace(shared_, plan_);
    ASSERT_TRUE(session_->next().open_range());
    start_match(std::move(*session_->next().take_range()));
    while (!shared_.pictures.take() || shared_.pictures.newest().tick == 0) std::this_thread::yield();
    shared_.requests.ask(FindForce{});
    const auto& shown = shared_.pictures;
    double most = 0;
    for (bool words = false; !words || most < 0.5;) {
        if (!shared_.pictures.take()) {
            std::this_thread::yield();
            continue;
        }
        const auto& wizard = shown.newest().wizards[0];
        words = words || shown.newest().caption.words.find("kick of") != std::string::npos;
        for (const auto felt : wizard.senses.force.strongest)
            most = std::max(most, static_cast<double>(felt));
    }
    end_match();
}

TEST_F(LiveThreadsTest, AFaultOfTheSettingsFileIsShownAtTheStartOfAMatch) {
    start_match({}, "settings.toml, line 2: defaults replace wrong values");
    press("escape");
    ASSERT_TRUE(becomes(PlayState::paused));
    end_match();
    ASSERT_TRUE(shared_.pictures.take());
    const auto& caption = shared_.pictures.newest().caption;
    EXPECT_EQ(caption.words, "settings.toml, line 2: defaults replace wrong values");
    EXPECT_TRUE(caption.fault);
    EXPECT_TRUE(shows_fault("a fault", ticks(9.9)));
    EXPECT_FALSE(shows_fault("a fault", ticks(10.1))) << "not for ever";
    EXPECT_FALSE(shows_fault("", 0));
}

/// A round of one second ends in a draw. Its result is shown for eight seconds.
TEST_F(LiveThreadsTest, ADemoEndsAMatchByItselfForTheNextOne) {
    plan_.data = std::make_shared<const game::MatchData>(
        game::load_match_data(THAUM_SOURCE_DIR "/assets",
                              {.overrides = {"quick.seconds=1", "quick.boil_over.seconds=0"}})
            .value());
    plan_.seats = {rig::bot_seat, rig::bot_seat};
    plan_.demo = true;
    session_.emplace(shared_, plan_);
    start_match({});
    simulating_.join();
    EXPECT_TRUE(shared_.progress.ended);
    EXPECT_TRUE(shared_.requests.rematch);
    EXPECT_GE(shared_.report.ticks, ticks(9.0));
    EXPECT_FALSE(shared_.stop);
}

}  // namespace
}  // namespace thaum::game
