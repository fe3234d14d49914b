// core/letters.h: letters of ASCII, whatever the locale.
#pragma once
#include <algorithm>
#include <string_view>

namespace thaum {

/// The small letter of a capital; other characters stay.
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Whether two words differ in nothing but capitals.
constexpr bool same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower_case, lower_case);
}

}  // namespace thaum
