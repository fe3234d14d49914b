// core/letters.h: ASCII letters, digits and blanks, independent of the locale.
#pragma once
#include <algorithm>
#include <string_view>

namespace thaum {

/// The lower-case form of an ASCII capital; other characters are returned unchanged.
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Whether the character is one of 0 to 9.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A text without blanks, tabs and carriage returns at its ends.
constexpr std::string_view trimmed(std::string_view words) {
    constexpr std::string_view blanks = " \t\r";
    const auto first = words.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return words.substr(first, words.find_last_not_of(blanks) - first + 1);
}

/// Whether two words are equal apart from upper and lower case.
constexpr bool same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower_case, lower_case);
}

}  // namespace thaum
