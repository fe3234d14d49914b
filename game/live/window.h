// game/live/window.h: the loops of a live session's main thread. They pass the events of the window, the
// states of the pads and the time to the session.
#pragma once
#include "game/live/session.h"
#include "input/pads.h"

namespace thaum::game::inline live {

/// Window and pads of a session, and what the loops remember of them from one poll to the next.
struct LiveWindow {
    render::Window& window;
    input::PadReader& pads;
    std::vector<std::string> pad_faults{};  ///< faults of the file with the user's own mappings of pads
    bool fullscreen = false;
    std::string title = "Thaum";               ///< what the window's title says
    std::vector<input::LockedStick> locked{};  ///< joysticks that this user may not read
    std::int64_t look_for_locked_ns = 0;       ///< time of the next search for locked joysticks (ns)
};

/// Shows the start screen until a player starts a match (returns true) or leaves the program (returns false).
bool run_start_screen(LiveSession& session, LiveShared& shared, LiveWindow& window);

/// Handles input until the match of the simulation thread has ended.
void run_match(LiveSession& session, LiveShared& shared, LiveWindow& window);

}  // namespace thaum::game::inline live
