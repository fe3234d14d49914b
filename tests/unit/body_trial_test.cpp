// Tests of the effects that players can try on the menu page with the body's faders: which cells of the body
// figure (a drawing of the body) light up, the faders, and the end.
#include "game/live/body_trial.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thaum::game {
namespace {

constexpr std::int64_t ms = 1'000'000;

class BodyTrialTest : public testing::Test {
protected:
    BodyTrialTest() { body_.emplace(LiveBody::load(THAUM_SOURCE_DIR "/assets").value()); }

    /// Plays a tried effect to its end. Returns the strongest value of each cell of the body figure, and the
    /// effect's length (ms).
    std::pair<BodyTrial::Figure, std::int64_t> played(tactile::Purpose purpose, double share) {
        tactile::Faders faders;
        faders.of(purpose) = share;
        BodyTrial trial(*body_, outputs_);
        EXPECT_TRUE(trial.start(0, purpose, faders, 7 * ms));
        EXPECT_TRUE(trial.runs());
        BodyTrial::Figure most = trial.figure();
        std::int64_t at = 0;
        for (; trial.runs() && at < 10'000; at += 3) {
            trial.step((7 + at) * ms);
            for (std::size_t i = 0; i < most.size(); ++i)
                most.at(i) = std::max(most.at(i), trial.figure().at(i));
        }
        EXPECT_EQ(trial.figure(), BodyTrial::Figure{}) << "nothing stays on";
        return {most, at};
    }

    std::optional<LiveBody> body_;
    LiveTactile outputs_{[](const input::PadState&) { return nullptr; }};
};

TEST_F(BodyTrialTest, EveryPurposeWithAnEffectCanBeFeltAndEnds) {
    const auto purposes = body_->purposes();
    EXPECT_GE(purposes.size(), 7U);
    for (const auto purpose : purposes) {
        const auto [most, length] = played(purpose, 1);
        EXPECT_GT(*std::max_element(most.begin(), most.end()), 0.03F) << static_cast<int>(purpose);
        EXPECT_LT(length, 5100) << static_cast<int>(purpose);
    }
}

TEST_F(BodyTrialTest, TheFaderScalesWhatIsFelt) {
    const auto whole = played(tactile::Purpose::impact, 1).first,
               half = played(tactile::Purpose::impact, 0.5).first;
    const auto none = played(tactile::Purpose::impact, 0).first;
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(half.at(i), 0.5F * whole.at(i), 0.02F) << i;
    EXPECT_EQ(none, BodyTrial::Figure{});
}

TEST_F(BodyTrialTest, APurposeWithoutAnEffectPlaysNothing) {
    BodyTrial trial(*body_, outputs_);
    std::vector<tactile::Purpose> all = body_->purposes();
    for (std::size_t i = 0; i < tactile::purpose_count; ++i) {
        const auto purpose = static_cast<tactile::Purpose>(i);
        const bool has = std::find(all.begin(), all.end(), purpose) != all.end();
        EXPECT_EQ(trial.start(1, purpose, {}, 0), has);
    }
    trial.step(-5 * ms);
    trial.step(3'000'000 * ms);
    EXPECT_FALSE(trial.runs()) << "a clock that jumps ends the trial";
}

}  // namespace
}  // namespace thaum::game
