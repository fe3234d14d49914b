// Tests of how tactile frames reach an output, with a clock that the test sets, and of the thread that plays
// the frames. No test waits for a fixed time.
#include "input/tactile_playback.h"

#include <gtest/gtest.h>

#include <limits>

#include "input/tactile_player.h"
#include "unit/allocations.h"
#include "unit/felt_output_rig.h"

namespace thaum::input {
namespace {

using namespace rig;

constexpr double milli = 1e-3;  ///< one millisecond (s)

/// A playback with one output, which was opened at the time 1 s.
class TactilePlaybackTest : public testing::Test {
protected:
    TactilePlaybackTest() {
        playback_.use(std::make_unique<FakeOutput>(felt_));
        playback_.step(now_s_);
    }
    /// Lets time pass, with a step of the playback every 4 ms.
    void pass(double s) {
        for (const double until = now_s_ + s - 1e-9; now_s_ < until;) playback_.step(now_s_ += 4 * milli);
    }
    void feel(const tactile::TactileFrame& frame, double then_s) {
        playback_.feel(frame);
        pass(then_s);
    }
    std::size_t written() const { return felt_->frames.size(); }
    const tactile::TactileFrame& newest() const { return felt_->frames.back(); }

    std::shared_ptr<Felt> felt_ = std::make_shared<Felt>();
    TactilePlayback playback_;
    double now_s_ = 1;
};

TEST_F(TactilePlaybackTest, FramesReachTheOutputInTheirOrder) {
    EXPECT_EQ(playback_.status(), "fake plays");
    for (int i = 1; i <= 10; ++i) {
        feel(frame_of(0.1F * static_cast<float>(i), 0), 8 * milli);
        ASSERT_EQ(written(), i);
        EXPECT_EQ(newest().amplitude[0], 0.1F * static_cast<float>(i));
    }
    EXPECT_EQ(playback_.report().frames_sent, 10);
    EXPECT_EQ(felt_->silenced, 0);
}

TEST_F(TactilePlaybackTest, AnOutputWithoutANewerFrameIsSilentAfterTheTimeToLive) {
    for (const Tick life : {8U, 48U, 200U}) {
        feel(frame_of(1, 0, life), 4 * milli);
        ASSERT_TRUE(felt_->on);
        double on_s = 0;
        for (; felt_->on && on_s < 1; on_s += 4 * milli) pass(4 * milli);
        EXPECT_LE(on_s, static_cast<double>(life) * milli + 1e-9);
        EXPECT_GE(on_s, static_cast<double>(life) * milli - 8 * milli);
    }
    EXPECT_EQ(playback_.report().times_silenced, 3);
    // The output stays silent, and is silenced only once.
    pass(1);
    EXPECT_EQ(felt_->silenced, 3);
}

TEST_F(TactilePlaybackTest, ALieAboutTheTimeToLiveLeavesNoMotorOn) {
    feel(frame_of(1, 1, std::numeric_limits<Tick>::max()), TactilePlayback::longest_life_s + 4 * milli);
    EXPECT_FALSE(felt_->on);
    feel(frame_of(1, 1, 0), 4 * milli);
    EXPECT_EQ(written(), 1) << "a frame without life";
    EXPECT_EQ(playback_.report().frames_late, 1);
}

TEST_F(TactilePlaybackTest, ASilentFrameSilencesAtOnce) {
    feel(frame_of(1, 0), 4 * milli);
    feel(frame_of(0, 0), 4 * milli);
    EXPECT_FALSE(felt_->on);
    feel(frame_of(0, 0), 1);
    EXPECT_EQ(felt_->silenced, 1);
    EXPECT_EQ(playback_.report().times_silenced, 0) << "it was told to be silent";
}

TEST_F(TactilePlaybackTest, WaitingFramesAreMergedAndNoBlowIsLost) {
    auto blow = frame_of(0.9F, 0);
    blow.carrier_hz[0] = 60;
    playback_.feel(blow);
    playback_.feel(frame_of(0, 0.3F));
    feel(frame_of(0.2F, 0.1F), 4 * milli);
    ASSERT_EQ(written(), 1);
    EXPECT_EQ(newest().amplitude[0], 0.9F);
    EXPECT_EQ(newest().amplitude[1], 0.3F);
    EXPECT_EQ(newest().carrier_hz[0], 100) << "the newest carrier";
    EXPECT_EQ(playback_.report().frames_merged, 2);
    // The next frame is not merged with earlier ones.
    playback_.feel(frame_of(0.2F, 0.1F));
    pass(4 * milli);
    EXPECT_EQ(newest().amplitude[0], 0.2F);
}

TEST_F(TactilePlaybackTest, AnActuatorThatFellSilentInAMergedFrameKeepsItsCarrier) {
    auto blow = frame_of(0.9F, 0), silent = frame_of(0, 0);
    blow.carrier_hz[0] = 60;
    silent.carrier_hz[0] = 0;
    playback_.feel(blow);
    feel(silent, 4 * milli);
    ASSERT_EQ(written(), 1);
    EXPECT_EQ(newest().carrier_hz[0], 60);
}

TEST_F(TactilePlaybackTest, FramesThatWaitedWhileTheOutputHungAreDropped) {
    playback_.feel(frame_of(1, 0));
    playback_.step(now_s_ += 60 * milli);
    EXPECT_EQ(written(), 0);
    EXPECT_EQ(playback_.report().frames_late, 1);
    feel(frame_of(1, 0), 4 * milli);
    EXPECT_EQ(written(), 1);
}

TEST_F(TactilePlaybackTest, ATriedFrameLiesOverThoseOfAPausedMatch) {
    playback_.try_out(frame_of(0.5F, 0, 48));
    pass(4 * milli);
    ASSERT_EQ(written(), 1);
    EXPECT_EQ(newest().amplitude[0], 0.5F);
    for (int i = 0; i < 10; ++i) {
        if (i == 5) playback_.try_out(frame_of(0.7F, 0, 48));
        feel(frame_of(0, 0.2F), 4 * milli);
        EXPECT_EQ(newest().amplitude[0], i < 5 ? 0.5F : 0.7F);
        EXPECT_EQ(newest().amplitude[1], 0.2F) << "the match is felt, too";
    }
    feel(frame_of(0, 0.2F, 400), 60 * milli);
    feel(frame_of(0, 0.2F), 4 * milli);
    EXPECT_EQ(newest().amplitude[0], 0) << "the trial is over after its time to live";
}

TEST_F(TactilePlaybackTest, ATriedFrameAloneEndsByItself) {
    playback_.try_out(frame_of(1, 0, 48));
    pass(4 * milli);
    ASSERT_TRUE(felt_->on);
    pass(60 * milli);
    EXPECT_FALSE(felt_->on);
}

TEST_F(TactilePlaybackTest, ALostOutputIsOpenedAgainAndPlays) {
    feel(frame_of(1, 0), 3);
    felt_->connected = false;
    felt_->present = false;
    feel(frame_of(1, 0), 8 * milli);
    EXPECT_EQ(playback_.status(), "fake: it is not there");
    EXPECT_EQ(felt_->closed, 1);
    EXPECT_FALSE(felt_->on);
    const int tries = felt_->opened;
    for (int i = 0; i < 100; ++i) playback_.feel(frame_of(1, 0));
    pass(2 * TactilePlayback::retry_s);
    EXPECT_NEAR(felt_->opened - tries, 2, 1) << "a try every 2 s";
    felt_->present = true;
    pass(TactilePlayback::retry_s);
    EXPECT_EQ(playback_.status(), "fake plays");
    EXPECT_EQ(written(), 1) << "frames for a lost output are not played later";
    feel(frame_of(0, 1), 4 * milli);
    EXPECT_EQ(newest().amplitude[1], 1);
    const auto report = playback_.report();
    EXPECT_EQ(report.times_opened, 2);
    EXPECT_EQ(report.times_lost, 1);
    EXPECT_EQ(report.frames_lost, 101);
}

/// An output that checks its playback while it plays the first frame.
class LookingOutput final : public FakeOutput {
public:
    LookingOutput(const TactilePlayback& playback, std::uint64_t& times_opened)
        : FakeOutput(std::make_shared<Felt>()), playback_(playback), times_opened_(times_opened) {}
    void write(const tactile::TactileFrame&, double) override {
        EXPECT_EQ(playback_.status(), "fake plays");
        times_opened_ = playback_.report().times_opened;
    }

private:
    const TactilePlayback& playback_;
    std::uint64_t& times_opened_;
};

TEST(TactilePlayback, AStateIsNotToldBeforeItsCounts) {
    std::uint64_t times_opened = 0;
    TactilePlayback playback;
    playback.use(std::make_unique<LookingOutput>(playback, times_opened));
    playback.try_out(frame_of(1, 0));
    playback.step(1);
    EXPECT_EQ(times_opened, 1U);
}

TEST_F(TactilePlaybackTest, AnOutputThatFailsAfterEachOpeningIsNotOpenedAllTheTime) {
    const int before = felt_->opened;
    for (int i = 0; i < 1000; ++i) {
        felt_->connected = false;
        pass(4 * milli);
    }
    EXPECT_LE(felt_->opened - before, 3) << "in 4 s";
}

TEST_F(TactilePlaybackTest, AnotherOutputTakesOverAndTheFormerIsClosed) {
    feel(frame_of(1, 0), 4 * milli);
    const auto other = std::make_shared<Felt>();
    playback_.use(std::make_unique<FakeOutput>(other));
    pass(4 * milli);
    EXPECT_FALSE(felt_->on);
    EXPECT_EQ(felt_->closed, 1);
    feel(frame_of(1, 0), 4 * milli);
    EXPECT_EQ(other->frames.size(), 1);
    EXPECT_EQ(written(), 1);
    playback_.use(nullptr);
    pass(4 * milli);
    EXPECT_FALSE(other->on);
    EXPECT_EQ(playback_.status(), "");
    feel(frame_of(1, 0), 1);
}

TEST_F(TactilePlaybackTest, ManyFramesDoNotAllocate) {
    felt_->frames.reserve(1000);
    pass(1);
    const auto before = test::allocations();
    for (int i = 0; i < 500; ++i) {
        feel(frame_of(0.5F, 0.25F), 8 * milli);
    }
    EXPECT_EQ(test::allocations(), before);
    EXPECT_EQ(written(), 500);
}

// The thread that plays tactile frames ----------------------------------------------------------------------

TEST(TactilePlayerThreads, PlaysAndLeavesTheOutputClosed) {
    const auto felt = std::make_shared<Felt>();
    {
        TactilePlayer player;
        player.use(std::make_unique<FakeOutput>(felt));
        felt->wait([&] { return felt->opened == 1; });
        for (std::size_t i = 1; i <= 5; ++i) {
            // On a busy machine a frame may be late and dropped. Then another one is sent.
            for (bool taken = false; !taken;) {
                player.feel(frame_of(1, 0, 500));
                std::this_thread::yield();
                taken = felt->with([&] { return felt->frames.size() >= i; });
            }
        }
        EXPECT_EQ(player.status(), "fake plays");
    }
    EXPECT_EQ(felt->closed, 1);
    EXPECT_FALSE(felt->on);
}

TEST(TactilePlayerThreads, AProgramThatHangsLeavesNoMotorOn) {
    const auto felt = std::make_shared<Felt>();
    TactilePlayer player;
    player.use(std::make_unique<FakeOutput>(felt));
    while (!felt->with([&] { return felt->on; })) player.feel(frame_of(1, 0, 100));
    felt->wait([&] { return !felt->on; });
    EXPECT_GE(felt->with([&] { return felt->silenced; }), 1);
}

TEST(TactilePlayerThreads, ABlockedOutputDoesNotHoldTheEndUp) {
    for (const bool in_open : {true, false}) {
        const auto felt = std::make_shared<Felt>();
        felt->hangs = in_open;
        {
            TactilePlayer player(0);
            player.use(std::make_unique<FakeOutput>(felt));
            if (!in_open) {
                felt->wait([&] { return felt->opened == 1; });
                felt->with([&] { felt->hangs = true; });
            }
            while (!felt->with([&] { return felt->in_hang; })) player.feel(frame_of(1, 0, 500));
            // The simulation thread does not wait either: the queue fills up instead.
            while (player.feel(frame_of(1, 0))) {}
        }
        // The thread ends when the hanging call returns, without another call.
        const auto opened = felt->with([&] { return felt->opened; });
        felt->with([&] { felt->hangs = false; });
        felt->wait([&] { return felt->frames.size() == 1 || felt->opened > opened; });
    }
}

}  // namespace
}  // namespace thaum::input
