// game/app/live_shared.h: what the three threads of a live session share. All of it is lock-free.
#pragma once
#include <atomic>
#include <string_view>
#include <variant>

#include "core/clock.h"
#include "core/latest.h"
#include "core/ring.h"
#include "game/app/live.h"
#include "game/app/live_arm.h"
#include "game/bots/range_files.h"
#include "game/hud/menu.h"
#include "input/collector.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {

enum class Going : std::uint8_t { playing, paused, over };

/// What brings a lost pad back.
inline constexpr std::string_view how_to_rejoin = "press a button on it to rejoin";

/// A player's arm comes after the hands of both.
inline constexpr std::size_t arm_device = game::players;

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

/// What the main thread wants shown besides the match itself.
struct Screen {
    game::HudSettings hud{};                   ///< but for its quality
    std::optional<render::Quality> quality{};  ///< nothing: by measured times
    game::MenuPicture menu{};
    bool court = false;  ///< there is no match: the court alone, from above
    double frames_per_second = 60;
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

struct LiveShared {
    explicit LiveShared(render::Window& w) : window(w), pictures(game::make_picture()), screen(Screen{}) {}

    render::Window& window;
    std::array<TakenSeat, game::players> seats;  ///< changed only while no simulation thread runs
    input::ArmServo servo;                       ///< of `arm`: between its thread and the simulation's
    std::unique_ptr<ArmKeeper> arm;              ///< main's; null: none was asked for
    std::uint32_t arm_player = game::no_player;  ///< whose hand holds it in this match, if anybody's
    Latest<game::Picture> pictures;  ///< filled by the simulation thread, by main while there is none
    Latest<Screen> screen;           ///< filled by main
    /// Where the pictures are; filled by the simulation thread.
    Latest<std::shared_ptr<const game::MatchData>> scene{nullptr};
    std::atomic<std::int64_t> input_came_ns{0};  ///< of the first event that no tick has taken yet; 0: none
    Ring<InputStamp, 256> stamps;                ///< from the simulation to the render thread

    std::atomic<bool> ready{false};      ///< pictures can be drawn: the match may begin
    std::atomic<bool> stop{false};       ///< all threads end
    std::atomic<bool> end_match{false};  ///< the simulation thread ends
    std::atomic<bool> ended{false};      ///< it has
    std::atomic<bool> rematch{false};    ///< asked for on the result screen; then the match ends by itself
    std::atomic<Going> going{Going::playing};
    std::atomic<std::uint32_t> paused_by{game::no_player};
    std::atomic<std::uint32_t> marks{0};                         ///< presses of the session's mark key
    std::atomic<game::DummyKind> dummy{game::DummyKind::still};  ///< what the range's is to be
    /// A player for whom the session presses pause (or presses it again) once, if the match is not so already;
    /// game::no_player: nobody.
    std::atomic<std::uint32_t> wants_pause{game::no_player}, wants_to_go_on{game::no_player};
    std::array<std::atomic<bool>, game::players> pad_lost{};

    // Each written by one thread, read after it has ended.
    std::optional<Error> simulation_error, render_error;
    std::int64_t began_ns = 0;  ///< when the first match, or the start screen, began; 0: not yet
    LiveReport report;
    Timings late, ticks;  ///< us; of the simulation thread
};

/// Sleeps when a stall of that thread is due.
struct Staller {
    Stall stall;
    std::int64_t next_ns = 0;
    void pass(Stall::Thread thread);
};

std::vector<input::DeviceSpec> devices_of(const LiveShared& shared);
/// The devices beyond the hands of both: the arm, if somebody holds it.
std::vector<input::DeviceSpec> arms_of(const LiveShared& shared);

/// A match is recorded, or it is practice by data that may change on the way, or neither. No value is both: what a log's
/// header says of the data stays true.
using Keeping = std::variant<std::monostate, input::LogWriter, game::RangeFiles>;

/// One match, as the simulation thread takes it over.
struct MatchStart {
    std::shared_ptr<const game::MatchData> data;  ///< but for practice, which has its own
    std::uint64_t seed = 1;
    Keeping keeping;
};

/// The simulation thread: plays one match, until shared.stop, shared.end_match or a rematch; then it sets shared.ended. Where
/// the plan's time is up, or a replay, it sets shared.stop as well.
void run_simulation(const LivePlan& plan, LiveShared& shared, MatchStart start);

/// The render thread, until shared.stop.
void run_render(const LivePlan& plan, LiveShared& shared);

}  // namespace thaum::app
