// game/app/live.h: a match in a window, in real time.
//
// Three threads (architecture.md, "One tick"). The main thread waits for events and polls pads. The simulation thread takes
// sample t of each device at t ms and publishes pictures; when late it runs faster until it has caught up, and a backlog
// beyond 250 ms is cut by leaving samples out, which is logged as input. The render thread owns OpenGL and draws the
// newest pictures. None waits for another, so whatever holds one of them up cannot change what is in the log's frames
// but for when they were taken: a replay of the log gives the same hashes.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "game/app/settings.h"
#include "game/bots/dummy.h"
#include "game/match/playback.h"
#include "input/arm_servo.h"
#include "input/tick_times.h"

namespace thaum::app {

enum class SeatKind : std::uint8_t {
    keyboard_mouse,
    keyboard_half,
    pad,
    pad_or_half,  ///< a pad where one is plugged in that nobody has, else half a keyboard
    bot,
    dummy,  ///< of the range
};

struct Seat {
    SeatKind kind{};
    int pad = 0;       ///< which of the window's pads
    int level = 1;     ///< of a bot
    bool arm = false;  ///< the hand holds a real force feedback arm besides
};

/// What --hands calls mouse, half, pad or arm.
Expected<Seat> hand_named(std::string_view word);

/// Holds a thread up on purpose, for tests.
struct Stall {
    enum class Thread : std::uint8_t { none, main, simulation, render };
    Thread thread{};
    int every_ms = 500;
    int ms = 40;
};

/// How well time was kept.
struct LiveReport {
    std::uint64_t ticks{}, frames{}, skipped{}, matches{};
    double late_us_median{}, late_us_p99{},
        late_us_worst{};                       ///< wake-ups of the simulation thread after their deadline
    double tick_us_median{}, tick_us_p99{};    ///< one tick, its record and picture
    double frame_ms_median{}, frame_ms_p99{};  ///< building, drawing and presenting one picture
    render::Quality quality{};                 ///< at the end; `auto` may have changed it on the way
    /// From an event's arrival in this program to the end of presenting the first picture that contains the tick which took
    /// it, while playing. What mouse, keyboard and display add is not in it.
    double input_ms_median{}, input_ms_p99{};
    std::uint64_t inputs{};  ///< that were timed: of several events in one tick the first
    /// Where somebody holds a real arm.
    std::optional<input::TickReport> arm{};
    input::ArmTroubles arm_troubles{};
    int arm_losses{};
};

/// One line: how well a real arm's thread kept time.
std::string told(const input::TickReport& arm);

struct LivePlan {
    std::shared_ptr<const game::MatchData> data;
    std::uint64_t seed = 1;
    std::array<Seat, 2> seats{};  ///< at most one with an arm
    bool start_screen = false;    ///< asks who plays with what instead of `seats`, and again after each match
    /// The range instead of a match: the first seat practises on such a dummy, nothing is recorded, and data files that
    /// change are read again.
    std::optional<game::DummyKind> practice{};
    /// A replay instead of a match: nobody plays, nothing is recorded, and the window closes soon after its end.
    game::Playback* replay = nullptr;
    double speed = 1;             ///< of the replay, in times real time
    std::filesystem::path log{};  ///< of the first match; the next go beside it, with a number
    std::filesystem::path
        logs_folder{};  ///< without `log`: where each match gets a file; empty: not recorded
    std::filesystem::path assets{};
    Settings settings{};
    std::filesystem::path settings_file{};  ///< where changes go; empty: they last for this run
    /// Length of the session, after which the window closes (s): match time, or wall-clock time on the start screen.
    std::optional<double> seconds{};
    Stall stall{};
    /// Measures itself: moves player 1's mouse as if by events, neither captures the cursor nor minds the focus.
    bool probe = false;
    LiveReport* report = nullptr;  ///< filled at the end
};

/// Plays until the window is closed or the players quit. Errors go to standard error in one line. Returns an exit code.
int run_live(const LivePlan& plan);

}  // namespace thaum::app
