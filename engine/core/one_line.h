// core/one_line.h: what a message quotes from a file may hold line breaks, codes that a terminal obeys, or a
// megabyte.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Every control character becomes a blank; what is beyond 1,000 bytes is left out, and dots say so.
std::string in_one_line(std::string_view message);

}  // namespace thaum
