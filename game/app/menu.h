// game/app/menu.h: the start screen, the pause and the pages below them: plain data and one pure step, (state, event) ->
// state. Nothing here knows a window or the match; who runs it (live_menu.cpp) looks at `wish` and at what became of the
// settings.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "game/app/bindings.h"
#include "game/hud/menu.h"

namespace thaum::app {

/// What a player has in hand: the keyboard and mouse, half of the keyboard, or one of the window's pads.
struct Device {
    input::DeviceKind kind{};
    int pad = 0;
    bool operator==(const Device&) const = default;
};

enum class Page : std::uint8_t {
    start,
    pause,
    sheets,    ///< whose controls?
    bindings,  ///< those of one sheet
    settings,
    cauldron,  ///< what a hand feels of it
};

struct MenuEvent {
    enum class Kind : std::uint8_t {
        up,
        down,
        page_up,
        page_down,
        left,
        right,
        confirm,
        other,  ///< a press that means nothing in a menu: it joins, and starts
        back,
        point,    ///< at a row, with the mouse
        control,  ///< any control at all, while one is waited for
        gone,     ///< the device was unplugged
    };
    Kind kind{};
    Device device{};
    std::optional<std::size_t>
        row{};  ///< of confirm, left, right and point: the row instead of the chosen one
    input::Control control{};
};

/// What there is to choose from. `levels` and `rules` are not empty.
struct MenuFacts {
    struct Rules {
        std::string name, label;
    };
    std::vector<int> levels{};
    std::vector<Rules> rules{};
    std::array<std::string, 4> pads{};  ///< names; empty: not plugged in
    std::string arm{};                  ///< that who plays by mouse holds, and how it is; empty: none
    bool practice = false;              ///< the pause is one of the range
    bool ends_match = false;  ///< leaving the pause goes to the start screen, not out of the program
};

enum class MenuWish : std::uint8_t { none, start, range, go_on, leave, quit };

struct MenuState {
    struct Open {
        Page page{};
        std::size_t cursor = 0;
    };
    std::vector<Open> pages;  ///< the last one shows; empty: no menu
    std::array<std::optional<Device>, game::players> seats;
    std::size_t level = 0, rules = 0;  ///< indices of the facts' lists
    std::size_t dummy = 0;             ///< game::DummyKind of the range
    std::size_t sheet = 0;             ///< of the bindings page
    std::size_t whose = 0;             ///< player of the cauldron's page
    std::optional<Slot> waiting;       ///< for its new control
    Settings settings;
    std::optional<Settings> undo;  ///< the settings before the last change of bindings
    std::string head, line;        ///< of the pause: who, and why
    std::string note;              ///< what the last event did, or why it could not
    MenuWish wish{};               ///< what the last event asks for
};

/// Opens a page on a menu that is closed.
MenuState opened(MenuState state, Page page);

MenuState step(MenuState state, const MenuEvent& event, const MenuFacts& facts);

/// Does Esc end the wait for a control? Not where it may be the very key that is wanted: to pause.
bool esc_ends_waiting(const MenuState& state);

/// What it looks like.
game::MenuPicture picture_of(const MenuState& state, const MenuFacts& facts);

/// "Mouse and keyboard", "Half of the keyboard", "Pad 2 (Xbox 360 Controller)".
std::string name_of(const Device& device, const MenuFacts& facts);

}  // namespace thaum::app
