// game/app/live_shared.h: what the three threads of a live session share. All of it is lock-free.
#pragma once
#include <atomic>

#include "game/app/live.h"
#include "game/app/live_latest.h"
#include "game/hud/hud.h"
#include "input/collector.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {

enum class Going : std::uint8_t { playing, paused, over };

/// One player's place; its DeviceSpec goes into the log.
struct TakenSeat {
    Seat seat;
    input::DeviceSpec spec;
    std::unique_ptr<input::HandsCollector> hands;  ///< null for a bot
};

/// An event that a tick has taken, ns of the monotonic clock.
struct InputStamp {
    std::int64_t came_ns{};  ///< when it arrived
    std::int64_t due_ns{};   ///< Picture::due_ns of the tick that took it
};

/// From one thread to one other; what has no room is left out.
class InputStamps {
public:
    void push(const InputStamp& stamp) {
        const auto end = end_.load(std::memory_order_relaxed);
        if (end - begin_.load(std::memory_order_acquire) == stamps_.size()) return;
        stamps_[end % stamps_.size()] = stamp;
        end_.store(end + 1, std::memory_order_release);
    }
    /// Calls f(stamp) for those that were due by then, and forgets them.
    template <class F>
    void take_due(std::int64_t due_ns, F f) {
        auto begin = begin_.load(std::memory_order_relaxed);
        const auto end = end_.load(std::memory_order_acquire);
        for (; begin != end && stamps_[begin % stamps_.size()].due_ns <= due_ns; ++begin)
            f(stamps_[begin % stamps_.size()]);
        begin_.store(begin, std::memory_order_release);
    }

private:
    std::array<InputStamp, 256> stamps_;
    std::atomic<std::uint64_t> begin_{0}, end_{0};
};

struct LiveShared {
    explicit LiveShared(render::Window& w) : window(w), pictures(game::make_picture()) {}

    render::Window& window;
    std::array<TakenSeat, game::players> seats;
    Latest<game::Picture> pictures;
    std::atomic<std::int64_t> input_came_ns{0};  ///< of the first event that no tick has taken yet; 0: none
    InputStamps stamps;                          ///< from the simulation to the render thread

    std::atomic<bool> ready{false};    ///< pictures can be drawn: the match may begin
    std::atomic<bool> stop{false};     ///< all threads end
    std::atomic<bool> rematch{false};  ///< asked for on the result screen
    std::atomic<Going> going{Going::playing};
    /// A player for whom the session presses pause (or presses it again) once, if the match is not so already;
    /// game::no_player: nobody.
    std::atomic<std::uint32_t> wants_pause{game::no_player}, wants_to_go_on{game::no_player};
    std::array<std::atomic<bool>, game::players> pad_lost{};
    std::atomic<render::Split> split{render::Split::top_bottom};

    // Each written by one thread, read after it has ended.
    std::optional<Error> simulation_error, render_error;
    LiveReport report;
};

/// ns of the monotonic clock.
std::int64_t monotonic_ns();
void sleep_until_ns(std::int64_t when);

/// Sleeps when a stall of that thread is due.
struct Staller {
    Stall stall;
    std::int64_t next_ns = 0;
    void pass(Stall::Thread thread);
};

/// Times as they come, for the report; keeps the newest.
class Timings {
public:
    Timings() { values_.reserve(most); }
    void add(double value) {
        if (values_.size() < most)
            values_.push_back(value);
        else
            values_[count_ % most] = value;
        ++count_;
    }
    /// share 0.5: the median; 0 where there is nothing.
    double at(double share);

private:
    static constexpr std::size_t most = 1U << 16U;
    std::vector<double> values_;
    std::size_t count_ = 0;
};

/// The log of the session's match 1, 2, ...: LivePlan::log, and for a rematch a number beside it.
Expected<input::LogWriter> open_log(const LivePlan& plan, const LiveShared& shared, std::uint64_t seed,
                                    std::uint64_t match);

/// The simulation thread; no `first_log`: nothing is recorded. Returns when shared.stop is set, or sets it itself.
void run_simulation(const LivePlan& plan, LiveShared& shared, std::optional<input::LogWriter> first_log);

/// The render thread.
void run_render(const LivePlan& plan, LiveShared& shared, game::Watch watch);

}  // namespace thaum::app
