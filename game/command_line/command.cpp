#include "game/command_line/command.h"

#include <algorithm>

namespace thaum::game::inline command_line {

bool asks_for_help(const std::vector<std::string>& words) {
    return std::ranges::any_of(words, [](const auto& word) { return word == "--help" || word == "-h"; });
}

}  // namespace thaum::game::inline command_line
