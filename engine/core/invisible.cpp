#include "core/invisible.h"

#include <algorithm>

#include "core/text.h"
#include "core/utf8.h"

namespace thaum {
namespace {

/// A range of invisible characters (code points), with a name for messages.
struct Invisible {
    char32_t first, last;
    std::string_view name;
    bool is_blank = false;
};
constexpr Invisible invisible[] = {{0xA0, 0xA0, "no-break space", true},
                                   {0xAD, 0xAD, "soft hyphen"},
                                   {0x34F, 0x34F, "grapheme joiner"},
                                   {0x61C, 0x61C, "mark of the direction of writing"},
                                   {0x180E, 0x180E, "vowel separator"},
                                   {0x2000, 0x200A, "a space of another width", true},
                                   {0x200B, 0x200B, "zero-width space"},
                                   {0x200C, 0x200C, "zero-width non-joiner"},
                                   {0x200D, 0x200D, "zero-width joiner"},
                                   {0x200E, 0x200F, "mark of the direction of writing"},
                                   {0x2028, 0x2029, "line separator"},
                                   {0x202A, 0x202E, "mark of the direction of writing"},
                                   {0x202F, 0x202F, "narrow no-break space", true},
                                   {0x205F, 0x205F, "a space of another width", true},
                                   {0x2060, 0x2064, "word joiner"},
                                   {0x2066, 0x2069, "mark of the direction of writing"},
                                   {0x3000, 0x3000, "wide space", true},
                                   {0xFE00, 0xFE0F, "variation selector"},
                                   {0xFEFF, 0xFEFF, "byte order mark"},
                                   {0xFFF9, 0xFFFB, "mark of a note"},
                                   {0xE0000, 0xE007F, "tag"}};

const Invisible* kind_of(char32_t character) {
    const auto* const kind = std::ranges::find_if(
        invisible, [&](const Invisible& one) { return character >= one.first && character <= one.last; });
    return kind == std::end(invisible) ? nullptr : kind;
}

/// Writes a code point in the form "U+200B".
std::string number_words(char32_t character) {
    auto digits = hex(character);
    digits = digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 4));
    for (auto& digit : digits)
        if (digit >= 'a') digit = static_cast<char>(digit - 'a' + 'A');
    return text("U+", digits);
}

/// Describes the first invisible character of a text; unusual blanks count if `blanks` is true.
std::string first_of(std::string_view words, bool blanks) {
    for (const auto character : decode_utf8(words)) {
        const auto* kind = kind_of(character);
        if (kind != nullptr && (blanks || !kind->is_blank))
            return text("an invisible character, ", number_words(character), " (", kind->name, ")");
    }
    return {};
}

}  // namespace

std::string invisible_character(std::string_view words) { return first_of(words, true); }

std::string hidden_character(std::string_view words) { return first_of(words, false); }

}  // namespace thaum
