// game/data/control_names.h: names of a player's controls on the screen, "[E]", and words for players that
// contain them.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "game/data/presentation.h"
#include "input/frame.h"

namespace thaum::game::inline data {

/// Names of one player's controls for hints on the screen and for the row of wands: "E", "Left mouse", "RT".
/// An empty name means that no control is bound.
struct ControlNames {
    std::string fire{}, stir{}, throw_{}, next_wand{}, trace{};
    std::string move{}, look{}, jump{}, pause{};
    std::string aside{};  ///< the two controls for walking sideways, which also turn a crystal
    std::array<std::string, input::max_wands> wands{};     ///< controls that select a wand, by slot
    bool fire_toggles{}, trace_toggles{}, stir_toggles{};  ///< true: one press begins, and the next one ends
    bool operator==(const ControlNames&) const = default;
};

/// Name of a control in brackets: "[E]"; `otherwise` if the name is empty.
std::string bracketed(const std::string& control, std::string_view otherwise);
/// "hold ", or "press " for a control that toggles.
std::string_view hold_or_press(bool toggles);

/// Replaces controls in braces (game/data/control_words.h) by the player's own, such as "[E]". For a wand
/// without a control of its own, gives the control for the next wand: "[RB] (next wand)". "Hold" before a
/// control that toggles becomes "Press".
std::string with_controls(std::string_view words, const ControlNames& controls, const Presentation& shown);

/// When prompts, hints on the screen such as "[E] Stir", are shown. The settings file uses the same names.
enum class PromptWish : std::uint8_t { until_learnt, always, never };
inline constexpr std::array<std::string_view, 3> prompt_wishes{"until_learnt", "always", "never"};

}  // namespace thaum::game::inline data
