// Tests of a team of threads that share loops: every slice of every loop is done once, whichever threads join
// and leave.
#include "core/team.h"

#include <gtest/gtest.h>

#include <latch>
#include <vector>

#include "core/threads.h"

namespace thaum {
namespace {

/// Runs `loops` loops in which each slice counts for itself and for its seat (number of the thread in the
/// team), while `helpers` threads join and leave. Slices that used one seat at once would make a sum wrong.
void expect_all_slices(unsigned helpers, int loops) {
    constexpr int slices = 37;
    Team team;
    team.open();
    std::atomic<bool> stop = false;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < helpers; ++i)
        threads.emplace_back([&] {
            while (!stop) team.help();
        });
    std::vector<int> done(slices);
    std::array<int, Team::max_threads> at_seat{};
    for (int loop = 0; loop < loops; ++loop) {
        if (loop % 50 == 49) {
            team.close();
            team.open();
        }
        team.each(slices, [&](int slice, unsigned seat) {
            ++done[static_cast<std::size_t>(slice)];
            ++at_seat[seat];
        });
    }
    stop = true;
    team.close();
    threads.clear();  // destroys the threads, which waits for them
    EXPECT_EQ(done, std::vector<int>(slices, loops));
    EXPECT_EQ(at_seat[0] + at_seat[1] + at_seat[2] + at_seat[3], slices * loops);
}

TEST(CoreTeam, DoesEachSliceOnceWithAnyNumberOfHelpers) {
    // The team takes at most four threads, so some of five helpers find no place.
    for (const unsigned helpers : {0U, 1U, 2U, 5U}) expect_all_slices(helpers, 500);
}

TEST(CoreTeam, AHelperTakesASliceWhileTheLeaderIsInAnother) {
    Team team;
    team.open();
    const auto helper = start_thread([&] { team.help(); });
    ASSERT_TRUE(helper) << helper.error().message;
    while (!team.has_helpers()) std::this_thread::yield();
    std::latch both(2);
    team.each(2, [&](int, unsigned) { both.arrive_and_wait(); });  // hangs if one thread does both
    team.close();
}

TEST(CoreTeam, NobodyHelpsATeamThatIsNotOpen) {
    Team team;
    team.help();  // returns at once
    team.open();
    team.close();
    team.help();
    EXPECT_FALSE(team.has_helpers());
}

}  // namespace
}  // namespace thaum
