// game/app/live_desk.h: the main thread of a live session. What comes from the window and the pads goes to the players' hands
// while they play, to the menu while one is open (live_menu.cpp), and some keys to the session at any time.
#pragma once
#include "game/app/live_shared.h"
#include "game/app/menu.h"

namespace thaum::app {

/// What a player with a pad holds now.
struct Grip {
    bool seen = false;  ///< the pad was there
    bool let_go_first =
        false;          ///< what is held now is not for the match: nothing is until all buttons were let go
    bool half = false;  ///< plays on with half of the keyboard
};

/// A direction that is held in a menu repeats.
struct Repeat {
    std::optional<MenuEvent> event{};
    int key = -1, pad = -1;  ///< who holds it
    std::int64_t next_ns = 0;
};

struct Desk {
    Desk(LiveShared& s, const LivePlan& p);

    LiveShared& shared;
    const LivePlan& plan;
    std::shared_ptr<const game::MatchData> data;  ///< of the next match
    std::optional<game::RangeFiles> range;        ///< the next match is practice, with these
    MenuState menu;                               ///< its settings are those that hold
    MenuFacts facts;
    Settings seated;       ///< the settings that the DeviceSpecs were made from
    bool stale = true;     ///< shared.screen is not as it should be
    bool forces = false;   ///< the views show what hands feel
    std::string arm_says;  ///< what is wrong with the arm, if anything

    std::array<render::PadState, 4> pads{};
    std::array<Grip, game::players> grips{};
    Repeat repeat{};
    std::optional<fvec2> mouse{};         ///< px; where it was last, while a menu was open
    std::int64_t unfocused_since_ns = 0;  ///< 0: has the focus, or its loss was dealt with
    std::int64_t over_since_ns = 0;       ///< 0: the round is not over
};

/// The part of the choice of data that says how long a match is: a file in assets/rules.
inline std::string& length_of(game::DataChoice& choice) { return choice.match; }

/// Until somebody starts a match (true) or leaves the program.
bool run_start_screen(Desk& desk);

/// The next match is practice. The error names file, line and key.
Expected<void> open_range(Desk& desk);

/// Until the match has ended.
void run_desk(Desk& desk);

// Shared by live_desk.cpp and live_menu.cpp.

bool is_bound(const std::vector<input::Control>& controls, int key);
std::optional<std::uint32_t> first_person(const LiveShared& shared);
/// Out of the match: to the start screen, or out of the program.
void leave_match(Desk& desk);
/// Shows what changed.
void publish_screen(Desk& desk);
/// All players' hands, with the settings of now.
void rebind_hands(Desk& desk);

// The menu's part (live_menu.cpp). All but the last two are for while a menu is open.

void menu_key(Desk& desk, int key, bool pressed);
void menu_mouse_button(Desk& desk, int button, bool pressed);
void menu_cursor(Desk& desk, double x, double y);
void menu_wheel(Desk& desk, double steps);
/// What pad `place` does now, which did `before` at the last call.
void menu_pad(Desk& desk, int place, const render::PadState& before);
/// Directions that are held.
void repeat_menu(Desk& desk);
void menu_event(Desk& desk, const MenuEvent& event);
void open_pause(Desk& desk);
/// Who paused, and why, as it is now.
void tell_pause(Desk& desk);
/// What there is to choose from, from the data folder.
MenuFacts find_facts(const LivePlan& plan);

}  // namespace thaum::app
