// Tests of requests to the running match: a request that no file of the game knows, their order, and what a
// match that is not on the practice range does with them.
#include "game/live/match_requests.h"

#include <gtest/gtest.h>

namespace thaum::game {
namespace {

/// A request that only this test has: its wizard becomes a dummy. This struct is all that it needs.
struct BecomeDummy {
    game::DummyKind kind{};
    void carry_out(Practice& practice) const { practice.set_dummy(kind); }
};

MatchRequest become(game::DummyKind kind) { return BecomeDummy{kind}; }

class MatchRequestsTest : public testing::Test {
protected:
    static Practice make_practice() {
        const auto data = game::load_range(THAUM_SOURCE_DIR "/assets", {});
        EXPECT_TRUE(data) << (data ? "" : data.error().message);
        return {*data, {input::DeviceSpec{}}, game::DummyKind::still, 1};
    }
    /// Words on the dummy: "still dummy: 100 HP".
    static std::string words_on_dummy(Practice& practice) {
        auto picture = game::make_picture();
        game::take_picture(practice.match(), picture);
        practice.show(picture);
        return picture.practice.below;
    }

    MatchRequests requests_{};
    std::uint32_t buttons_ = 0;
};

TEST_F(MatchRequestsTest, ARequestThatOnlyATestHasReachesTheRange) {
    auto practice = make_practice();
    requests_.ask(become(game::DummyKind::shooting));
    EXPECT_TRUE(words_on_dummy(practice).starts_with("still dummy")) << "not yet";
    requests_.carry_out({&practice, buttons_});
    EXPECT_TRUE(words_on_dummy(practice).starts_with("shooting dummy"));
    EXPECT_FALSE(requests_.take()) << "it is carried out once";
    EXPECT_EQ(buttons_, 0U);
}

TEST_F(MatchRequestsTest, LaterRequestsAreCarriedOutAfterEarlierOnes) {
    auto practice = make_practice();
    requests_.ask(become(game::DummyKind::shooting));
    requests_.ask(become(game::DummyKind::strafing));
    requests_.ask(PressMark{});
    requests_.carry_out({&practice, buttons_});
    EXPECT_TRUE(words_on_dummy(practice).starts_with("strafing dummy"));
    EXPECT_EQ(buttons_, input::bit(input::Button::mark));
}

TEST_F(MatchRequestsTest, ARequestToTheRangeDoesNothingInAnotherMatch) {
    requests_.ask(become(game::DummyKind::shooting));
    requests_.carry_out({nullptr, buttons_});
    EXPECT_FALSE(requests_.take());
}

TEST_F(MatchRequestsTest, WhatWasMeantForAnotherMatchIsForgotten) {
    requests_.ask(PressMark{});
    requests_.forget();
    requests_.carry_out({nullptr, buttons_});
    EXPECT_EQ(buttons_, 0U);
}

TEST_F(MatchRequestsTest, WhileNobodyTakesThemTheOldestRequestsStay) {
    for (int i = 0; i < 1000; ++i) requests_.ask(PressMark{});
    int taken = 0;
    while (requests_.take()) ++taken;
    EXPECT_GT(taken, 10);
    EXPECT_LT(taken, 1000);
    requests_.ask(PressMark{});
    EXPECT_TRUE(requests_.take()) << "and new ones come again";
}

TEST(MatchRequest, KnowsItsStructAndNoOther) {
    const MatchRequest request(DrawGesture{7});
    ASSERT_TRUE(request.as<DrawGesture>());
    EXPECT_EQ(request.as<DrawGesture>()->number, 7U);
    EXPECT_FALSE(request.as<BecomeDummy>());
    EXPECT_FALSE(MatchRequest().as<DrawGesture>());
}

}  // namespace
}  // namespace thaum::game
