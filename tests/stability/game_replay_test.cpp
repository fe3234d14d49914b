// Tests determinism (engine/ARCHITECTURE.md, "State and caches") under attack: restored states, other Worlds
// running at the same time, dropped caches, and one value corrupted on purpose, which the hashes must reveal.
#include <thread>

#include "core/random.h"
#include "ecs/snapshot.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

constexpr Tick length = 3 * keyframe_interval + 500;

/// A match with its input frames, its hash after every tick, and its states at keyframes (ticks at which a
/// replay may start).
struct Recorded {
    explicit Recorded(std::uint64_t seed) : duel(make_duel(seed)) {
        for (Tick t = 0; t < length; ++t) {
            if (t % keyframe_interval == 0) duel.match->save(keyframes.emplace_back());
            duel.match->tick(frames.emplace_back(duel.next_frame()));
            if (t % 16 == 15) hashes.push_back(duel.match->state_hash());
        }
    }
    BotDuel duel;
    std::vector<input::InputFrame> frames;
    std::vector<std::uint64_t> hashes;
    std::vector<Bytes> keyframes;
};

const Recorded& recorded() {
    static const Recorded match(3);
    return match;
}

/// Plays the recorded frames from tick `from` on. Returns the first tick with a different hash, or `to`.
Tick first_difference(Simulation& match, Tick from, Tick to = length) {
    for (Tick t = from; t < to; ++t) {
        match.tick(recorded().frames[t]);
        if (t % 16 == 15 && match.state_hash() != recorded().hashes[t / 16]) return t;
    }
    return length;
}

std::unique_ptr<Simulation> fresh() {
    return std::make_unique<Simulation>(duel_data(), recorded().duel.match->setup());
}

TEST(GameReplay, WithoutTheBotsTheFramesGiveTheSameMatch) {
    const auto match = fresh();
    EXPECT_EQ(first_difference(*match, 0), length);
    EXPECT_EQ(match->state_hash(), recorded().duel.match->state_hash());
}

TEST(GameReplay, RestoredAtAKeyframeInAnotherWorldItGoesOnToTheSameBits) {
    for (std::size_t k = 0; k < recorded().keyframes.size(); ++k) {
        const auto match = fresh();
        for (Tick t = 0; t < 777 * k; ++t)
            match->tick(recorded().frames[t % 100]);  // gives the match another history before the restore
        ASSERT_TRUE(match->restore(recorded().keyframes[k], k * keyframe_interval).has_value());
        ASSERT_EQ(first_difference(*match, k * keyframe_interval), length) << "keyframe " << k;
    }
}

TEST(GameReplay, StoppedAndRestoredAtRandomTicks) {
    Random random{99};
    const auto match = fresh();
    Tick at = 0;
    for (int i = 0; i < 8; ++i) {
        const Tick stop = at + 1 + random.below(length / 6);
        if (stop >= length) break;
        ASSERT_EQ(first_difference(*match, at, stop), length);
        // Restores the last keyframe, then plays up to the tick of the stop.
        const Tick key = stop / keyframe_interval;
        ASSERT_TRUE(match->restore(recorded().keyframes[key], key * keyframe_interval).has_value());
        ASSERT_EQ(first_difference(*match, key * keyframe_interval, stop), length);
        at = stop;
    }
}

TEST(GameReplay, CachesThrownAwayAtRandomTicksChangeNothing) {
    Random random{5};
    const auto match = fresh();
    Bytes state;
    for (Tick t = 0; t < length; ++t) {
        if (random.below(300) == 0) {  // a World read back from its own bytes has no caches
            ecs::save(match->world(), state);
            ASSERT_TRUE(ecs::restore(match->world_to_change(), state).has_value());
        }
        match->tick(recorded().frames[t]);
        if (t % 16 != 15) continue;
        ASSERT_EQ(match->state_hash(), recorded().hashes[t / 16]) << t;
    }
}

TEST(GameReplay, WorldsSideBySideOnThreadsDoNotDisturbEachOther) {
    std::array<Tick, 4> results{};
    std::vector<std::jthread> threads;
    for (auto& result : results) threads.emplace_back([&result] { result = first_difference(*fresh(), 0); });
    threads.clear();  // destroys the threads, which waits for them to end
    for (const auto result : results) EXPECT_EQ(result, length);
}

TEST(GameReplay, OneCorruptedValueIsDetected) {
    const auto match = fresh();
    ASSERT_EQ(first_difference(*match, 0, 1000), length);
    // The changed value must not be one of Gaze (the direction of view): when the view turns, rounding may
    // remove a changed last bit before the next hash.
    auto& health = match->world_to_change().get<Health>(wizard_of(match->world(), 0));
    health.points = std::nextafter(health.points, 0.0);
    EXPECT_LT(first_difference(*match, 1000, 1100), length);
}

TEST(GameReplay, SkippingIdleSystemsChangesNothing) {
    const auto match = fresh();
    match->live().skip_idle = false;
    match->always().skip_idle = false;
    EXPECT_EQ(first_difference(*match, 0), length);
}

}  // namespace
}  // namespace thaum::game::test
