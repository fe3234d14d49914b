// game/live/replay_view.h: what a viewer of a replay can do with keys and mouse,
// apart from window, threads and clock.
#pragma once
#include <atomic>
#include <optional>
#include <span>
#include <string>

#include "game/hud/hud.h"

namespace thaum::game::inline live {

enum class ReplayDeed : std::uint8_t {
    pause,  ///< pauses or goes on; at the end starts again
    back,
    forward,
    slower,
    faster,
    begin,
    end,
    previous_kill,
    next_kill,
    step,
    step_back,
    eyes,  ///< shows the next view: both players', the first's or the second's
};

/// Action of a key in a replay; std::nullopt: none. These keys are fixed, since they act in replays only.
std::optional<ReplayDeed> replay_deed_of(int key);
/// Words for the screen on what the keys do.
std::string replay_keys();

/// The viewer's choices in a replay: moment, speed, pause and views.
struct ReplayView {
    Tick at{};  ///< tick that is shown, or target of a jump that is not done yet
    double speed = 1;
    bool paused = false;
    Watch watch = Watch::both;
    bool operator==(const ReplayView&) const = default;
};

inline constexpr double slowest_replay = 0.25, fastest_replay = 16;
inline constexpr Tick replay_jump = 5000;  ///< length of a jump by the keys for jumps (ticks)
inline constexpr Tick replay_step = 16;    ///< length of a single step: one picture at 60 Hz (ticks)
inline constexpr Tick before_kill = 2000;  ///< a jump to a kill ends this long before the kill (ticks)
/// Least length of a jump back to a kill (ticks). The jump leads to `before_kill` ticks before a kill. A kill
/// is skipped if that place is nearer than this, so that repeated jumps lead to ever earlier kills.
inline constexpr Tick same_kill = 1000;

/// The viewer's choices after an action by a key (`deed`). `length`: ticks of the log; `kills`: the kills
/// that are known, sorted by tick.
ReplayView after(ReplayView view, ReplayDeed deed, Tick length, std::span<const Kill> kills);

/// Requests of the main thread to the simulation thread that shows a replay.
struct ReplayRequests {
    static constexpr Tick nowhere = ~Tick{0};
    /// Tick to go to. The simulation thread sets it to `nowhere` once it is there.
    std::atomic<Tick> target{nowhere};
    std::atomic<double> speed{1};
    std::atomic<bool> paused{false};
    std::atomic<Tick> now{0};  ///< tick of the newest picture, from the simulation thread
};

/// The main thread's side of a shown replay: turns keys and mouse into requests.
class ReplayViewer {
public:
    /// `length`: ticks of the log; `names`: the players' names on the screen.
    ReplayViewer(const ReplayIndex& index, Tick length, ReplayRequests& requests, PlayerNames names = {});

    const PlayerNames& names() const { return names_; }

    void key(int key);
    void mouse_button(int button, bool pressed, render::Size window, double text_scale);
    /// Tells the viewer where the cursor is. `place`: from the top left of the window (px).
    void cursor(fvec2 place, render::Size window, double text_scale);

    Watch watch() const { return watch_; }
    ReplayBar bar() const;

private:
    void go_to_cursor(render::Size window, double text_scale);

    const ReplayIndex& index_;
    Tick length_;
    ReplayRequests& requests_;
    PlayerNames names_;
    Watch watch_ = Watch::both;
    fvec2 cursor_{};
    bool drags_ = false;  ///< true: the mouse button went down on the time bar and is still held
};

}  // namespace thaum::game::inline live
