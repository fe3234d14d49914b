// game/settings/player_name.h: names that players give themselves, of characters that can be shown
// (game/data/shown_words.h).
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::app {

inline constexpr std::size_t longest_name = 16;  ///< characters

/// Whether a name may hold the character.
bool fits_name(char32_t character);

/// A name without spaces at its ends; empty if nothing is left. The error says what is wrong with it.
Expected<std::string> player_name(std::string_view utf8);

/// Name with one more typed character, or the same name if it does not fit.
std::string with_character(std::string name, char32_t character);
/// Name without its last character.
std::string without_last(std::string name);

/// Name of a file or folder for a player's words. Characters that file systems treat differently become "_", and the
/// hash of the words tells words apart that would be alike.
std::string file_name_of(const std::string& words);

}  // namespace thaum::app
