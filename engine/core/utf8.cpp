#include "core/utf8.h"

namespace thaum {
namespace {

/// Number of bytes that follow a leading byte of UTF-8; -1 if the byte is not a leading one.
int tail_length(unsigned char lead) {
    if (lead < 0x80) return 0;
    if (lead >= 0xC2 && lead < 0xE0) return 1;
    if (lead >= 0xE0 && lead < 0xF0) return 2;
    if (lead >= 0xF0 && lead < 0xF5) return 3;
    return -1;
}

struct Decoded {
    char32_t character = 0xFFFD;
    std::size_t bytes = 1;
};

/// Decodes the first character of `text`, which must not be empty.
Decoded decode_one(std::string_view text) {
    constexpr char32_t least[] = {0, 0x80, 0x800, 0x10000};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const int tail = tail_length(byte(0));
    if (tail < 0 || text.size() <= static_cast<std::size_t>(tail)) return {};
    if (tail == 0) return {byte(0), 1};
    char32_t value = byte(0) & (0x3FU >> tail);
    for (std::size_t i = 1; i <= static_cast<std::size_t>(tail); ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        value = (value << 6U) | (byte(i) & 0x3FU);
    }
    const bool surrogate = value >= 0xD800 && value < 0xE000;
    if (value < least[tail] || value > 0x10FFFF || surrogate) return {};
    return {value, 1 + static_cast<std::size_t>(tail)};
}

}  // namespace

std::u32string decode_utf8(std::string_view text) {
    std::u32string out;
    while (!text.empty()) {
        const auto next = decode_one(text);
        out.push_back(next.character);
        text.remove_prefix(next.bytes);
    }
    return out;
}

}  // namespace thaum
