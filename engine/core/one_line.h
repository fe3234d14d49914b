// core/one_line.h: what a message quotes from a file may hold line breaks, or codes that a terminal obeys.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Every control character becomes a blank.
std::string in_one_line(std::string_view message);

}  // namespace thaum
