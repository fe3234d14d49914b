// game/app/live_session.h: the main thread of a live session. Input from the window and the pads goes to the
// players' hands during play, and to the menu while a menu is open (live_menu.cpp). Some keys act on the
// session at any time.
#pragma once
#include "game/app/live_shared.h"
#include "game/app/menu.h"

namespace thaum::app {

/// State of the pad that one player uses.
struct PadHold {
    bool seen = false;          ///< the pad was plugged in at the last look
    bool let_go_first = false;  ///< true: buttons held now are ignored until all have been released
    bool half = false;          ///< the player continues with half of the keyboard
};

/// Repetition of a direction that is held in a menu.
struct Repeat {
    std::optional<MenuEvent> event{};
    int key = -1, pad = -1;  ///< key code or pad index of the held direction; -1: none
    std::int64_t next_ns = 0;
};

struct LiveSession {
    LiveSession(LiveShared& s, const LivePlan& p);

    LiveShared& shared;
    const LivePlan& plan;
    std::shared_ptr<const game::MatchData> data;  ///< data of the next match
    std::optional<game::RangeFiles> range;        ///< files of the range if the next match is practice
    MenuState menu;                               ///< menu state; its settings are the ones in force
    MenuContext menu_context;
    Settings seated;      ///< settings that the seats' DeviceSpecs were made from
    bool stale = true;    ///< true: shared.screen must be published again
    bool forces = false;  ///< true: the views show the forces that hands feel

    std::array<render::PadState, 4> pads{};
    std::array<PadHold, game::players> pad_holds{};
    Repeat repeat{};
    std::optional<fvec2> mouse{};  ///< last position of the mouse while a menu was open (px)
    /// time when the focus was lost; 0: the window has the focus, or the loss has been handled
    std::int64_t unfocused_since_ns = 0;
    std::int64_t over_since_ns = 0;  ///< time when the round ended; 0: the round goes on
};

/// Rules file in assets/rules that gives the length of a match.
inline std::string& length_of(game::DataChoice& choice) { return choice.match; }

/// Shows the start screen until a player starts a match (returns true) or leaves the program (returns false).
bool run_start_screen(LiveSession& session);

/// Makes the next match practice on the range. The error names file, line and key.
Expected<void> open_range(LiveSession& session);

/// Handles input until the match has ended.
void run_session(LiveSession& session);

// Functions shared by live_session.cpp and live_menu.cpp.

bool is_bound(const std::vector<input::Control>& controls, int key);
std::optional<std::uint32_t> first_person(const LiveShared& shared);
/// Leaves the match: to the start screen, or out of the program if the session began without one.
void leave_match(LiveSession& session);
/// Publishes shared.screen if something on it changed.
void publish_screen(LiveSession& session);
/// Gives all players' hands the bindings of the current settings.
void rebind_hands(LiveSession& session);

// Functions of the menu (live_menu.cpp). All but the last two are called only while a menu is open.

void menu_key(LiveSession& session, int key, bool pressed);
void menu_mouse_button(LiveSession& session, int button, bool pressed);
void menu_cursor(LiveSession& session, double x, double y);
void menu_wheel(LiveSession& session, double steps);
/// Handles the state of pad `place`; `before` is its state at the last call.
void menu_pad(LiveSession& session, int place, const render::PadState& before);
/// Repeats a direction that is held.
void repeat_menu(LiveSession& session);
void menu_event(LiveSession& session, const MenuEvent& event);
void open_pause(LiveSession& session);
/// Updates the pause's lines: who paused, and why.
void tell_pause(LiveSession& session);
/// Choices of the menu, read from the data folder.
MenuContext find_menu_context(const LivePlan& plan);

}  // namespace thaum::app
