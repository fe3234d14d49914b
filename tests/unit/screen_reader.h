// unit/screen_reader.h: what a person sees of a session at one moment: the words on the screen with their places, the
// marks around the crosshair, and the things in the view that nothing hides. The words come from the very overlay
// that the window draws. A scripted player that is given nothing else (screen_player.h) shows whether the screen is
// enough to play by.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/live/shared.h"

namespace thaum::app::screen {

/// Parts of the screen. A person tells them apart by their place.
enum class Part : std::uint8_t {
    menu,
    score,     ///< score and clock; in the Apprentice the step and how far it is done
    lesson,    ///< words of the Apprentice's step, and its hint
    messages,  ///< captions and prompts
    crosshair,
    strip,   ///< the strip of wands: the name and energy of the wand in hand, and the keys
    name,    ///< the player's name
    feed,    ///< deaths
    result,  ///< the panel after a round
    other
};

/// One line of words.
struct Words {
    Part part{};
    std::string text;
    fvec2 place{};        ///< middle of the text's height at its left, middle or right (px)
    bool chosen = false;  ///< true: the label of the chosen row of a menu
};

/// A thing in the view that nothing hides.
struct Sight {
    std::string_view what;  ///< "wizard", "crate", "anchor", "ingredient", ...
    fvec2 place{};          ///< its middle in the window (px)
    float high{};           ///< its height in the window (px), by which a person knows how far it is
};

/// The nearest surface in one direction of the view.
struct Surface {
    std::string_view what;  ///< "floor", "wall", "pit", ...; empty: the sky
    float far{};            ///< distance from the eye (m)
};

/// The view as a person takes it in at a glance: the nearest surfaces in rows from the top and columns from the left.
inline constexpr std::size_t glance_rows = 5, glance_columns = 9;
using Glance = std::array<std::array<Surface, glance_columns>, glance_rows>;

struct Screen {
    render::Size size{};
    std::vector<Words> words;
    bool shows_view = false;  ///< false: a menu covers it, or there is no match; then all below is empty
    std::vector<Sight> sights;
    Glance glance{};
    fvec2 crosshair{};
    game::TargetKind mark{};       ///< shape of the mark around the crosshair
    float ring{};                  ///< filled share of the ring around the crosshair
    bool holds = false;            ///< a beam or a rope leaves the wand
    std::optional<fvec2> arc_end;  ///< end of the drawn arc of a shot (px), if it is in the view
    std::optional<float> hurt;     ///< direction of the mark of a recent hurt, clockwise from ahead (rad)
    float horizon{};               ///< height of the horizon in the window (px from the top)
    std::vector<float> energy;     ///< shares of the bars in the strip of wands, by slot
    bool dead = false;

    /// All words of a part in one line.
    std::string words_of(Part part) const;
    bool has_words(Part part) const;
};

/// Parts of a session that the renderer shows: its newest picture and screen, and the match for hiding one thing by
/// another. `match` is null on the start screen.
struct Shown {
    const game::Picture& picture;
    const app::Screen& screen;
    const game::PromptUses& prompt_uses;
    const game::Simulation* match;
    render::Size size{};
};

/// Returns the screen as player 1 sees it.
Screen look_at(const Shown& shown);

}  // namespace thaum::app::screen
