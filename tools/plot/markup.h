// tools/plot/markup.h: text and numbers as SVG and HTML want them.
#pragma once
#include <string>
#include <string_view>

namespace thaum::plot {

/// UTF-8 as the content of an element or of an attribute in quotes. What XML cannot hold, such as a control character, becomes
/// U+FFFD.
std::string escaped(std::string_view utf8);

/// At most `letters` code points, the last being an ellipsis where something was cut.
std::string cut(std::string_view utf8, std::size_t letters);

/// Code points.
std::size_t letters_of(std::string_view utf8);

/// A coordinate, to a hundredth of a pixel.
std::string px(double value);

}  // namespace thaum::plot
