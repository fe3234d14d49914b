// game/hud/layout.h: the places of the HUD's panels. Each panel has a box of its own, and no two boxes
// overlap at any size of the text or the window. Whatever a panel shows must stay in its box.
//
//     feed      |  score  |                the feed is in the outer corner beside the score
//                  likely                  the likely spell of a stroke
//     forces        notices      lesson    forces: the curve of F3; lesson: in a window with one view
//     heard     ring around the crosshair  heard: what is heard and felt in words
//                       aside               the card at the cauldron, if it has more room than below the ring
//                                 figure   what the body feels; not in a window with words of a lesson
//               messages                   captions, prompts, the brew in words
//     name, health           strip         the strip of wands
//
// A flat view (one of two stacked ones) has no room for messages above the corners, so they are between them.
// The bar of a replay is below all of this, in a band that the views leave free (game/hud/replay_bar.h).
#pragma once
#include <optional>

#include "game/hud/hud.h"

namespace thaum::game::inline hud {

/// The panels of one player's view.
struct ViewLayout {
    render::Rect view;
    float unit{};    ///< length of a HUD unit (px)
    fvec2 centre{};  ///< position of the crosshair (px)
    float ring{};    ///< largest radius of the ring around the crosshair, in which charge, marks of hurts and
                     ///< warnings are shown (px)
    Panel health, name;
    Panel strip;
    float strip_columns{};  ///< number of wands in one row of the strip of wands
    Panel feed;
    Panel messages;
    /// Panel for the force on the hand: its curve while the views show forces, otherwise only the name of the
    /// strongest force.
    Panel forces;
    /// Panel for the front and the back of the body (body_figure.h): figure_wide x figure_high units, or
    /// smaller if there is less room. Empty while a lesson's text is shown in a window with one view.
    Panel figure;
    /// Panel for the card at the cauldron (rim_card.h), right of the ring around the crosshair; empty if
    /// there is too little room, and while a lesson's text is shown in a window with one view.
    Panel aside;
    Panel heard;  ///< panel for words about sounds and effects; empty if the curve of the forces leaves no
                  ///< room
    /// Panel for the spell that a stroke will probably cast, above the ring around the crosshair; empty if
    /// there is no room.
    Panel likely;
    Panel strokes;  ///< panel for the stroke that is drawn: around the crosshair, clear of the score and of
                    ///< two captions
};

/// All panels of a window.
struct HudLayout {
    /// For each player, the panels of the view; std::nullopt: the view is not shown.
    std::array<std::optional<ViewLayout>, players> views;
    float unit{};  ///< length of a HUD unit in panels of the whole window (px)
    Panel score;
    Panel notices;  ///< panel for notices, which are short messages to both players
    /// Panel for the instructions of a lesson (the Apprentice); std::nullopt: no lesson now, or there are two
    /// views.
    std::optional<Panel> lesson;
    float count_size{};   ///< text size of the countdown to the start of play, the same in all views (px)
    float lesson_size{};  ///< largest text size of the lesson (px)
    std::optional<ReplayBarLayout> replay{};
};

/// Sizes in the strip of wands (units of strip_unit).
inline constexpr float strip_cell_width = 40, strip_cell_height = 42, strip_head = 24, strip_margin = 4;

/// Length of a unit in the strip of wands (px). Smaller than the view's unit if the strip has little room.
float strip_unit(const ViewLayout& layout);

/// Size of the panel of forces if the view has room for it (HUD units).
inline constexpr float forces_wide = 186, forces_high = 76;
/// Part of the panel of forces for the name of the strongest force, when no curve is shown (HUD units).
inline constexpr float force_word_wide = 96, force_word_high = 27;
/// Height of a text line about a sound or effect (HUD units).
inline constexpr float heard_line_high = 20;

/// What is shown at present and needs room in the layout.
struct LayoutWishes {
    /// true: the text of a lesson is shown. In a window with one view, the other panels then leave room for
    /// it and are smaller where necessary.
    bool lesson = false;
    /// For each player, true if the player is at a station (cauldron, orb or crystal). In a tall view, the
    /// ring around the crosshair then leaves room below it for the card, the panel about the work there.
    std::array<bool, players> cards{};
};
HudLayout lay_out(const HudSettings& settings, render::Size window, std::size_t wands,
                  const LayoutWishes& wishes = {});

/// A text broken into lines that fit a box.
struct FittedWords {
    std::vector<std::string> lines;
    float size{};  ///< text size: length of an em (px)
    /// Distance from the top of one line to the top of the next (px).
    float line_height() const { return line_spacing * size; }
    float height() const { return static_cast<float>(lines.size()) * line_height(); }

    static constexpr float line_spacing = 1.4F;
};

/// Estimated width of a line of text, for laying it out (px). Real lines are seldom wider.
float width_of(std::string_view line, float size);

/// Breaks a text at spaces, or between groups separated by three spaces, into lines for a box of the size
/// `room` (px). The text size is `size` (px), or smaller if the text needs it.
FittedWords fit(std::string_view words, float size, fvec2 room);

}  // namespace thaum::game::inline hud
