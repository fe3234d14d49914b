#include "tools/plot/markup.h"

#include <algorithm>

#include "core/text.h"

namespace thaum::plot {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // the replacement character, U+FFFD
constexpr std::string_view ellipsis = "\xE2\x80\xA6";

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Tests for U+FFFE and U+FFFF, the only characters above the control characters that UTF-8 allows and XML
/// forbids.
bool is_forbidden_triple(std::string_view at) {
    return at.starts_with("\xEF\xBF\xBE") || at.starts_with("\xEF\xBF\xBF");
}

void append_escaped(std::string& out, char c) {
    switch (c) {
        case '&': out += "&amp;"; return;
        case '<': out += "&lt;"; return;
        case '>': out += "&gt;"; return;
        case '"': out += "&quot;"; return;
        case '\t':
        case '\n':
        case '\r': out += ' '; return;
        default: break;
    }
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) {
        out += replacement;
    } else {
        out += c;
    }
}

}  // namespace

std::string escaped(std::string_view utf8) {
    std::string out;
    out.reserve(utf8.size());
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        if (is_forbidden_triple(utf8.substr(i, 3))) {
            out += replacement;
            i += 2;
        } else {
            append_escaped(out, utf8[i]);
        }
    }
    return out;
}

std::size_t letters_of(std::string_view utf8) {
    return static_cast<std::size_t>(std::ranges::count_if(utf8, begins_letter));
}

std::string cut(std::string_view utf8, std::size_t letters) {
    if (letters_of(utf8) <= letters) return std::string(utf8);
    std::size_t end = 0, seen = 0;
    while (end < utf8.size() && (seen += begins_letter(utf8[end]) ? 1U : 0U) < letters) ++end;
    return text(utf8.substr(0, end), ellipsis);
}

std::string px(double value) { return fixed(value, 2); }

}  // namespace thaum::plot
