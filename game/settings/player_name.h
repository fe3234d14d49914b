// game/settings/player_name.h: names that players choose, with characters that can be shown
// (game/data/shown_words.h).
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::game::inline settings {

inline constexpr std::size_t longest_name = 16;  ///< maximum length of a name (characters)

/// Whether a name may hold the character.
bool fits_name(char32_t character);

/// Returns the name without spaces at its ends, which may be empty. The error says what is wrong with the
/// name.
Expected<std::string> player_name(std::string_view utf8);

/// Name with one more typed character, or the same name if the character is not allowed.
std::string with_character(std::string name, char32_t character);
/// Name without its last character.
std::string without_last(std::string name);

/// Name of a file or folder for a text chosen by a player. Characters that file systems treat differently
/// become "_", and a hash of the text keeps different texts apart.
std::string file_name_of(const std::string& words);

}  // namespace thaum::game::inline settings
