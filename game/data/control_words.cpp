#include "game/data/control_words.h"

#include <algorithm>
#include <array>

#include "core/text.h"
#include "game/data/words_pattern.h"

namespace thaum::game::inline data {
namespace {

/// Names of all controls except those of wands, in the order of ControlWord.
constexpr std::array<std::string_view, 9> control_names{"move",  "look",      "jump",  "fire", "stir",
                                                        "throw", "next_wand", "pause", "trace"};
constexpr std::string_view wand_prefix = "wand:";

/// The control that `name`, the text between two braces, stands for; std::nullopt for an unknown name.
std::optional<ControlPiece> control_of(std::string_view name) {
    if (name.starts_with(wand_prefix) && name.size() > wand_prefix.size())
        return ControlPiece{{}, ControlWord::wand, std::string(name.substr(wand_prefix.size()))};
    const auto* found = std::find(control_names.begin(), control_names.end(), name);
    if (found == control_names.end()) return {};
    return ControlPiece{{}, static_cast<ControlWord>(found - control_names.begin()), {}};
}

bool is_sound(const ControlPiece& piece, const std::vector<std::string_view>& wands) {
    if (piece.plain.find_first_of("{}") != std::string::npos) return false;
    return piece.word != ControlWord::wand ||
           std::find(wands.begin(), wands.end(), piece.wand) != wands.end();
}

}  // namespace

std::vector<ControlPiece> control_pieces_of(std::string_view pattern) {
    return split_at_names<ControlPiece>(pattern, [](ControlPiece& piece, std::string_view name) {
        const auto control = control_of(name);
        if (!control) return false;
        piece.word = control->word;
        piece.wand = control->wand;
        return true;
    });
}

std::string read_control_words(const ConfigTable& table, std::string_view key,
                               const std::vector<std::string_view>& wands) {
    auto words = table.string(key);
    const auto pieces = control_pieces_of(words);
    const auto wrong = std::find_if_not(pieces.begin(), pieces.end(),
                                        [&](const auto& piece) { return is_sound(piece, wands); });
    if (wrong == pieces.end()) return words;
    std::vector<std::string> known(control_names.begin(), control_names.end());
    for (const auto wand : wands) known.push_back(text(wand_prefix, wand));
    std::string all;
    for (const auto& name : known) all += text(all.empty() ? "{" : ", {", name, "}");
    const std::vector<std::string_view> names(known.begin(), known.end());
    const auto braces = has_brace(wrong->plain) ? wrong->plain : text("{", wand_prefix, wrong->wand, "}");
    table.report(key, text("'", key, "' may contain ", all, words_on_braces(braces, names)));
    return words;
}

}  // namespace thaum::game::inline data
