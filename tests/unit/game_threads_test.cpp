// Tests of matches that run at the same time, each on a thread of its own and with job threads for its brew.
// The thread sanitizer runs this test, too.
#include <thread>

#include "game/stations/cauldron/cauldron.h"
#include "tests/scenes/stirring_hands.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

/// Plays half a second in which both players stir. Returns the state's hash at every 40th tick.
std::vector<std::uint64_t> stirred_hashes(const std::shared_ptr<const MatchData>& data, unsigned workers) {
    std::vector<std::uint64_t> hashes;
    const auto mouse = [](std::uint32_t player) {
        return input::DeviceSpec{
            .player = player, .kind = input::DeviceKind::script, .name = "mouse", .look_rad_per_count = 1e-3};
    };
    Simulation match(data, {.seed = 4, .devices = {mouse(0), mouse(1)}, .workers = workers});
    bench::place_at_the_rim(match);
    for (Tick t = 0; t < 500; ++t) {
        match.tick(bench::stirring(t));
        if (t % 40 == 39) hashes.push_back(match.state_hash());
    }
    EXPECT_GT(match.world().single<Cauldron>().speed, 0.01) << "the brew was not stirred";
    return hashes;
}

TEST(GameThreads, MatchesSideBySideAgreeWithAnyNumberOfJobThreads) {
    const auto data = duel_data({"cauldron.brew.cells_across=12"});
    std::array<std::vector<std::uint64_t>, 4> hashes;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < hashes.size(); ++i)
        threads.emplace_back([&, i] { hashes[i] = stirred_hashes(data, i % 3); });
    threads.clear();  // destroys the threads, which waits for them
    for (std::size_t i = 1; i < hashes.size(); ++i)
        EXPECT_EQ(hashes[i], hashes[0]) << i % 3 << " job threads";
}

}  // namespace
}  // namespace thaum::game::test
