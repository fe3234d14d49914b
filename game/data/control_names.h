// game/data/control_names.h: names of a player's controls on the screen, "[E]", and words for players that contain them.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "game/data/presentation.h"
#include "input/frame.h"

namespace thaum::game {

/// Names of one player's controls for prompts and the strip of wands: "E", "Left mouse", "RT". Empty: no control.
struct ControlNames {
    std::string fire{}, stir{}, throw_{}, next_wand{}, trace{};
    std::string move{}, look{}, jump{}, pause{};
    std::string aside{};                                 ///< those that walk sideways, for turning a crystal
    std::array<std::string, input::most_wands> wands{};  ///< controls that take a wand in hand, by slot
    bool fire_toggles{}, trace_toggles{}, stir_toggles{};  ///< true: one press begins, and the next one ends
    bool operator==(const ControlNames&) const = default;
};

/// A control in brackets: "[E]"; the other words where it has none.
std::string bracketed(const std::string& control, std::string_view otherwise);
/// "hold ", or "press " for a control that toggles.
std::string_view hold_or_press(bool toggles);

/// Words with the player's controls in place of their braces (game/data/control_words.h): "[E]". A wand without a
/// control of its own is reached by the control that goes on to the next wand: "[RB] (next wand)". "Hold" before a
/// control that toggles is "Press".
std::string with_controls(std::string_view words, const ControlNames& controls, const Presentation& shown);

/// When prompts are shown. The settings file has the names.
enum class PromptWish : std::uint8_t { until_learnt, always, never };
inline constexpr std::array<std::string_view, 3> prompt_wishes{"until_learnt", "always", "never"};

}  // namespace thaum::game
