// game/hud/menu.h: menus as plain data, and how they are drawn: a title, two seats, a column of rows. Words shrink before they
// leave their place, and rows scroll, so every size of text fits every window.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "game/hud/hud.h"

namespace thaum::game {

struct MenuRow {
    std::string label{}, value{};
    bool adjustable = false;  ///< arrows around the value: less and more
    bool dim = false;         ///< of no effect just now
    bool operator==(const MenuRow&) const = default;
};

/// A place for a player, drawn with the team's mark.
struct MenuSeat {
    std::string head{}, device{};
    bool taken = false;
    bool operator==(const MenuSeat&) const = default;
};

struct MenuPicture {
    std::string title;  ///< empty: no menu is open
    std::string line;   ///< large, below the title
    std::vector<MenuSeat> seats;
    std::vector<MenuRow> rows;
    std::size_t cursor = 0;  ///< the chosen row
    std::string note;        ///< what just happened
    std::string hint;        ///< which keys do what
    bool operator==(const MenuPicture&) const = default;
};

/// What of a row is at a point.
enum class MenuPart : std::uint8_t { row, less, more };
struct MenuPlace {
    std::size_t row{};
    MenuPart part{};
};

/// px from the top left; nothing beside the rows.
std::optional<MenuPlace> place_at(const MenuPicture& menu, render::Size size, double text_scale, fvec2 point);

void add_menu(render::Overlay& out, const MenuPicture& menu, render::Size size, double text_scale);

/// The court from above, seen from a camera that has gone `angle` rad around it; with no overlay. For
/// menus outside of a match. The frame lives in `memory` until the next call.
const render::Frame& make_court_frame(const Court& court, const Picture& picture, double angle,
                                      const HudSettings& settings, render::Size size, FrameMemory& memory);

}  // namespace thaum::game
