// core/invisible.h: finds invisible characters, by which two words that look equal may differ.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// The first invisible character of a text, in words: "an invisible character, U+200B (zero-width space)".
/// Empty if there is none. Blanks other than the space, such as the no-break space, count too, because they
/// look like a space.
std::string invisible_character(std::string_view text);

/// The first invisible character of a text, in words; empty if there is none. Blanks other than the space do
/// not count, as texts for people may contain them.
std::string hidden_character(std::string_view text);

}  // namespace thaum
