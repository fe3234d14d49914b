// Patterns of words from data files, in which {names} stand for words that are known later.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace thaum::game {

/// Splits a pattern at its known {names}. A Piece has its text before the name in `plain`; the last one has no name.
/// `fill(piece, name)` stores a name's meaning in its piece and returns whether the name is known. Braces around
/// other words are plain text.
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

}  // namespace thaum::game
