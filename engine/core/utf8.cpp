#include "core/utf8.h"

#include <algorithm>
#include <iterator>

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

/// A range of small letters. Every `step`-th of them has a capital, whose code point is lower by `down`.
struct Letters {
    char32_t first, last, down, step;
};
constexpr Letters small_letters[] = {
    {U'a', U'z', 32, 1},     {0xE0, 0xF6, 32, 1},     {0xF8, 0xFE, 32, 1},     {0x101, 0x12F, 1, 2},
    {0x131, 0x131, 0xE8, 1}, {0x133, 0x137, 1, 2},    {0x13A, 0x148, 1, 2},    {0x14B, 0x177, 1, 2},
    {0x17A, 0x17E, 1, 2},    {0x3AC, 0x3AC, 0x26, 1}, {0x3AD, 0x3AF, 0x25, 1}, {0x3B1, 0x3C1, 32, 1},
    {0x3C2, 0x3C2, 31, 1},   {0x3C3, 0x3CB, 32, 1},   {0x3CC, 0x3CC, 0x40, 1}, {0x3CD, 0x3CE, 0x3F, 1},
    {0x430, 0x44F, 32, 1},   {0x450, 0x45F, 80, 1},   {0x461, 0x481, 1, 2},    {0x48B, 0x4BF, 1, 2},
    {0x4C2, 0x4CE, 1, 2},    {0x4D1, 0x52F, 1, 2}};

}  // namespace

std::string encode_utf8(char32_t c) {
    if (c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) c = 0xFFFD;
    if (c < 0x80) return {static_cast<char>(c)};
    const auto tail = [&](unsigned shift) { return static_cast<char>(0x80U | (c >> shift & 0x3FU)); };
    if (c < 0x800) return {static_cast<char>(0xC0U | c >> 6U), tail(0)};
    if (c < 0x10000) return {static_cast<char>(0xE0U | c >> 12U), tail(6), tail(0)};
    return {static_cast<char>(0xF0U | c >> 18U), tail(12), tail(6), tail(0)};
}

char32_t upper_case(char32_t c) {
    if (c == 0xFF) return 0x178;
    const auto* range = std::ranges::find_if(small_letters, [&](const Letters& letters) {
        return c >= letters.first && c <= letters.last && (c - letters.first) % letters.step == 0;
    });
    return range == std::end(small_letters) ? c : c - range->down;
}

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
