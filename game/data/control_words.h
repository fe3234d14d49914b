// game/data/control_words.h: words for players that name controls in braces: "Press {fire}", "Take {wand:lob}". The
// screen puts the player's own control in place of the braces.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"

namespace thaum::game {

/// Controls that words may name.
enum class ControlWord : std::uint8_t { move, look, jump, fire, stir, throw_, next_wand, pause, trace, wand };

/// Plain words, and the control that follows them.
struct ControlPiece {
    std::string plain;
    std::optional<ControlWord> word{};
    std::string wand{};  ///< name of the wand of ControlWord::wand
};
/// Splits words at their controls. A brace without a known control stays plain.
std::vector<ControlPiece> control_pieces_of(std::string_view pattern);

/// Reads words that may name controls. `wands` are the names that {wand:NAME} may have. Reports other braces.
std::string read_control_words(const ConfigTable& table, std::string_view key,
                               const std::vector<std::string_view>& wands);

}  // namespace thaum::game
