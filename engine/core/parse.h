// core/parse.h: parses numbers that people have typed.
#pragma once
#include <cstdint>
#include <string_view>

#include "core/error.h"

namespace thaum {

/// Parses a whole number from `low` to `high`: "12" -> 12. The error says what is wrong with `word` and calls
/// the number `what`.
Expected<std::uint64_t> parse_whole(std::string_view word, std::string_view what, std::uint64_t low,
                                    std::uint64_t high);
/// Parses a number from `low` to `high`: "1.5" -> 1.5. NaN is refused. The error is worded as that of
/// parse_whole.
Expected<double> parse_number(std::string_view word, std::string_view what, double low, double high);

}  // namespace thaum
