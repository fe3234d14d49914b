// core/text.h: building one line of text. No locale ever: the same bytes on every machine.
#pragma once
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace thaum {

inline void append_text(std::string& out, std::string_view s) { out.append(s); }
inline void append_text(std::string& out, char c) { out.push_back(c); }
/// Exactly bool: a pointer must not become one.
inline void append_text(std::string& out, std::same_as<bool> auto b) { out.append(b ? "true" : "false"); }

/// Integers in decimal, floating point in the shortest form that reads back to the same value.
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

/// value with `digits` (0 to 60) places after the point: fixed(1.25, 1) -> "1.2".
std::string fixed(double value, int digits);

/// 16 hexadecimal digits, lower case.
std::string hex(unsigned long long value);

}  // namespace thaum
