// game/live/shared.h: data that the three threads of a live session share. Handing a value from one thread to
// another (hand_over.h) takes a lock for a moment; no other access takes a lock.
#pragma once
#include <atomic>
#include <functional>

#include "core/clock.h"
#include "core/triple_buffer.h"
#include "game/hud/menu.h"
#include "game/live/arm.h"
#include "game/live/body.h"
#include "game/live/hand_over.h"
#include "game/live/live.h"
#include "game/live/match_requests.h"
#include "game/live/pause.h"
#include "game/live/recording.h"
#include "game/live/replay_view.h"
#include "game/live/seats.h"
#include "game/live/sound.h"
#include "game/live/tactile.h"
#include "render/context.h"

namespace thaum::game::inline live {

inline constexpr std::int64_t ns_per_tick = 1'000'000;
inline constexpr Tick mark_shown = 1500;  ///< time for which the screen shows a bookmark (ticks)

/// Times of one event that a tick has taken (ns, monotonic clock).
struct InputStamp {
    std::int64_t came_ns{};  ///< arrival of the event
    std::int64_t due_ns{};   ///< time at which the tick that took the event was due (Picture::due_ns)
};

/// Everything the main thread wants shown besides the match itself.
struct Screen {
    HudSettings hud{};  ///< settings of the views; the member `quality` replaces the quality in them
    /// quality of pictures; std::nullopt: chosen by device and measured times
    std::optional<render::Quality> quality{};
    MenuPicture menu{};
    bool arena_scene = false;  ///< true: there is no match, and the arena is shown alone, from above
    double frames_per_second = 60;
    bool frame_times = false;  ///< true: the time of each part of the pictures is measured and shown
    bool operator==(const Screen&) const = default;
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
    /// Quantile of the collected values: share 0.5 is the median. 0 if there are no values.
    double at(double share);

private:
    static constexpr std::size_t most = 1U << 16U;
    std::vector<double> values_;
    std::size_t count_ = 0;
};

/// State of the present match, from the simulation thread.
struct MatchProgress {
    std::atomic<PlayState> state{PlayState::playing};
    std::atomic<std::uint32_t> paused_by{no_player};
    std::atomic<bool> ended{false};  ///< true: the simulation thread has ended its match
    /// Largest force that a player on the practice range has found by feel (% of the device's peak), until
    /// the main thread takes it; 0: none.
    std::atomic<std::uint32_t> found_force{0};
    /// Gesture that a player on the practice range has drawn, for the main thread to check and to save.
    HandOver<gesture::Gesture> drawn_gesture{};
    /// Number plus 1 of the gesture that the player on the practice range records anew now; 0: none.
    std::atomic<std::uint32_t> drawn_number{0};
};

struct LiveShared {
    /// `make_motors` opens the motors of a pad; tests pass a fake.
    explicit LiveShared(LiveTactile::MakeOutput make_motors = input::rumble_output)
        : tactile(std::move(make_motors)), pictures(make_picture()), screen(Screen{}) {}

    void say_started() {
        started = true;
        started.notify_all();
    }

    TakenSeats seats;  ///< seats of the match; changed only while no simulation thread runs
    /// Effects on the body; std::nullopt: nothing is felt. Set before the first match.
    std::optional<LiveBody> body;
    /// bank of sounds and loudspeakers; null: silence; set before the first match
    std::unique_ptr<LiveSound> sound;
    LiveTactile tactile;  ///< motors of the players' pads, and their jackets
    LiveArms arms;  ///< real arms; the list and their players change only while no simulation thread runs
    /// pictures for the render thread, from the simulation thread or, while none runs, from the main thread
    TripleBuffer<Picture> pictures;
    TripleBuffer<Screen> screen;  ///< what is shown besides the match; filled by the main thread
    /// Data of the match that the pictures show; filled by the simulation thread.
    TripleBuffer<std::shared_ptr<const MatchData>> scene{nullptr};
    /// arrival of the first event that no tick has taken yet; 0: none
    std::atomic<std::int64_t> input_came_ns{0};
    /// times of input events, from the simulation thread to the render thread
    SpscQueue<InputStamp, 256> stamps;

    std::atomic<bool> ready{false};  ///< true: pictures can be drawn, and the match may begin
    std::atomic<bool> stop{false};   ///< true: all threads must end
    /// true: the first pictures are shown, or the session ends without them. Work that can wait begins then.
    std::atomic<bool> started{false};
    /// Words on faulty data files, from the thread that reads them all; taken by the main thread.
    HandOver<std::string> data_fault{};
    MatchRequests requests{};
    MatchProgress progress{};
    ReplayRequests replay{};  ///< requests of the viewer of a replay
    /// true: the player's pad is unplugged and the player has no other device; set by the main thread
    std::array<std::atomic<bool>, players> pad_lost{};

    // Each of the following is written by one thread, and read after that thread has ended.
    std::optional<Error> simulation_error, render_error;
    LiveReport report;
    Timings late, ticks;  ///< delays and durations of the simulation thread's ticks (us)
};

/// Delays its thread on purpose: sleeps when the stall of that thread is due.
struct Staller {
    Stall stall;
    std::int64_t next_ns = 0;
    void pass(Stall::Thread thread);
};

/// Everything the simulation thread takes over to play one match.
struct MatchStart {
    /// data of the match; practice uses the data of `recording` instead
    std::shared_ptr<const MatchData> data;
    std::uint64_t seed = 1;
    Recording recording;
    int countdown = 0;    ///< length of the countdown before the match begins (s)
    std::string fault{};  ///< text on a fault for both players, shown for the first seconds; empty: none
    std::optional<Lessons> lessons{};           ///< lessons of the Apprentice, which is played on the
                                                ///< practice range
    std::vector<input::ProfileData> profile{};  ///< the players' own gestures (game/match/own_gestures.h)
};

/// Whether a fault with which a match begins is still shown after `played` ticks of play.
inline bool shows_fault(const std::string& fault, Tick played) {
    constexpr Tick shown_for = ticks(10.0);
    return !fault.empty() && played < shown_for;
}

/// Body of the simulation thread: plays one match until the session stops, or until the match's end or a
/// rematch is requested. Then it sets shared.progress.ended. It also sets shared.stop when the plan's time is
/// up. Calls `wake` whenever shared.progress has changed, so that the main thread looks.
void run_simulation(const LivePlan& plan, LiveShared& shared, MatchStart start,
                    const std::function<void()>& wake);

/// Body of the render thread: draws until shared.stop.
void run_render(const LivePlan& plan, LiveShared& shared, render::Window& window);

}  // namespace thaum::game::inline live
