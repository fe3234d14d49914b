// core/one_line.h: makes text from files safe for one-line messages. Such text may hold line breaks, terminal
// control codes, or a megabyte.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Replaces line breaks and tabs by blanks and escapes the rest as `printable` does. What goes beyond 1,000
/// bytes becomes "...".
std::string in_one_line(std::string_view message);

/// Escapes text from outside for display in a terminal. Control characters, bidirectional marks and bytes
/// that are not UTF-8 become "\x1b" and the like. Text beyond `most` bytes is replaced by "...".
std::string printable(std::string_view outside, std::size_t most);

}  // namespace thaum
