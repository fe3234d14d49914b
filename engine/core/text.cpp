#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/assert.h"
#include "core/one_line.h"

namespace thaum {
namespace {

template <class Number>
void append_number(std::string& out, Number value) {
    char buffer[64];
    const auto* end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    out.append(buffer, static_cast<std::size_t>(end - buffer));
}

}  // namespace

void TextPart::append_to(std::string& out) const {
    switch (kind_) {
        case Kind::words: out.append(words_); break;
        case Kind::character: out.push_back(character_); break;
        case Kind::integer: append_number(out, integer_); break;
        case Kind::unsigned_integer: append_number(out, unsigned_); break;
        case Kind::single: append_number(out, single_); break;
        case Kind::number: append_number(out, number_); break;
    }
}

std::string joined_text(std::initializer_list<TextPart> parts) {
    std::string out;
    for (const auto& part : parts) part.append_to(out);
    return out;
}

std::string fixed(double value, int digits) {
    THAUM_ASSERT(digits >= 0 && digits <= 60, "fixed: digits from 0 to 60");
    char buffer[400];  // the largest double has 309 digits before the point
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
    return {buffer, end};
}

std::string hex(unsigned long long value) {
    std::string out(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) out[i] = "0123456789abcdef"[value & 15U];
    return out;
}

std::string clock_text(unsigned long long seconds) {
    const auto remaining = seconds % 60;
    return text(seconds / 60, remaining < 10 ? ":0" : ":", remaining);
}

namespace {

/// Returns the length in bytes and the code point of the first UTF-8 character of `s`. The length is 0 if the
/// bytes are not valid UTF-8.
std::pair<std::size_t, char32_t> first_character(std::string_view s) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
    const auto lead = byte(0);
    if (lead < 0x80) return {1, lead};
    const std::size_t bytes = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
    if (bytes == 0 || bytes > s.size()) return {0, 0};
    char32_t code = lead & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) return {0, 0};
        code = code << 6U | (byte(i) & 0x3fU);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < least[bytes] || surrogate || code > 0x10ffff ? std::pair<std::size_t, char32_t>{0, 0}
                                                               : std::pair{bytes, code};
}

/// Returns true if a terminal would act on the character instead of displaying it.
bool is_command(char32_t code) {
    const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
    const bool turns_writing = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
                               code == 0x200e || code == 0x200f || code == 0x61c;
    const bool breaks_line = code == 0x2028 || code == 0x2029;
    return control || turns_writing || breaks_line;
}

}  // namespace

std::string printable(std::string_view outside, std::size_t most) {
    std::string out;
    while (!outside.empty()) {
        const auto [bytes, code] = first_character(outside);
        const auto used = std::max<std::size_t>(bytes, 1);
        std::string shown(outside.substr(0, used));
        if (bytes == 0 || is_command(code)) {
            shown.clear();
            for (const char c : outside.substr(0, used))
                shown += text("\\x", hex(static_cast<unsigned char>(c)).substr(14));
        }
        if (out.size() + shown.size() > most) return out + "...";
        out += shown;
        outside.remove_prefix(used);
    }
    return out;
}

std::string in_one_line(std::string_view message) {
    constexpr std::size_t most = 1000;
    std::string line(message.substr(0, most + 1));
    for (auto& c : line) {
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    }
    return printable(line, most);
}

std::string capitalised(std::string_view name) {
    std::string out(name);
    if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
    return out;
}

}  // namespace thaum
