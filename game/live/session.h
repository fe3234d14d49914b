// game/live/session.h: the main thread of a live session, without its window and its clock. The session is
// made of parts, which own their state:
//
//     PlayerHands  input of the players, and which device each of them uses
//     LiveMenu     the menu, the settings in force and the choices for the next match
//     FocusLoss    the window's focus, whose loss pauses
//     RoundEnd     the time since the round's end
//     NextMatch    data of the next match
//     PadSetup     joysticks that cannot be used
//     ReplayViewer keys and mouse of a shown replay
//
// Events and times (ns, monotonic clock) are arguments (live/window.cpp passes those of the window), so that
// a test can drive a whole session. Requests to the match and its state pass through LiveShared.
#pragma once
#include "game/live/body_trial.h"
#include "game/live/hands.h"
#include "game/live/menu.h"
#include "game/live/next_match.h"
#include "game/live/pad_setup.h"
#include "game/live/shared.h"

namespace thaum::game::inline live {

/// What each press of the key F3 makes the views show in turn, besides the game itself.
enum class Insight : std::uint8_t {
    none,
    forces,       ///< the forces that hands feel, and the brew's flow
    frame_times,  ///< the times of each part of a picture
};

class LiveSession {
public:
    LiveSession(LiveShared& shared, const LivePlan& plan);

    const LivePlan& plan() const { return plan_; }
    const LiveMenu& menu() const { return menu_; }
    NextMatch& next() { return next_; }
    /// Gestures that players of the next match have recorded themselves. Call take_seats() first.
    const std::vector<input::ProfileData>& profile() const { return profile_; }
    /// Header of the log of the next match. Call take_seats() first.
    input::LogHeader log_header(std::uint64_t seed) const;

    // Events of the window. They go to the collectors of the players' input during play, and to the menu
    // while a menu is open. Some keys act on the session at any time.
    void key(int key, bool pressed, std::int64_t now_ns);
    void character(char32_t character);
    void mouse_button(int button, bool pressed, render::Size window, std::int64_t now_ns);
    void mouse_move(double right, double down, std::int64_t now_ns);
    void cursor(fvec2 position, render::Size window);
    void wheel(double steps, std::int64_t now_ns);
    void focus(bool focused, std::int64_t now_ns);

    // The next functions serve the start screen.
    void open_start_screen(std::int64_t now_ns);
    /// Call it after each poll of window and pads for events. Returns whether a match must start.
    bool step_start_screen(const Pads& pads, std::int64_t now_ns);

    // The next functions serve a match.
    /// Gives the players of the next match their seats and arms.
    void take_seats(const Pads& pads);
    /// Begins a match, whose simulation thread may run already.
    void begin_match(const Pads& pads);
    /// Call it after each poll of window and pads for events. `pads`: std::nullopt if needs_pads() is false.
    void step_match(const std::optional<Pads>& pads, std::int64_t now_ns);
    /// Returns whether the menu has asked to begin the ended match again, and forgets that it has.
    bool take_restart() { return std::exchange(restarts_, false); }

    /// Tells which joysticks cannot be used, while a menu is open. Returns what the reader of pads must
    /// change.
    std::optional<PadChange> look_at_sticks(IdleSticks sticks) {
        return setup_.follow(std::move(sticks), menu_);
    }
    /// Reports whether the reader of pads has made the change.
    void end_pad_setup(const PadChange& change, const Expected<void>& taken) {
        setup_.end(change, taken, menu_);
    }

    /// Publishes shared.screen if something on it has changed.
    void publish_screen();

    /// Whether the states of the pads are needed at present.
    bool needs_pads() const { return menu_.is_open() || hands_.any_pad(); }
    /// Whether the cursor is hidden and its motion turns a player.
    bool captures_cursor() const;
    /// Time that the window may wait for events (s).
    double patience_s() const;

private:
    // Handling of keys that act on the session.
    bool session_key(int key);
    void replay_key(int key);
    void match_key(int key, std::int64_t now_ns);
    void key_after_round(int key, std::int64_t now_ns);
    void leave_match();

    template <class F>
    void give_hands(std::int64_t now_ns, F&& f);
    void report(const HandNews& news);
    void wait_for_lost_pads();
    void look_at_pads(const Pads& plugged, std::int64_t now_ns);
    bool leaves_by_pad(const Pads& before, const Pads& pads) const;
    void share_motors();
    void share_motors_of_start_screen();
    void pause_without_focus(std::int64_t now_ns);
    void name_arms();
    void follow_match(std::int64_t now_ns);
    void carry_out_request();
    void restart();
    void play_trial(std::int64_t now_ns);
    void load_profile();
    std::filesystem::path folder_of_gestures() const;
    void take_drawn_gesture();
    void forget_gesture();
    PauseFacts pause_facts() const;
    PlayerNames names() const;
    void apply_settings();
    Screen screen() const;

    // The next functions serve the start screen.
    bool succeeds(const Expected<void>& result);
    Expected<void> load_chosen();
    void follow_arena();
    void show_arena();
    bool out_of_time(std::int64_t now_ns) const;

    LiveShared& shared_;
    const LivePlan& plan_;
    NextMatch next_;
    LiveMenu menu_;
    PlayerHands hands_;
    PadSetup setup_;
    std::optional<ReplayViewer> viewer_{};  ///< viewer of the shown replay; std::nullopt: no replay is shown
    FocusLoss focus_{};
    RoundEnd round_end_{};
    bool restarts_ = false;         ///< true: the menu has asked to begin the match again once it has ended
    bool paused_by_focus_ = false;  ///< true: the window's lost focus is the reason of the pause
    Pads pads_{};                   ///< states of the pads at the last look
    std::vector<input::ProfileData> profile_{};  ///< gestures that persons among the players recorded
    /// trials of effects for the mixer's page (strengths of all that is felt); std::nullopt: nothing is felt
    /// on the body
    std::optional<BodyTrial> trial_{};
    /// what F3 makes the views show besides the game: nothing, forces, or times of the pictures
    Insight insight_ = Insight::none;
    std::optional<Screen> published_{};       ///< the newest published screen
    std::optional<std::int64_t> began_ns_{};  ///< time when the start screen first opened (ns)
};

}  // namespace thaum::game::inline live
