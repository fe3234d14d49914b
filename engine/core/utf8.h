// core/utf8.h: decodes UTF-8.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Decodes UTF-8 to code points. Each invalid byte becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

}  // namespace thaum
