// Text patterns in data files, in which {names} are replaced later.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline data {

/// Splits a pattern at its known {names}. A Piece has the text before the name in `plain`; the last one has
/// no name. `fill(piece, name)` stores the name's meaning in the piece and returns whether the name is known.
/// Braces around other words are plain text.
template <typename Piece, typename Fill>
std::vector<Piece> split_at_names(std::string_view pattern, Fill&& fill) {
    std::vector<Piece> pieces(1);
    while (!pattern.empty()) {
        const auto close = pattern.front() == '{' ? pattern.find('}') : std::string_view::npos;
        if (close != std::string_view::npos && fill(pieces.back(), pattern.substr(1, close - 1))) {
            pieces.emplace_back();
            pattern.remove_prefix(close + 1);
        } else {
            pieces.back().plain += pattern.front();
            pattern.remove_prefix(1);
        }
    }
    return pieces;
}

inline bool has_brace(std::string_view plain) { return plain.find_first_of("{}") != std::string_view::npos; }

/// End of a message about the first braces in plain text: "; '{fier}' is none of them; did you mean 'fire'?".
inline std::string words_on_braces(std::string_view plain, std::span<const std::string_view> known) {
    const auto open = plain.find_first_of("{}");
    const auto close = plain.find('}', open);
    if (close == plain.npos || close == open) return "; a brace has no partner";
    const auto name = plain.substr(open + 1, close - open - 1);
    return text("; '{", printable(name, 40), "}' is none of them", did_you_mean(name, known));
}

}  // namespace thaum::game::inline data
