// game/app/live_shared.h: data that the three threads of a live session share without locks.
#pragma once
#include <atomic>
#include <string_view>
#include <variant>

#include "core/clock.h"
#include "core/spsc_queue.h"
#include "core/triple_buffer.h"
#include "game/app/live.h"
#include "game/app/live_arm.h"
#include "game/bots/range_files.h"
#include "game/hud/menu.h"
#include "input/collector.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {

enum class PlayState : std::uint8_t { playing, paused, over };

/// Words that tell a player how to bring a lost pad back.
inline constexpr std::string_view how_to_rejoin = "press a button on it to rejoin";

/// One player's seat with its devices. The DeviceSpec goes into the log's header.
struct TakenSeat {
    Seat seat;
    input::DeviceSpec spec;
    std::unique_ptr<input::HandsCollector> hands;  ///< collector of the player's input; null for a bot
};

/// Times of one event that a tick has taken (ns, monotonic clock).
struct InputStamp {
    std::int64_t came_ns{};  ///< arrival of the event
    std::int64_t due_ns{};   ///< Picture::due_ns of the tick that took the event
};

/// Everything the main thread wants shown besides the match itself.
struct Screen {
    game::HudSettings hud{};                   ///< settings of the views; `quality` below replaces theirs
    std::optional<render::Quality> quality{};  ///< std::nullopt: chosen by measured times
    game::MenuPicture menu{};
    bool arena_scene = false;  ///< true: there is no match, and the arena is shown alone, from above
    double frames_per_second = 60;
};

/// Collected times for the report; keeps the newest values.
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
    /// Quantile of the values: share 0.5 is the median. 0 if there are no values.
    double at(double share);

private:
    static constexpr std::size_t most = 1U << 16U;
    std::vector<double> values_;
    std::size_t count_ = 0;
};

struct LiveShared {
    explicit LiveShared(render::Window& w) : window(w), pictures(game::make_picture()), screen(Screen{}) {}

    render::Window& window;
    std::array<TakenSeat, game::players> seats;  ///< changed only while no simulation thread runs
    LiveArms arms;  ///< real arms; the list and their players change only while no simulation thread runs
    /// filled by the simulation thread, and by the main thread while no simulation runs
    TripleBuffer<game::Picture> pictures;
    TripleBuffer<Screen> screen;  ///< filled by the main thread
    /// Data of the match that the pictures show; filled by the simulation thread.
    TripleBuffer<std::shared_ptr<const game::MatchData>> scene{nullptr};
    /// arrival of the first event that no tick has taken yet; 0: none
    std::atomic<std::int64_t> input_came_ns{0};
    SpscQueue<InputStamp, 256> stamps;  ///< from the simulation thread to the render thread

    std::atomic<bool> ready{false};      ///< true: pictures can be drawn, and the match may begin
    std::atomic<bool> stop{false};       ///< true: all threads must end
    std::atomic<bool> end_match{false};  ///< true: the simulation thread must end
    std::atomic<bool> ended{false};      ///< true: the simulation thread has ended its match
    /// set on the result screen; then the match ends by itself and another follows
    std::atomic<bool> rematch{false};
    std::atomic<PlayState> going{PlayState::playing};
    std::atomic<std::uint32_t> paused_by{game::no_player};
    std::atomic<std::uint32_t> marks{0};  ///< number of presses of the session's mark key
    std::atomic<game::DummyKind> dummy{game::DummyKind::still};  ///< wanted kind of the range's dummy
    /// Player for whom the session presses the pause button: to pause (wants_pause), or to go on. Ignored if
    /// the match is in that state already. game::no_player: none.
    std::atomic<std::uint32_t> wants_pause{game::no_player}, wants_to_go_on{game::no_player};
    std::array<std::atomic<bool>, game::players> pad_lost{};

    // Each of the following is written by one thread, and read after that thread has ended.
    std::optional<Error> simulation_error, render_error;
    std::int64_t began_ns = 0;  ///< time when the start screen opened (ns, monotonic clock); 0: not yet
    LiveReport report;
    Timings late, ticks;  ///< delays and durations of the simulation thread's ticks (us)
};

/// Delays its thread on purpose: sleeps when the stall of that thread is due.
struct Staller {
    Stall stall;
    std::int64_t next_ns = 0;
    void pass(Stall::Thread thread);
};

std::vector<input::DeviceSpec> devices_of(const LiveShared& shared);
/// Devices beyond the hands of both players: the real arms that players hold.
std::vector<input::DeviceSpec> arms_of(const LiveShared& shared);
/// Calls f(arm, device) for each real arm that a player holds. `device` is its index among the match's
/// devices, which begin with the hands of both players.
template <class F>
void each_held_arm(const LiveShared& shared, F&& f) {
    std::size_t device = game::players;
    for (const auto& arm : shared.arms) {
        if (arm->player < game::players) f(*arm, device++);
    }
}

/// Record of the session's match: none, a log, or the data files of the range. The range's data may change
/// during the match, so a range is never logged: a log's header must stay true.
using Recording = std::variant<std::monostate, input::LogWriter, game::RangeFiles>;

/// Everything the simulation thread takes over to play one match.
struct MatchStart {
    /// data of the match; practice uses the data of `recording` instead
    std::shared_ptr<const game::MatchData> data;
    std::uint64_t seed = 1;
    Recording recording;
};

/// Body of the simulation thread: plays one match until shared.stop, shared.end_match or a rematch, then sets
/// shared.ended. Sets shared.stop as well when the plan's time is up or its replay has ended.
void run_simulation(const LivePlan& plan, LiveShared& shared, MatchStart start);

/// Body of the render thread: draws until shared.stop.
void run_render(const LivePlan& plan, LiveShared& shared);

}  // namespace thaum::app
