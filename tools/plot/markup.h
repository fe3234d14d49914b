// tools/plot/markup.h: text and numbers escaped and formatted for SVG and HTML.
#pragma once
#include <string>
#include <string_view>

namespace thaum::plot {

/// UTF-8 text as the content of an element or of an attribute in quotes. Characters that XML forbids, such as
/// control characters, become U+FFFD.
std::string escaped(std::string_view utf8);

/// Text of at most `letters` code points; cut text ends with an ellipsis.
std::string cut(std::string_view utf8, std::size_t letters);

/// Number of code points in a text.
std::size_t letters_of(std::string_view utf8);

/// Coordinate in pixels, rounded to 0.01.
std::string px(double value);

}  // namespace thaum::plot
