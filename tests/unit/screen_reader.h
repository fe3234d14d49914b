// unit/screen_reader.h: what a person sees of a session at one moment: the texts on the screen with their
// places, the marks around the crosshair, and the objects in view that nothing hides. The texts come from the
// same overlay that the window draws. A scripted player that gets nothing else (screen_player.h) shows
// whether the screen alone is enough to play.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/live/shared.h"

namespace thaum::game::screen {

/// Parts of the screen, which a person distinguishes by where they are.
enum class Part : std::uint8_t {
    menu,
    score,     ///< score and clock; in the guided lessons, the step and its progress
    lesson,    ///< text of a step of the guided lessons, and its hint
    messages,  ///< captions and prompts
    crosshair,
    strip,   ///< the strip of wands: the name and energy of the wand in hand, and the keys
    name,    ///< the player's name
    feed,    ///< the list of recent deaths
    result,  ///< the panel after a round
    other
};

/// One line of text.
struct Words {
    Part part{};
    std::string text;
    /// Position of the text: at half its height, and at its left end, middle or right end (px).
    fvec2 place{};
    bool chosen = false;  ///< true: the label of the chosen row of a menu
};

/// An object in view that nothing hides.
struct Sight {
    std::string_view what;  ///< name of the object: "wizard", "crate", "anchor", "ingredient", ...
    fvec2 place{};          ///< middle of the object in the window (px)
    /// Height of the object in the window, by which a person judges the distance (px).
    float high{};
};

/// The nearest surface in one direction of the view.
struct Surface {
    std::string_view what;  ///< name of the surface: "floor", "wall", "pit", ...; empty: the sky
    float far{};            ///< distance from the eye (m)
};

/// The view at a glance: the nearest surfaces in a grid, with rows from the top and columns from the left.
inline constexpr std::size_t glance_rows = 5, glance_columns = 9;
using Glance = std::array<std::array<Surface, glance_columns>, glance_rows>;

struct Screen {
    render::Size size{};
    std::vector<Words> words;
    /// false: a menu covers the view, or there is no match; then all members below are empty.
    bool shows_view = false;
    std::vector<Sight> sights;
    Glance glance{};
    fvec2 crosshair{};
    game::TargetKind mark{};       ///< shape of the mark around the crosshair
    float ring{};                  ///< filled share of the ring around the crosshair
    bool holds = false;            ///< true: a beam or a rope leaves the wand
    std::optional<fvec2> arc_end;  ///< end of the drawn arc of a shot, if it is in view (px)
    /// Direction of the mark of a recent hit on the player, clockwise from straight ahead (rad).
    std::optional<float> hurt_from;
    float horizon{};            ///< height of the horizon in the window (px from the top)
    std::vector<float> energy;  ///< filled shares of the energy bars in the strip of wands, by slot
    bool dead = false;

    /// All texts of a part, joined to one line.
    std::string words_of(Part part) const;
    bool has_words(Part part) const;
};

/// The parts of a session that are shown: its newest picture and screen, and the match, by which objects hide
/// one another. `match` is null on the start screen.
struct Shown {
    const game::Picture& picture;
    const game::Screen& screen;
    const game::PromptUses& prompt_uses;
    const game::Simulation* match;
    render::Size size{};
};

/// Returns the screen as player 1 sees it.
Screen look_at(const Shown& shown);

}  // namespace thaum::game::screen
