// game/data/shown_words.h: words from players and files that the screen shows. They hold letters, digits and signs that
// the game's typeface has and that are written from left to right, so words are drawn as they were written.
#pragma once
#include <string_view>

#include "core/error.h"

namespace thaum::game {

/// Whether shown words may hold the character.
bool can_be_shown(char32_t character);

/// Checks words in UTF-8. The error names the first character that cannot be shown.
Expected<void> check_shown(std::string_view words);

}  // namespace thaum::game
