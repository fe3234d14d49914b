// game/data/control_words.h: words for players that name controls in braces: "Press {fire}", "Take
// {wand:lob}". The screen replaces the braces by the player's own control.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"

namespace thaum::game::inline data {

/// Controls that words may name.
enum class ControlWord : std::uint8_t { move, look, jump, fire, stir, throw_, next_wand, pause, trace, wand };

/// A piece of plain text, and the control named after it.
struct ControlPiece {
    std::string plain;
    std::optional<ControlWord> word{};
    std::string wand{};  ///< name of the wand, if `word` is ControlWord::wand
};
/// Splits a text at the names of controls in braces. Braces without a known control stay plain text.
std::vector<ControlPiece> control_pieces_of(std::string_view pattern);

/// Reads a text that may name controls. `wands`: the names allowed in {wand:NAME}. Reports all other braces.
std::string read_control_words(const ConfigTable& table, std::string_view key,
                               const std::vector<std::string_view>& wands);

}  // namespace thaum::game::inline data
