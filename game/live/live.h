// game/live/live.h: a match in a window, in real time.
//
// Three threads share the work (engine/ARCHITECTURE.md, "Threads"):
//   - The main thread waits for window events and polls pads.
//   - The simulation thread takes sample t of each device at t ms and publishes pictures. When it is late it
//     runs faster until it has caught up. It cuts a backlog beyond 250 ms by leaving samples out, and logs
//     the cut as input.
//   - The render thread owns OpenGL and draws the newest pictures.
// No thread waits for another. A delay of one thread can only change when the log's input frames were taken,
// so a replay of the log gives the same state hashes.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/match/replay_index.h"
#include "game/range/dummy.h"
#include "game/settings/settings.h"
#include "input/tick_times.h"

namespace thaum::game::inline live {

enum class SeatKind : std::uint8_t {
    keyboard_mouse,
    keyboard_half,
    pad,
    pad_or_half,  ///< a free pad if one is plugged in, else half of the keyboard (keypad and arrow keys)
    bot,
    dummy,  ///< the practice dummy, which is the opponent on the range
};

/// Request of a seat (a player's place) for a real force-feedback arm.
struct ArmWish {
    /// number of the arm in input::arm_places(); std::nullopt: the first one that is free and opens
    std::optional<std::size_t> number{};
};

struct Seat {
    SeatKind kind{};
    int pad = 0;                   ///< index of the pad in input::Pads
    std::string bot{};             ///< name of the bot, a file of assets/bots
    std::optional<ArmWish> arm{};  ///< request for a real arm in the same hand; std::nullopt: none
};

/// Seat for a word of --hands: mouse, half, pad, arm or arm:NUMBER.
Expected<Seat> hand_named(std::string_view word);
/// Seats for the words of --hands, which are separated by commas: at most one for each player. Only one
/// player has the mouse. A player with an arm but without the mouse also has a pad or half of the keyboard.
Expected<std::vector<Seat>> hands_named(std::string_view words);

/// Delays one thread on purpose, for tests: `ms` of sleep every `every_ms`.
struct Stall {
    enum class Thread : std::uint8_t { none, main, simulation, render };
    Thread thread{};
    int every_ms = 500;
    int ms = 40;
};

/// Timing of a live session.
struct LiveReport {
    std::uint64_t ticks{}, frames{}, skipped{}, matches{};
    double late_us_median{}, late_us_p99{},
        late_us_worst{};  ///< delay of the simulation thread's wake-ups after their deadline
    double tick_us_median{}, tick_us_p99{};    ///< time to compute and log one tick and to copy its picture
    double frame_ms_median{}, frame_ms_p99{};  ///< time to build, draw and present one picture
    /// quality of pictures at the end; the setting `auto` may have changed it before
    render::Quality quality{};
    /// Time from an event's arrival in this program until the picture with its effect is presented, while
    /// playing (ms). That picture is the first one that contains the tick which took the event. The delays of
    /// mouse, keyboard and display are not included.
    double input_ms_median{}, input_ms_p99{};
    /// number of timed events; only the first of several events in one tick is timed
    std::uint64_t inputs{};
};

/// One line on how well a real arm's servo thread, which computes its force, kept time.
std::string told(const input::TickReport& arm);

/// A replay that a session shows instead of a match.
struct ShownReplay {
    Playback& playback;
    /// states and kills of the same log, for jumps; another thread may still fill it
    const ReplayIndex& index;
    Tick start = 0;    ///< first tick that is shown
    double speed = 1;  ///< pace at first (multiple of real time)
};

struct LivePlan {
    std::shared_ptr<const MatchData> data;
    std::uint64_t seed = 1;
    std::array<Seat, 2> seats{};
    /// true: the players choose their seats on the start screen, which replaces `seats` and returns after
    /// each match
    bool start_screen = false;
    /// Kind of the dummy if the session is the practice range instead of a match. The first seat practises,
    /// nothing is recorded, and data files are read again when they change.
    std::optional<DummyKind> practice{};
    /// true: the session is the Apprentice, lessons on the practice range that also choose the dummy
    bool apprentice = false;
    bool first_start =
        false;  ///< true: the program was never started before, so the lessons are offered first
    /// true: bots play one match after another, and each result is shown for some seconds. Only the first
    /// match is recorded, because the recordings of a demo that runs all night would displace those of the
    /// players.
    bool demo = false;
    /// Replay to show instead of a match; null: a match. Nobody plays, and nothing is recorded.
    const ShownReplay* replay = nullptr;
    std::filesystem::path log{};  ///< log of the first match; later logs lie beside it, with a number
    std::filesystem::path
        logs_folder{};  ///< folder for one log per match if `log` is empty; empty: matches are not recorded
    std::filesystem::path assets{};
    Settings settings{};
    /// words for the players on a faulty settings file, shown on the start screen or else at the start of the
    /// first match; empty: there is no fault
    std::string start_fault{};
    /// Reads all data files and returns a text on their faults for terminal and start screen. A thread of its
    /// own calls it after the first pictures. null: the files are not checked.
    std::function<std::string()> read_all_data{};
    /// file that receives changed settings; empty: changes last for this run only
    std::filesystem::path settings_file{};
    /// Length of the session, after which the window closes (s): match time, or wall-clock time on the start
    /// screen.
    std::optional<double> seconds{};
    Stall stall{};
    /// true: the session measures its own timing. It moves player 1's mouse by synthetic events, leaves the
    /// cursor free and plays on when the window has lost the focus.
    bool probe = false;
    LiveReport* report = nullptr;  ///< receives the timing at the end; null: not wanted
};

/// Plays until the window is closed or the players quit. The error says why the session could not go on.
Expected<void> run_live(const LivePlan& plan);

}  // namespace thaum::game::inline live
