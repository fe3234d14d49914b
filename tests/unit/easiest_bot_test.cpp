// Measures the easiest bot: how long a player survives who only walks about. The player walks along random
// paths through the court, looks in the direction of walking, and never shoots. Each seed gives one life.
#include <thread>

#include "game/bots/aim.h"
#include "game/bots/bot_file.h"
#include "game/bots/nav.h"
#include "game/bots/senses.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

constexpr std::uint64_t measured_lives = 20;
constexpr double longest_life = 150;  ///< longest time for which one life is measured (s)
constexpr double wanted_median = 60;  ///< least median that the lives must have (s)

/// A player who only walks about.
class Walker {
public:
    Walker(const Simulation& match, std::uint32_t player, std::uint64_t seed)
        : grid_(match.physics(), ground_bounds(match.data().arena)) {
        seat_.player = player;
        seat_.skill.turn_speed = 115 * radians_per_degree;
        mind_.random = random_stream(seed, 500);
    }

    void sample(const Simulation& match, input::DeviceSample& sample) {
        const Tick tick = match.match().played, phase = tick % gameplay_period;
        if (phase == 0) think(self_of(match, seat_.player), tick);
        turn_hand(mind_, gameplay_period - phase, sample);
        sample.counts[input::hand::strafe] = mind_.move_strafe;
        sample.counts[input::hand::forward] = mind_.move_forward;
    }

private:
    void think(const Self& self, Tick tick) {
        const int cell = grid_.cell_at(self.centre);
        if (cell == ways_.goal || tick >= mind_.goal_until) choose_goal(tick);
        const int next = grid_.next(cell, ways_);
        const vec3 way = grid_.centre_of(next) - vec3(self.centre.x, 0, self.centre.z);
        Aim aim = aim_at(self.eye, self.eye + way);
        aim.pitch = 0;
        turn_towards(self, seat_, aim, mind_);
        const vec3 local = glm::conjugate(rotation({0, 1, 0}, self.yaw)) * way;
        const double full = next == cell ? 0 : 127 / std::max(1e-6, glm::length(local));
        mind_.move_strafe = static_cast<std::int32_t>(std::lround(full * local.x));
        mind_.move_forward = static_cast<std::int32_t>(std::lround(-full * local.z));
    }

    /// Chooses a place outside of the pits.
    void choose_goal(Tick tick) {
        int goal = 0;
        do goal = static_cast<int>(mind_.random.below(static_cast<std::uint64_t>(grid_.cells())));
        while (!grid_.in_large_region(goal) || grid_.height(goal) < -0.5);
        grid_.find_ways(goal, ways_);
        mind_.goal_until = tick + ticks(mind_.random.uniform(3, 8));
    }

    WalkGrid grid_;
    WalkGrid::Ways ways_;
    Seat seat_;
    Mind mind_;
};

struct Life {
    double duration{};  ///< time from the beginning of the match to the death (s), at most longest_life
    bool killed{};      ///< whether the bot has killed the player
};

Life life_beside_the_easiest_bot(const std::shared_ptr<const MatchData>& data, std::uint64_t seed) {
    const auto bot = list_bots(assets()).front().name;
    Simulation match(data, {seed, {bot_device(0, bot), bot_device(1, bot)}});
    Bots bots;
    bots.add(match, 0, 0, load_bot_skill(assets(), bot).value(), seed);
    Walker walker(match, 1, seed);
    while (match.match().played < ticks(longest_life)) {
        input::InputFrame frame;
        bots.sample(match, frame);
        walker.sample(match, frame.devices[1]);
        match.tick(frame);
        if (match.world().has<Dead>(wizard_of(match.world(), 1))) break;
    }
    std::uint32_t kills = 0;
    for (const MatchStats& stats : match.world().single<EventLog>().match_stats[0]) kills += stats.kills;
    return {seconds(match.match().played), kills > 0};
}

TEST(EasiestBot, SeldomKillsAPlayerWhoOnlyWalksWithinAMinute) {
    const auto data = duel_data({"thaum.cauldron=false"});  // the brew would take time and has no effect here
    std::array<Life, measured_lives> lives;
    const auto play = [&](std::uint64_t first) {
        for (std::uint64_t i = first; i < measured_lives; i += 2)
            lives[i] = life_beside_the_easiest_bot(data, i + 1);
    };
    std::thread other(play, 1);
    play(0);
    other.join();
    std::sort(lives.begin(), lives.end(),
              [](const Life& a, const Life& b) { return a.duration < b.duration; });
    const double median = (lives[measured_lives / 2 - 1].duration + lives[measured_lives / 2].duration) / 2;
    const auto kills =
        std::count_if(lives.begin(), lives.end(), [](const Life& life) { return life.killed; });
    std::printf(
        "lives beside the easiest bot: median %s%.0f s, shortest %.0f s, %d of %d players killed within %.0f "
        "s\n",
        median < longest_life ? "" : "at least ", median, lives[0].duration, static_cast<int>(kills),
        static_cast<int>(measured_lives), longest_life);
    EXPECT_GE(median, wanted_median);
    EXPECT_GE(kills, 3) << "the bot can kill";
}

}  // namespace
}  // namespace thaum::game::test
