#include "game/data/control_names.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "game/data/control_words.h"

namespace thaum::game::inline data {
namespace {

/// Name of a control in brackets, as prompts show it: "[E]".
std::string in_brackets(const std::string& control) {
    return text("[", control.empty() ? "not bound" : control, "]");
}

/// Name of the control that selects the wand. For a wand without a control of its own: the control for the
/// next wand, with words that say so.
std::string control_of_wand(std::string_view wand, const ControlNames& controls, const Presentation& shown) {
    const auto found =
        std::find_if(shown.wands.begin(), shown.wands.end(), [&](const auto& w) { return w.name == wand; });
    const bool has_own = found != shown.wands.end() && !controls.wands.at(found->slot).empty();
    if (has_own) return in_brackets(controls.wands.at(found->slot));
    return controls.next_wand.empty() ? in_brackets({}) : in_brackets(controls.next_wand) + " (next wand)";
}

std::string control_of(const ControlPiece& piece, const ControlNames& controls, const Presentation& shown) {
    switch (*piece.word) {
        case ControlWord::move: return in_brackets(controls.move);
        case ControlWord::look: return in_brackets(controls.look);
        case ControlWord::jump: return in_brackets(controls.jump);
        case ControlWord::fire: return in_brackets(controls.fire);
        case ControlWord::stir: return in_brackets(controls.stir);
        case ControlWord::throw_: return in_brackets(controls.throw_);
        case ControlWord::next_wand: return in_brackets(controls.next_wand);
        case ControlWord::pause: return in_brackets(controls.pause);
        case ControlWord::trace: return in_brackets(controls.trace);
        case ControlWord::wand: return control_of_wand(piece.wand, controls, shown);
    }
    return {};
}

bool toggles(ControlWord word, const ControlNames& controls) {
    return (word == ControlWord::fire && controls.fire_toggles) ||
           (word == ControlWord::trace && controls.trace_toggles) ||
           (word == ControlWord::stir && controls.stir_toggles);
}

/// Replaces "hold" by "press" at the end of a text, because a control that toggles is pressed once instead of
/// held.
void press_instead_of_hold(std::string& words) {
    for (const auto& [hold, press] : {std::pair("Hold ", "Press "), std::pair("hold ", "press ")})
        if (words.ends_with(hold))
            words.replace(words.size() - std::string_view(hold).size(), words.npos, press);
}

}  // namespace

std::string bracketed(const std::string& control, std::string_view otherwise) {
    return control.empty() ? std::string(otherwise) : text("[", control, "]");
}

std::string_view hold_or_press(bool toggles) { return toggles ? "press " : "hold "; }

std::string with_controls(std::string_view words, const ControlNames& controls, const Presentation& shown) {
    std::string filled;
    for (const auto& piece : control_pieces_of(words)) {
        filled += piece.plain;
        if (!piece.word) continue;
        if (toggles(*piece.word, controls)) press_instead_of_hold(filled);
        filled += control_of(piece, controls, shown);
    }
    return filled;
}

}  // namespace thaum::game::inline data
