// game/hud/layout.h: the places of the HUD's panels. Each panel has a box of its own, and no two boxes overlap at any
// size of the text or the window. Whatever a panel shows must stay in its box.
//
//     feed      |  score  |                the feed is in the outer corner beside the score
//                  likely                  the likely spell of a stroke
//     forces        notices      lesson    forces: the curve of F3; lesson: in a window with one view
//     heard     ring around the crosshair  heard: what is heard and felt in words
//                       aside               the card at the cauldron, where it has more room than below the ring
//                                 figure   what the body feels; not in a window with words of a lesson
//               messages                   captions, prompts, the brew in words
//     name, health           strip         the strip of wands
//
// A flat view (one of two stacked ones) has no room for messages above the corners, so they are between them.
// The bar of a replay is below all of this, in a band that the views leave free (game/hud/replay_bar.h).
#pragma once
#include <optional>

#include "game/hud/hud.h"

namespace thaum::game {

/// The panels of one player's view.
struct ViewLayout {
    render::Rect view;
    float unit{};    ///< length of a HUD unit (px)
    fvec2 centre{};  ///< the crosshair
    float ring{};    ///< largest radius around the crosshair (px): charge, marks of hurts, words of a warning
    Panel health, name;
    Panel strip;
    float strip_columns{};  ///< wands in one row of the strip
    Panel feed;
    Panel messages;
    Panel forces;   ///< the curve of the forces, or only the name of the strongest
    Panel figure;   ///< two torsos of figure_wide x figure_high units each; empty with words of a lesson
    Panel aside;    ///< right of the ring, for the card at the cauldron (rim_card.h); empty: there is no room
    Panel heard;    ///< empty if the curve of the forces leaves no room
    Panel likely;   ///< above the ring, for the likely spell of a stroke; empty: there is no room
    Panel strokes;  ///< round the crosshair, clear of the score and of two captions
};

/// All panels of a window.
struct HudLayout {
    std::array<std::optional<ViewLayout>, players> views;  ///< std::nullopt: the view is not shown
    float unit{};  ///< length of a unit in panels of the whole window (px)
    Panel score;
    Panel notices;  ///< lines for both players
    /// Words of the Apprentice's step; std::nullopt: none, or there are two views.
    std::optional<Panel> lesson;
    float count_size{};   ///< em of the seconds to the start, the same in all views (px)
    float lesson_size{};  ///< em of these words where they have room (px)
    std::optional<ReplayBarLayout> replay{};
};

/// Sizes of the strip (units of strip_unit).
inline constexpr float strip_cell_width = 40, strip_cell_height = 42, strip_head = 24, strip_margin = 4;

/// Length of a unit in the strip of wands (px). It is less than that of the view where the strip has little room.
float strip_unit(const ViewLayout& layout);

/// Size of the forces' panel where the view has room for it (units).
inline constexpr float forces_wide = 186, forces_high = 76;
/// Part of that panel that the name of the strongest force takes while there is no curve (units).
inline constexpr float force_word_wide = 96, force_word_high = 27;
/// Height of a line of what is heard (units).
inline constexpr float heard_line_high = 20;

/// What is shown beside the usual panels.
struct LayoutWishes {
    /// There are words of a lesson. In an only view the other panels then grow only as far as its words have room.
    bool lesson = false;
    /// Players at a station. In a tall view the ring then leaves room below it for the card (rim_card.h).
    std::array<bool, players> cards{};
};
HudLayout lay_out(const HudSettings& settings, render::Size window, std::size_t wands,
                  const LayoutWishes& wishes = {});

/// Words in lines that fit a box.
struct FittedWords {
    std::vector<std::string> lines;
    float size{};  ///< em (px)
    /// Distance from the top of one line to the top of the next (px).
    float line_height() const { return line_spacing * size; }
    float height() const { return static_cast<float>(lines.size()) * line_height(); }

    static constexpr float line_spacing = 1.4F;
};

/// Width of a line of text, for laying it out (px). Real lines are seldom wider.
float width_of(std::string_view line, float size);

/// Breaks words at spaces, or between groups that three spaces part, into lines for a box `room` wide and high (px).
/// The em is `size`, or as much less as the words need.
FittedWords fit(std::string_view words, float size, fvec2 room);

}  // namespace thaum::game
