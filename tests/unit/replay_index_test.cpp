// Tests of jumping to any tick of a replay: the state there has the same bits as if all ticks had been
// played.
#include "game/match/replay_index.h"

#include "core/random.h"
#include "unit/message_of.h"
#include "unit/replay_rig.h"

namespace thaum::game::test {
namespace {

constexpr Tick long_enough = 6 * keyframe_interval + 700;

const RecordedDuel& shared_duel() {
    static const RecordedDuel duel("index.thaumlog", long_enough);
    return duel;
}

/// A replay whose index (the stored states from which jumps continue) is complete.
struct Indexed {
    explicit Indexed(const RecordedDuel& duel, std::size_t max_bytes = ReplayIndex::usual_bytes)
        : playback(duel.opened()), index(playback, max_bytes) {
        index.fill(duel.opened(), never);
    }
    Playback playback;
    ReplayIndex index;
};

/// Jumps to a tick and plays on for a while. Each state must have its recorded hash.
void expect_place(Indexed& replay, Tick target) {
    ASSERT_TRUE(seek(replay.playback, replay.index, target, never)) << target;
    const auto& match = replay.playback.match();
    ASSERT_EQ(match.now(), target);
    ASSERT_EQ(match.state_hash(), shared_duel().hashes[target]) << "at tick " << target;
    for (int i = 0; i < 140 && replay.playback.step(); ++i)
        ASSERT_EQ(match.state_hash(), shared_duel().hashes[match.now()])
            << i + 1 << " ticks after " << target;
}

TEST(ReplayIndex, EveryPlaceHasTheStateOfPlayingToItForwardsAndBack) {
    Indexed replay(shared_duel());
    EXPECT_TRUE(replay.index.complete());
    EXPECT_EQ(replay.index.reached(), long_enough);
    for (const Tick target :
         {long_enough, Tick{0}, Tick{1}, keyframe_interval - 1, keyframe_interval, keyframe_interval + 1,
          4 * keyframe_interval, paused_at, paused_at + 1, paused_at + 2, resumed_at, resumed_at + 1,
          resumed_at + 2, Tick{5}, long_enough - 1})
        expect_place(replay, target);
    Random random{11};
    for (int i = 0; i < 20; ++i) expect_place(replay, random.below(long_enough + 1));
    EXPECT_FALSE(replay.playback.divergence()) << described(*replay.playback.divergence());
    EXPECT_FALSE(replay.index.divergence());
}

TEST(ReplayIndex, ThePauseIsWhereItWas) {
    Indexed replay(shared_duel());
    ASSERT_TRUE(seek(replay.playback, replay.index, paused_at + 100, never));
    EXPECT_EQ(replay.playback.match().match().paused, 1U);
    ASSERT_TRUE(seek(replay.playback, replay.index, resumed_at + 100, never));
    EXPECT_EQ(replay.playback.match().match().paused, 0U);
    ASSERT_TRUE(seek(replay.playback, replay.index, paused_at, never));
    EXPECT_EQ(replay.playback.match().match().paused, 0U);
}

TEST(ReplayIndex, BeyondTheEndIsTheEndAndFromThereItGoesBack) {
    Indexed replay(shared_duel());
    ASSERT_TRUE(seek(replay.playback, replay.index, long_enough + 100'000, never));
    EXPECT_EQ(replay.playback.match().now(), long_enough);
    EXPECT_EQ(result_line(replay.playback.match()), shared_duel().result);
    EXPECT_EQ(replay.playback.wrong_result(), "");
    EXPECT_FALSE(replay.playback.step());
    expect_place(replay, 3000);
}

TEST(ReplayIndex, AnIndexThatNobodyFillsStillLeadsEverywhere) {
    auto playback = shared_duel().opened();
    ReplayIndex index(playback);
    index.give_up();
    for (const Tick target : {3000U, 2900U, 0U, 2049U}) {
        ASSERT_TRUE(seek(playback, index, target, never));
        EXPECT_EQ(playback.match().state_hash(), shared_duel().hashes[target]) << target;
    }
}

TEST(ReplayIndex, CoversWhatItHasReached) {
    const auto playback = shared_duel().opened();
    const ReplayIndex index(playback);
    EXPECT_TRUE(index.covers(0));
    EXPECT_TRUE(index.covers(keyframe_interval - 1)) << "from the first tick";
    EXPECT_FALSE(index.covers(keyframe_interval));
    EXPECT_FALSE(index.complete());
}

TEST(ReplayIndex, HasEachKillWhereThePictureShowsIt) {
    Indexed replay(shared_duel());
    const auto kills = replay.index.kills();
    ASSERT_GE(kills.size(), 1U) << "the recorded duel must have a kill";
    for (const auto& kill : kills) {
        const auto wizard = [&] { return wizard_of(replay.playback.match().world(), kill.victim); };
        ASSERT_TRUE(seek(replay.playback, replay.index, kill.at - 1, never));
        EXPECT_FALSE(replay.playback.match().world().has<Dead>(wizard()));
        ASSERT_TRUE(seek(replay.playback, replay.index, kill.at, never));
        EXPECT_TRUE(replay.playback.match().world().has<Dead>(wizard()));
    }
}

TEST(ReplayIndex, StaysWithinItsMemoryByKeepingFewerStates) {
    const Indexed whole(shared_duel());
    EXPECT_EQ(whole.index.spacing(), keyframe_interval);
    const auto budget = whole.index.bytes() * 2 / 3;
    Indexed replay(shared_duel(), budget);
    EXPECT_EQ(replay.index.spacing(), 2 * keyframe_interval);
    EXPECT_LE(replay.index.bytes(), budget);
    for (const Tick target :
         {long_enough, 3 * keyframe_interval + 5, Tick{1}, 2 * keyframe_interval, long_enough - 1})
        expect_place(replay, target);
    const Indexed least(shared_duel(), 1);
    EXPECT_EQ(least.index.newest_before(long_enough).at, 0U) << "the first state is always kept";
}

TEST(ReplayIndex, FindsWhereTheReplayDiffersAndSoDoesWhoJumpsOverIt) {
    constexpr Tick twisted = 2 * keyframe_interval + hash_interval;
    const RecordedDuel duel("twisted.thaumlog", long_enough, twisted);
    Indexed replay(duel);
    ASSERT_TRUE(replay.index.divergence());
    EXPECT_EQ(replay.index.divergence()->recorded.tick, twisted);
    ASSERT_TRUE(seek(replay.playback, replay.index, long_enough, never));
    ASSERT_TRUE(replay.playback.divergence());
    const auto first = earlier(replay.playback.divergence(), replay.index.divergence());
    EXPECT_EQ(first->recorded.tick, twisted) << "the jump has skipped the first one";
    EXPECT_GT(replay.playback.divergence()->recorded.tick, twisted);
}

TEST(ReplayIndex, ACutOffLogHasAllThatIsThere) {
    const RecordedDuel duel("cut.thaumlog", long_enough);
    std::filesystem::resize_file(duel.path, std::filesystem::file_size(duel.path) / 2);
    Indexed replay(duel);
    const auto end = replay.playback.log().ticks();
    ASSERT_GT(end, keyframe_interval);
    ASSERT_LT(end, long_enough);
    EXPECT_EQ(replay.index.reached(), end);
    ASSERT_TRUE(seek(replay.playback, replay.index, long_enough, never));
    EXPECT_EQ(replay.playback.match().now(), end);
    EXPECT_EQ(replay.playback.match().state_hash(), duel.hashes[end]);
}

TEST(ReplayIndex, ALogWithoutTicksIsAPlaceOfItsOwn) {
    const RecordedDuel duel("empty.thaumlog", 0);
    Indexed replay(duel);
    ASSERT_TRUE(seek(replay.playback, replay.index, 10, never));
    EXPECT_EQ(replay.playback.match().now(), 0U);
    EXPECT_EQ(replay.index.reached(), 0U);
}

TEST(ReplayIndex, AnotherMatchInTheSameFileIsNotTheSameLog) {
    const RecordedDuel duel("again.thaumlog", 600);
    const auto playback = duel.opened();
    EXPECT_TRUE(playback.open_again());
    std::filesystem::copy_file(shared_duel().path, duel.path,
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_NE(message_of(playback.open_again()).find("changed while it was shown"), std::string::npos);
}

TEST(ReplayIndex, WhatIsOnlyShownBeginsAnewAfterAJump) {
    Indexed replay(shared_duel());
    ASSERT_TRUE(seek(replay.playback, replay.index, long_enough, never));
    ASSERT_TRUE(seek(replay.playback, replay.index, keyframe_interval, never));
    const auto& match = replay.playback.match();
    for (const auto force : match.felt(0)) EXPECT_EQ(force, 0) << "a force of another time";
    const auto& events = match.events();
    for (auto i = events.first(); i < events.count(); ++i) EXPECT_LE(events[i].tick, match.match().played);
}

}  // namespace
}  // namespace thaum::game::test
