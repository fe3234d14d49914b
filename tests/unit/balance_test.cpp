// Tests of BalanceCounter (game/bots/balance.h): which magic counts as used, and which kills as magic.
#include <gtest/gtest.h>

#include "game/bots/balance.h"
#include "game/data/event_kinds.h"

namespace thaum::game::test {
namespace {

/// A round in which blows and magic happen at a chosen tick; the first player attacks unless stated.
struct Round {
    BalanceCounter counter{};

    Round() { begins(1000); }
    void begins(Tick tick) { happens(tick, EventKind::round_begin, no_player, no_player); }
    void happens(Tick tick, EventKind kind, std::uint32_t subject, std::uint32_t by, double amount = 0) {
        counter.note({.tick = tick, .kind = kind, .subject = subject, .by = by, .amount = amount});
    }
    void blow(Tick tick, double points, std::uint32_t by = 0) {
        happens(tick, hit_kind("bolt_hit"), 1 - by, by, points);
    }
    /// The other player's death, credited to `by`. Returns whether the kill counts as magic.
    bool kills(Tick tick, std::uint32_t by = 0) {
        happens(tick, EventKind::death, 1 - by, by);
        return counter.round().kills.back().magic;
    }
    bool used(std::uint32_t player, Magic source) const {
        return counter.round().used[player][static_cast<std::size_t>(source)];
    }
};

TEST(Balance, AKillWithoutMagicIsNoneAndItsWaitIsCounted) {
    Round round;
    round.blow(1500, 60);
    EXPECT_FALSE(round.kills(1600));
    round.blow(1700, 100);
    EXPECT_FALSE(round.kills(1750));
    const auto& kills = round.counter.round().kills;
    ASSERT_EQ(kills.size(), 2U);
    EXPECT_EQ(kills[0].waited, 600) << "since the round began";
    EXPECT_EQ(kills[1].waited, 150);
    for (const auto& player : round.counter.round().used)
        for (const bool used : player) EXPECT_FALSE(used);
}

TEST(Balance, HalfOfTheLastThirtyPointsDecide) {
    for (const double under : {14.9, 15.0}) {
        Round round;
        round.happens(2000, EventKind::potion, 0, 0, 1);  // for a second
        round.blow(2500, 500);
        round.blow(3100, 30 - under);  // the potion is over
        round.happens(3200, EventKind::poison, 1, 0, under);
        EXPECT_EQ(round.kills(3300), under >= 15);
    }
}

TEST(Balance, OfALargeBlowOnlyTheLastPartCounts) {
    Round round;
    round.happens(2000, EventKind::poison, 1, 0, 90);
    round.blow(2100, 20);
    EXPECT_FALSE(round.kills(2100)) << "10 of the last 30 HP";
}

TEST(Balance, SpellsActForATimeAndAWizardWhoIsPushedFallsUnderThem) {
    Round round;
    round.happens(2000, EventKind::cast, 0, 0, 1);
    EXPECT_FALSE(round.used(0, Magic::spells)) << "a spell that changes nothing is not used";
    round.blow(2000 + spell_acts - 1, 40);
    EXPECT_TRUE(round.used(0, Magic::spells));
    EXPECT_TRUE(round.kills(2000 + spell_acts));
    round.blow(2000 + spell_acts, 40);
    EXPECT_FALSE(round.kills(2000 + spell_acts));
    round.happens(20'000, EventKind::pushed, 1, 0, 8);
    round.happens(20'000 + push_acts - 1, EventKind::fall, 1, no_player, 40);
    EXPECT_TRUE(round.kills(20'000 + push_acts)) << "nobody's blow, but the pusher's deed";
    round.happens(30'000, EventKind::fall, 1, no_player, 40);
    EXPECT_FALSE(round.kills(30'000)) << "long after the push";
}

TEST(Balance, EachSourceIsUsedByThePlayerWhoHasItsEffect) {
    Round round;
    round.happens(1100, EventKind::scried, 1, 1, 0);
    EXPECT_FALSE(round.used(1, Magic::orb)) << "nothing was given";
    round.happens(1200, EventKind::scried, 1, 1, 25);
    round.happens(1300, EventKind::held_off, 0, 1, 6);
    round.happens(1400, EventKind::potion, 1, 1, 12);
    round.blow(1500, 6);  // falls on the one who has drunk
    round.happens(1600, EventKind::lens, 0, 0);
    round.blow(1700, 6);
    EXPECT_TRUE(round.used(1, Magic::orb) && !round.used(0, Magic::orb));
    EXPECT_TRUE(round.used(0, Magic::spells) && !round.used(1, Magic::spells));
    EXPECT_TRUE(round.used(1, Magic::pot) && !round.used(0, Magic::pot));
    EXPECT_TRUE(round.used(0, Magic::crystal) && !round.used(1, Magic::crystal));
}

TEST(Balance, DeathEndsWhatActsAndNoKillIsCountedForAnOwnOne) {
    Round round;
    round.happens(1100, EventKind::lens, 0, 0);
    round.happens(1200, EventKind::death, 0, no_player);
    EXPECT_TRUE(round.counter.round().kills.empty());
    round.blow(1300, 100);
    EXPECT_FALSE(round.kills(1300)) << "the Lens was lost";
}

TEST(Balance, TheLeadChangesWhenTheOtherPlayerComesToHaveMore) {
    Round round;
    for (const std::uint32_t by : {0U, 1U, 1U, 0U, 0U}) {
        round.blow(1500, 100, by);
        round.kills(1500, by);
    }
    EXPECT_EQ(round.counter.round().lead_changes, 2U);
    // From 3 : 2, a death of one's own making makes it 2 : 2, and the foe's next kill gives the lead away.
    round.happens(1600, EventKind::death, 0, no_player);
    EXPECT_EQ(round.counter.round().lead_changes, 2U);
    round.kills(1700, 1);
    EXPECT_EQ(round.counter.round().lead_changes, 3U);
    round.begins(9000);
    EXPECT_EQ(round.counter.round().lead_changes, 0U);
    EXPECT_TRUE(round.counter.round().kills.empty());
}

}  // namespace
}  // namespace thaum::game::test
