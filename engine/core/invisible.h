// core/invisible.h: characters that nobody sees in a text, and that make two equal words differ.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// The first invisible character of a text, in words: "an invisible character, U+200B (zero-width space)". Empty if there is
/// none. Blanks of other kinds than a space, such as the no-break space, count: they look like a space and are none.
std::string invisible_character(std::string_view text);

/// The same for characters without width: blanks of other kinds, which words may have, do not count.
std::string hidden_character(std::string_view text);

}  // namespace thaum
