// core/utf8.h: decodes UTF-8.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Decodes UTF-8 to code points. Each invalid byte becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

/// A text without the byte order mark that some editors write before it.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// Encodes one code point; an invalid one becomes U+FFFD.
std::string encode_utf8(char32_t code_point);

/// The capital of a Latin (to U+017F), Greek or Cyrillic letter, whatever the locale; other code points are
/// returned unchanged.
char32_t upper_case(char32_t code_point);

}  // namespace thaum
