#include "game/app/player_name.h"

#include <algorithm>

#include "core/text.h"
#include "render/font.h"

namespace thaum::app {
namespace {

/// First and last character of each range that names may use: Latin, Greek and Cyrillic. Left out are control
/// characters, marks that join the letter before them, and letters written from right to left.
struct CharacterRange {
    char32_t first, last;
};
constexpr CharacterRange name_ranges[] = {{0x20, 0x7E},   {0xA1, 0xAC},   {0xAE, 0x24F},
                                          {0x386, 0x38A}, {0x38C, 0x38C}, {0x38E, 0x3A1},
                                          {0x3A3, 0x3FF}, {0x400, 0x481}, {0x48A, 0x523}};

/// UTF-8 of a character that fits a name, all of which are below U+0800.
std::string utf8_of(char32_t c) {
    if (c < 0x80) return {static_cast<char>(c)};
    return {static_cast<char>(0xC0U | c >> 6U), static_cast<char>(0x80U | (c & 0x3FU))};
}

}  // namespace

bool fits_name(char32_t character) {
    return std::any_of(std::begin(name_ranges), std::end(name_ranges), [&](const CharacterRange& range) {
        return character >= range.first && character <= range.last;
    });
}

Expected<std::string> player_name(std::string_view utf8) {
    const auto first = utf8.find_first_not_of(' ');
    if (first == std::string_view::npos) return std::string();
    const auto bare = utf8.substr(first, utf8.find_last_not_of(' ') - first + 1);
    const auto characters = render::decode_utf8(bare);
    if (characters.size() > longest_name)
        return fail(text("a name has at most ", longest_name, " characters, not ", characters.size()));
    const auto odd = std::find_if_not(characters.begin(), characters.end(), fits_name);
    if (odd != characters.end())
        return fail(text("character ", odd - characters.begin() + 1,
                         " cannot be shown; use Latin, Greek or Cyrillic letters, digits and signs"));
    return std::string(bare);
}

std::string with_character(std::string name, char32_t character) {
    const bool leading_space = character == ' ' && name.empty();
    if (leading_space || !fits_name(character) || render::decode_utf8(name).size() >= longest_name)
        return name;
    return name + utf8_of(character);
}

std::string without_last(std::string name) {
    constexpr auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    while (!name.empty() && continues(name.back())) name.pop_back();
    if (!name.empty()) name.pop_back();
    return name;
}

}  // namespace thaum::app
