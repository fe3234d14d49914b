// game/data/shown_words.h: text from players and files that the screen shows. Allowed are letters, digits and
// signs that the game's typeface has and that are written from left to right, so that the screen shows the
// text as it was written.
#pragma once
#include <string_view>

#include "core/error.h"

namespace thaum::game::inline data {

/// Whether shown text may contain the character.
bool can_be_shown(char32_t character);

/// Checks a text in UTF-8. The error names the first character that cannot be shown.
Expected<void> check_shown(std::string_view words);

}  // namespace thaum::game::inline data
