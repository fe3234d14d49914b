// core/one_line.h: what a message quotes from a file may hold line breaks, codes that a terminal obeys, or a
// megabyte.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Every control character becomes a blank; what is beyond 1,000 bytes is left out, and dots say so.
std::string in_one_line(std::string_view message);

/// Text from outside that a terminal can show: control characters, marks that turn the direction of writing and bytes that are not UTF-8
/// become "\\x1b" and the like. What is beyond `most` bytes is left out, and dots say so.
std::string printable(std::string_view outside, std::size_t most);

}  // namespace thaum
