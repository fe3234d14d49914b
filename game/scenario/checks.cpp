// Checks on the input frames of a run. They test that a match depends only on its input, from any starting
// point and at any delay.
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "ecs/diff.h"
#include "game/match/simulation.h"
#include "game/scenario/play.h"
#include "game/scenario/play_senses.h"

namespace thaum::game::inline scenario {
namespace {

std::string describe(const Bytes& a, const Bytes& b) {
    const auto found = ecs::diff(a, b, 1);
    if (!found || found->empty()) return "no field differs";
    const auto& d = found->front();
    return text(d.component, " of entity ", d.entity, ", ", d.field, ": ", d.a, " and ", d.b);
}

/// A state that a match has reached, with its hash.
struct Reached {
    std::uint64_t hash{};
    Bytes state;
};

Reached reached(const Simulation& match) {
    Reached here{match.state_hash(), {}};
    match.save(here.state);
    return here;
}

std::string difference(Tick tick, const char* what, const Reached& here, const Reached& there) {
    if (here.hash == there.hash) return {};
    return text("tick ", tick, ": ", what, ": ", describe(here.state, there.state));
}

/// Plays the frames from `match.now()` to `end`.
void play_to(Simulation& match, const std::vector<input::InputFrame>& frames, Tick end) {
    while (match.now() < end) match.tick(frames[match.now()]);
}

/// Plays to `tick` from the saved state (keyframe) at or before it; without one, from the start.
Expected<Reached> sought(const Play& play, Tick tick) {
    Simulation match(play.data, play.match->setup());
    const auto after = std::find_if(play.keyframes.begin(), play.keyframes.end(),
                                    [&](const Keyframe& k) { return k.tick > tick; });
    if (after != play.keyframes.begin()) {
        const auto& from = *std::prev(after);
        if (auto restored = match.restore(from.world, from.tick); !restored) return restored.error();
    }
    play_to(match, play.frames, tick);
    return reached(match);
}

/// Queue of frames from the devices to a match on another thread.
struct Channel {
    std::mutex mutex;
    std::condition_variable filled;
    std::deque<input::InputFrame> frames;
    bool closed = false;
};

void stall(Random& random) {
    if (random.below(4) == 0) std::this_thread::sleep_for(std::chrono::microseconds(random.below(2000)));
}

/// Takes all queued frames at once. The result is empty only once the channel is closed and all frames have
/// been taken.
std::deque<input::InputFrame> take(Channel& channel) {
    std::unique_lock lock(channel.mutex);
    channel.filled.wait(lock, [&] { return channel.closed || !channel.frames.empty(); });
    return std::exchange(channel.frames, {});
}

struct LateRun {
    std::vector<std::uint64_t> hashes;
    Reached end;
    std::size_t max_burst = 0;
};

LateRun run_late(const Play& play, Channel& channel, std::uint64_t seed) {
    Simulation match(play.data, play.match->setup());
    Random random = random_stream(seed, 1);
    LateRun run;
    for (auto burst = take(channel); !burst.empty(); burst = take(channel)) {
        run.max_burst = std::max(run.max_burst, burst.size());
        for (const auto& frame : burst) {
            match.tick(frame);
            if (match.now() % hash_interval == 0) run.hashes.push_back(match.state_hash());
        }
        stall(random);
    }
    run.end = reached(match);
    return run;
}

void send_frames(const Play& play, Channel& channel, std::uint64_t seed) {
    Random random = random_stream(seed, 2);
    for (std::size_t sent = 0; sent < play.frames.size();) {
        const auto count =
            std::min(play.frames.size() - sent, static_cast<std::size_t>(1 + random.below(300)));
        {
            const std::lock_guard lock(channel.mutex);
            const auto from = play.frames.begin() + static_cast<std::ptrdiff_t>(sent);
            channel.frames.insert(channel.frames.end(), from, from + static_cast<std::ptrdiff_t>(count));
        }
        channel.filled.notify_one();
        sent += count;
        stall(random);
    }
    const std::lock_guard lock(channel.mutex);
    channel.closed = true;
    channel.filled.notify_one();
}

/// Returns an empty string, or names the first state whose hash differs from that of the original play.
std::string other_state(const Play& play, const char* which, const std::vector<std::uint64_t>& hashes) {
    for (std::size_t i = 0; i < play.hashes.size(); ++i) {
        if (i < hashes.size() && hashes[i] == play.hashes[i]) continue;
        return text("tick ", (i + 1) * hash_interval, ": the ", which, " match has another state");
    }
    return {};
}

/// Hash of the state and of the forces on both hands.
std::uint64_t hash_of_all(const Simulation& match) {
    return hash_value(match.force_hash(), match.state_hash());
}

}  // namespace

std::string check_seek(const Play& play, const std::vector<Tick>& ticks) {
    auto sorted = ticks;
    std::sort(sorted.begin(), sorted.end());
    Simulation played(play.data, play.match->setup());
    for (const auto tick : sorted) {
        play_to(played, play.frames, tick);
        const auto there = sought(play, tick);
        if (!there) return there.error().message;
        auto found = difference(tick, "played and sought states differ", reached(played), *there);
        if (!found.empty()) return found;
    }
    play_to(played, play.frames, play.match->now());
    return difference(played.now(), "the match and its replay differ", reached(*play.match), reached(played));
}

std::string check_late(const Play& play, std::uint64_t seed) {
    Channel channel;
    LateRun late;
    std::jthread simulation([&] { late = run_late(play, channel, seed); });
    send_frames(play, channel, seed);
    simulation.join();
    if (auto found = other_state(play, "late", late.hashes); !found.empty()) return found;
    if (late.max_burst < 2) return "no burst of frames: the match was never late";
    return difference(play.match->now(), "the late match has another state", reached(*play.match), late.end);
}

std::string check_threads(const Play& play, unsigned workers) {
    auto setup = play.match->setup();
    setup.workers = workers;
    Simulation match(play.data, setup);
    std::vector<std::uint64_t> hashes;
    for (const auto& frame : play.frames) {
        match.tick(frame);
        if (match.now() % hash_interval == 0) hashes.push_back(match.state_hash());
    }
    const auto which = text("match with ", workers, " threads beside its own has another state");
    if (auto found = other_state(play, "threaded", hashes); !found.empty()) return found;
    return difference(play.match->now(), which.c_str(), reached(*play.match), reached(match));
}

std::string check_senses(const Play& play, const std::vector<std::string>& layouts, Tick quit) {
    Simulation plain(play.data, play.match->setup()), other(play.data, play.match->setup());
    auto senses = PlaySenses::create(play.options->assets, presentation_of(play), layouts, true);
    if (!senses) return senses.error().message;
    for (const auto& frame : play.frames) {
        plain.tick(frame);
        other.tick(frame);
        if (other.now() == quit) senses->reset();
        if (*senses) (*senses)->follow(other);
        if (other.now() % hash_interval == 0 && hash_of_all(plain) != hash_of_all(other))
            return text("tick ", other.now(),
                        ": the match that is heard and felt has other states or forces");
    }
    const auto end =
        plain.force_hash() != other.force_hash() || play.match->force_hash() != plain.force_hash();
    if (end) return "the match that is heard and felt ends with other forces";
    return difference(play.match->now(), "the match that is heard and felt differs", reached(*play.match),
                      reached(other));
}

}  // namespace thaum::game::inline scenario
