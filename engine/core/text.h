// core/text.h: builds one line of text. It never uses a locale, so every machine produces the same bytes.
#pragma once
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace thaum {

inline void append_text(std::string& out, std::string_view s) { out.append(s); }
inline void append_text(std::string& out, char c) { out.push_back(c); }
/// Accepts only bool itself. A plain bool parameter would accept pointers, too.
inline void append_text(std::string& out, std::same_as<bool> auto b) { out.append(b ? "true" : "false"); }

/// Writes integers in decimal and floating-point numbers in the shortest form that reads back to the same
/// value.
template <class T>
requires((std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char>) ||
         std::floating_point<T>) void append_text(std::string& out, T value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    out.append(buffer, end);
}

/// text("tick ", 12, " differs") -> "tick 12 differs".
template <class... Parts>
std::string text(const Parts&... parts) {
    std::string out;
    (append_text(out, parts), ...);
    return out;
}

/// Formats `value` with `digits` (0 to 60) decimal places: fixed(1.25, 1) -> "1.2".
std::string fixed(double value, int digits);

/// Formats a time in minutes and seconds: clock_text(245) -> "4:05".
std::string clock_text(unsigned long long seconds);

/// Formats `value` as 16 lower-case hexadecimal digits.
std::string hex(unsigned long long value);

}  // namespace thaum
