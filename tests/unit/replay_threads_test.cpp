// Tests of showing a replay with its threads, without a window: the main thread, the thread that plays, and
// the thread that fills the index (states from which jumps continue).
#include <thread>

#include "game/live/replay.h"
#include "game/live/session.h"
#include "unit/live_rig.h"
#include "unit/replay_rig.h"

namespace thaum::game {
namespace {

using game::test::RecordedDuel;

constexpr Tick threads_length = 3 * keyframe_interval + 300;

class ReplayThreads : public testing::Test {
protected:
    ReplayThreads() { shared_.ready = true; }
    ~ReplayThreads() override {
        shared_.stop = true;
        if (playing_.joinable()) playing_.join();
        stop_filling_ = true;
    }

    void begin(bool with_index, Tick start = 0) {
        shown_.emplace(ShownReplay{playback_, index_, start});
        plan_.data = std::make_shared<const game::MatchData>(playback_.match().data());
        plan_.assets = THAUM_SOURCE_DIR "/assets";
        plan_.replay = &*shown_;
        session_.emplace(shared_, plan_);
        if (with_index)
            filling_ = std::jthread([this] { index_.fill(duel_.opened(), stop_filling_); });
        else
            index_.give_up();
        playing_ = std::jthread([this] { run_replay(plan_, shared_, [] {}); });
    }
    void press(std::string_view name) {
        session_->key(rig::key(name), true, monotonic_ns());
        session_->key(rig::key(name), false, monotonic_ns());
    }
    /// Waits for a condition. Returns false after a time that is exceeded only by a hang.
    template <class F>
    bool becomes(F f) {
        const auto until = monotonic_ns() + 60'000 * rig::ms;
        while (!f() && monotonic_ns() < until) {
            session_->publish_screen();
            sleep_until_ns(monotonic_ns() + 2 * rig::ms);
        }
        return f();
    }
    bool is_at(Tick tick) {
        return becomes(
            [&] { return shared_.replay.target == ReplayRequests::nowhere && shared_.replay.now == tick; });
    }
    const game::Picture& picture() {
        shared_.pictures.take();
        return shared_.pictures.newest();
    }

    const RecordedDuel duel_{"threads.thaumlog", threads_length};
    game::Playback playback_ = duel_.opened();
    game::ReplayIndex index_{playback_};
    std::optional<ShownReplay> shown_{};
    LivePlan plan_{};
    LiveShared shared_{};
    std::optional<LiveSession> session_{};
    std::atomic<bool> stop_filling_{false};
    std::jthread filling_{}, playing_{};
};

TEST_F(ReplayThreads, KeysMoveThroughTheReplayWhileItsIndexIsFilled) {
    begin(true);
    press("space");
    press("end");
    ASSERT_TRUE(is_at(threads_length));
    EXPECT_FALSE(shared_.stop) << "the end waits";
    EXPECT_EQ(picture().caption.words, "The recording ends here.");
    press("home");
    ASSERT_TRUE(is_at(0));
    EXPECT_EQ(picture().caption.words, "");
    press("right");
    ASSERT_TRUE(is_at(replay_jump));
    press("comma");
    ASSERT_TRUE(is_at(replay_jump - replay_step));
    press("space");
    ASSERT_TRUE(becomes([&] { return shared_.replay.now > replay_jump; })) << "it does not go on";
    press("up");
    ASSERT_TRUE(is_at(threads_length)) << "it plays to the end";
    EXPECT_FALSE(shared_.stop);
    press("space");
    ASSERT_TRUE(becomes([&] { return shared_.replay.now < replay_jump; })) << "it does not start again";
    press("escape");
    playing_.join();
    EXPECT_TRUE(shared_.progress.ended);
    EXPECT_FALSE(playback_.divergence());
}

TEST_F(ReplayThreads, WithoutAnIndexJumpsAheadArriveAsWell) {
    begin(false, 2500);
    press("space");
    ASSERT_TRUE(is_at(2500)) << "the plan's start";
    press("end");
    ASSERT_TRUE(is_at(threads_length));
    press("left");
    ASSERT_TRUE(is_at(threads_length - replay_jump));
    press("escape");
    playing_.join();
    EXPECT_EQ(playback_.match().state_hash(), duel_.hashes[threads_length - replay_jump]);
}

TEST_F(ReplayThreads, WaitsForAnIndexThatHasNotComeSoFar) {
    shown_.emplace(ShownReplay{playback_, index_});
    plan_.data = std::make_shared<const game::MatchData>(playback_.match().data());
    plan_.assets = THAUM_SOURCE_DIR "/assets";
    plan_.replay = &*shown_;
    session_.emplace(shared_, plan_);
    playing_ = std::jthread([this] { run_replay(plan_, shared_, [] {}); });
    press("space");
    press("end");
    sleep_until_ns(monotonic_ns() + 50 * rig::ms);
    EXPECT_LT(shared_.replay.now, threads_length);
    press("home");
    ASSERT_TRUE(is_at(0)) << "another wish must end the wait";
    press("end");
    index_.fill(duel_.opened(), stop_filling_);
    ASSERT_TRUE(is_at(threads_length));
}

}  // namespace
}  // namespace thaum::game
