#include "game/settings/player_name.h"

#include <span>

#include "core/hash.h"
#include "core/text.h"
#include "core/utf8.h"
#include "game/data/shown_words.h"

namespace thaum::game::inline settings {
bool fits_name(char32_t character) { return can_be_shown(character); }

Expected<std::string> player_name(std::string_view utf8) {
    const auto first = utf8.find_first_not_of(' ');
    if (first == std::string_view::npos) return std::string();
    const auto bare = utf8.substr(first, utf8.find_last_not_of(' ') - first + 1);
    const auto characters = decode_utf8(bare);
    if (characters.size() > longest_name)
        return fail(text("a name has at most ", longest_name, " characters, not ", characters.size()));
    if (auto shown = check_shown(bare); !shown) return shown.error();
    return std::string(bare);
}

std::string with_character(std::string name, char32_t character) {
    const bool leading_space = character == ' ' && name.empty();
    if (leading_space || !fits_name(character) || decode_utf8(name).size() >= longest_name) return name;
    return name + encode_utf8(character);
}

std::string without_last(std::string name) {
    constexpr auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    while (!name.empty() && continues(name.back())) name.pop_back();
    if (!name.empty()) name.pop_back();
    return name;
}

std::string file_name_of(const std::string& words) {
    std::string file;
    for (const char c : words) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        file += plain ? c : '_';
    }
    if (file == words) return file;
    return text(file, "-", hex(hash_bytes(std::as_bytes(std::span(words)))));
}

}  // namespace thaum::game::inline settings
