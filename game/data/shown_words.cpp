#include "game/data/shown_words.h"

#include <algorithm>
#include <iterator>

#include "core/text.h"
#include "core/utf8.h"

namespace thaum::game::inline data {
namespace {

/// First and last character of each range that words may use: Latin, Greek and Cyrillic. Left out are control
/// characters, combining marks, and letters written from right to left.
struct CharacterRange {
    char32_t first, last;
};
constexpr CharacterRange shown_ranges[] = {{0x20, 0x7E},   {0xA1, 0xAC},   {0xAE, 0x24F},
                                           {0x386, 0x38A}, {0x38C, 0x38C}, {0x38E, 0x3A1},
                                           {0x3A3, 0x3FF}, {0x400, 0x481}, {0x48A, 0x523}};

}  // namespace

bool can_be_shown(char32_t character) {
    return std::any_of(std::begin(shown_ranges), std::end(shown_ranges), [&](const CharacterRange& range) {
        return character >= range.first && character <= range.last;
    });
}

Expected<void> check_shown(std::string_view words) {
    const auto characters = decode_utf8(words);
    const auto odd = std::find_if_not(characters.begin(), characters.end(), can_be_shown);
    if (odd == characters.end()) return {};
    return fail(text("character ", odd - characters.begin() + 1,
                     " cannot be shown; use Latin, Greek or Cyrillic letters, digits and signs"));
}

}  // namespace thaum::game::inline data
