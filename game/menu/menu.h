// game/menu/menu.h: the start screen, the pause and the pages below them, as plain data and one pure
// function: (state, event) -> state. The menu depends on neither the window nor the match. Its caller
// (live/menu.h) passes on MenuState::request and changed settings.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/hud/menu.h"
#include "game/range/practice.h"
#include "game/settings/bindings.h"
#include "game/settings/feel_profile.h"

namespace thaum::game::inline menu {

/// Device that a player uses: the keyboard and mouse, half of the keyboard, or one of the window's pads.
struct Device {
    input::DeviceKind kind{};
    int pad = 0;
    bool operator==(const Device&) const = default;
};

/// Names of the pages that the menu's caller asks about. Each page is a value in
/// a file of its own (menu/page.h).
namespace page_name {
inline constexpr std::string_view start = "start";
inline constexpr std::string_view pause = "pause";
inline constexpr std::string_view pad_setup = "pad_setup";  ///< page that asks for the controls of a joystick
inline constexpr std::string_view mixer = "mixer";          ///< page with the strengths of all that one
                                                            ///< player feels
}  // namespace page_name

struct MenuEvent {
    enum class Kind : std::uint8_t {
        up,
        down,
        page_up,
        page_down,
        left,
        right,
        confirm,
        other,  ///< a press of a control without another meaning: lets its device join, or starts the match
        back,
        point,      ///< the mouse points at a row of the menu
        control,    ///< any control was pressed, while the menu waits for one to bind
        gone,       ///< the device was unplugged
        character,  ///< a character was typed, while the menu asks for a name
        erase,      ///< the key that deletes the last typed character
    };
    Kind kind{};
    Device device{};
    std::optional<std::size_t>
        row{};  ///< the row that confirm, left, right and point are about; std::nullopt: the chosen row
    input::Control control{};
    char32_t typed{};  ///< the typed character, for Kind::character
};

/// Choices that the menu offers. `bots`, `rules` and `arenas` are never empty.
struct MenuContext {
    /// A data file: its name without folder and extension, and its label in the menu.
    struct Named {
        std::string name, label;
        std::string fault{};  ///< what is wrong with the file; empty: it can be chosen
        std::string words{};  ///< what the menu says of it; empty: only what the row says of itself
    };
    std::vector<Named> bots{};  ///< the weakest first
    std::vector<Named> rules{};
    std::vector<Named> arenas{};
    std::vector<Named> mutators{};
    WandNames wands{};
    std::array<std::string, 4> pads{};  ///< names of the pads; empty: not plugged in
    /// Name and state of the real arm of the player with the mouse, then of the other player; empty: no arm.
    std::array<std::string, players> arms{};
    bool practice = false;     ///< true: the pause belongs to the practice range
    bool apprentice = false;   ///< true: the pause belongs to the lessons on the practice range (the
                               ///< Apprentice)
    bool first_start = false;  ///< true: the start screen offers the lessons on the practice range first
    bool ends_match = false;   ///< true: leaving the pause opens the start screen; false: it ends the program
    std::string missing{};     ///< why the pause cannot end (whose pad is not plugged in); empty: it can
    std::string half_for{};    ///< player who may go on with half of the keyboard; empty: nobody
    std::string sound{};       ///< state of the loudspeakers, or why nothing is heard
    std::array<std::string, players>
        jackets{};                        ///< state of each player's jacket; empty: the player has none
    std::vector<std::string> gestures{};  ///< gestures of the match; empty: the rule set has none
    std::uint32_t drawn_gesture = 0;      ///< number of the gesture that is being drawn anew, plus 1; 0: none
    std::vector<FeelProfile> profiles{};  ///< profiles (sets of strengths) that players have saved on the
                                          ///< profiles (sets of strengths) that players have saved on the
                                          ///< mixer's page (strengths of all that is felt)
    /// the mixer's page.
    std::vector<tactile::Purpose> body{};
    std::vector<std::string>
        sticks{};  ///< names of joysticks that are no pads, because SDL does not know them
    std::vector<std::string> own_pads{};    ///< names of pads that were set up by hand
    std::vector<std::string> pad_faults{};  ///< a line for each joystick that cannot be used
    std::string pad_question{};      ///< question for the control that the set-up of a joystick asks for
    bool pad_needs_control = false;  ///< true: the control in `pad_question` cannot be left out
    /// Text of the start screen on faulty settings or data files; empty: there is no fault.
    std::string start_fault{};
};

enum class MenuRequest : std::uint8_t {
    none,
    start,
    range,
    apprentice,
    go_on,
    take_half,
    ask_match,  ///< passes the request in MenuState::match_request on to the running match
    forget_gesture,
    set_up_pad,
    skip_control,
    forget_pad,
    restart,
    leave,
    quit
};

/// Request to play an effect on a player's body, so that the player feels how strong it is.
struct BodyTrialWish {
    std::size_t player = 0;
    tactile::Purpose purpose{};
};

/// Kind of text that is being typed.
enum class Typing : std::uint8_t { name, profile };

struct MenuState {
    struct Open {
        std::string_view page{};  ///< name of a registered page
        std::size_t cursor = 0;
        std::size_t middle = 0;  ///< row that is kept in the middle of a page too long for the screen; the
                                 ///< mouse moves only `cursor`, so that the page does not scroll under it
    };
    std::vector<Open> pages;  ///< open pages of the menu, the shown page last; empty: the menu is closed
    std::array<std::optional<Device>, players> seats;
    /// Row at which the next pause opens. It is the row of a gesture that was drawn or forgotten, since
    /// players often do that several times.
    std::size_t pause_row = 0;
    std::optional<Device> chooser;  ///< device that chose the row; std::nullopt: none has chosen one yet
    std::size_t bot = 0, rules = 0, arena = 0;  ///< chosen entries: indices into lists of MenuContext
    /// Chosen mutators by name.
    std::vector<std::string> mutators{};
    std::size_t dummy = 0;    ///< kind of the range's practice dummy (DummyKind)
    RangeChanges range{};     ///< changes of the practice range's rules, such as endless
                              ///< energy
    std::size_t gesture = 0;  ///< chosen gesture, an index into MenuContext::gestures
    /// index of the sheet (the bindings of one kind of device, or of the session) on the bindings page
    std::size_t sheet = 0;
    /// Joystick that is set up, or pad that is forgotten: index into
    /// MenuContext::sticks, and own_pads after them.
    std::size_t stick = 0;
    std::size_t player = 0;             ///< player whose settings a page shows
    std::optional<Slot> waiting;        ///< binding that waits for a new control; std::nullopt: none
    std::size_t profile = 0;            ///< index of the chosen profile in MenuContext::profiles
    std::optional<std::string> typing;  ///< words that are being typed; std::nullopt: none
    Typing typed{};                     ///< what is typed: the name of a player or of a profile
    Settings settings;
    std::optional<Settings> undo;        ///< settings before the last change of bindings, to undo it
    std::string head, line;              ///< title and reason of the pause: who paused, and why
    std::string note;                    ///< result of the last event, or why it had none, in words
    MenuRequest request{};               ///< what the last event asks the menu's caller to do
    std::optional<FeelProfile> saves{};  ///< profile (set of strengths) that the last event asks the caller
                                         ///< to save
    MatchRequest match_request{};  ///< request that MenuRequest::ask_match passes on to the running match
    std::optional<BodyTrialWish> tries{};  ///< effect that the last event asks the caller to play
};

/// Opens a page on a menu that is closed.
MenuState opened(MenuState state, std::string_view page);

MenuState step(MenuState state, const MenuEvent& event, const MenuContext& context);

/// Tests whether Esc ends the wait for a control. It does not if the wait is for a control of the action
/// `pause`, because Esc may be the wanted key.
bool esc_ends_waiting(const MenuState& state);

/// Note for the players that says why the pause cannot end.
std::string words_of_refusal(const MenuContext& context);

/// Description of everything that is to be drawn of the menu.
MenuPicture picture_of(const MenuState& state, const MenuContext& context);

/// Title of the window: "Thaum", and with a menu its page and the chosen row, for screen readers and for
/// those who look at another window: "Thaum: Settings / Split: side by side", "Thaum (paused): Go on". For
/// rows of the start screen and of the pause the title names no page.
std::string window_title(const MenuState& state, const MenuContext& context);

/// Moves the cursors of all open pages so that they stay on the rows on which they were in the context
/// `before`. Otherwise a new context with more or fewer rows would put another row under a cursor just before
/// a press.
MenuState on_same_rows(MenuState state, const MenuContext& before, const MenuContext& context);

/// Name of a device: "Mouse and keyboard", "Keypad and arrows", "Pad 2 (Xbox 360 Controller)".
std::string name_of(const Device& device, const MenuContext& context);

}  // namespace thaum::game::inline menu
