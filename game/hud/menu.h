// game/hud/menu.h: menus as plain data, and how they are drawn: a title, a seat for each player, and a column
// of rows. Label and value share a row as their lengths require, text shrinks to fit, and rows scroll, so
// every text size fits every window.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "game/hud/hud.h"
#include "game/picture/picture.h"

namespace thaum::game::inline hud {

struct MenuRow {
    std::string label{};
    std::string help{};  ///< what the row does, in one sentence; shown while the row is chosen
    std::string value{};
    /// Longest value that the row may have, so that the arrows do not move when the value changes.
    std::string longest_value{};
    bool adjustable = false;  ///< true: arrows beside the value decrease and increase it
    bool dim = false;         ///< true: the row has no effect at present
    bool operator==(const MenuRow&) const = default;
};

/// One player's place on the start screen: the names of the player and of the device, drawn with the team's
/// mark.
struct MenuSeat {
    std::string head{}, device{};
    bool taken = false;
    bool operator==(const MenuSeat&) const = default;
};

struct MenuPicture {
    std::string title;  ///< title of the menu; empty: no menu is open
    std::string line;   ///< large line below the title
    std::vector<MenuSeat> seats;
    std::vector<MenuRow> rows;
    std::size_t cursor = 0;  ///< index of the chosen row
    std::size_t middle = 0;  ///< index of the row around which the visible rows are chosen if not all fit
    std::string note;        ///< message about the last action
    std::string hint;        ///< help about the keys
    /// Strengths of the cells of a body figure beside the title, 0 to 1 (game/picture/picture.h);
    /// std::nullopt: no figure.
    std::optional<std::array<float, figure_cells>> figure{};
    bool operator==(const MenuPicture&) const = default;
};

/// Part of a menu row that a point can hit: the row, or the arrow that decreases or increases its value.
enum class MenuPart : std::uint8_t { row, less, more };
struct MenuPlace {
    std::size_t row{};
    MenuPart part{};
};

/// Returns the part of a row at a point (px from the top left); std::nullopt if the point is on no row.
std::optional<MenuPlace> place_at(const MenuPicture& menu, render::Size size, double text_scale, fvec2 point);

void add_menu(render::Overlay& out, const MenuPicture& menu, render::Size size, double text_scale);

/// Frame with the empty arena, which is the background of menus outside of a match. It has no overlay. The
/// camera looks from above and has turned by `angle` around the arena (rad). The frame points into `memory`
/// and is valid until the next call.
const render::Frame& make_arena_frame(const ArenaScene& arena_scene, const Picture& picture, double angle,
                                      const HudSettings& settings, render::Size size, FrameMemory& memory);

}  // namespace thaum::game::inline hud
