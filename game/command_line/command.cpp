#include "game/command_line/command.h"

#include <algorithm>

namespace thaum::game::inline command_line {
namespace {

std::vector<Command>& registered() {
    static std::vector<Command> all;  // made at the first use, because registrations run in any order
    return all;
}

}  // namespace

CommandRegistration::CommandRegistration(const Command& command) {
    auto& all = registered();
    // The linker chooses the order of registrations, so the list is sorted to be independent of it.
    all.insert(std::ranges::upper_bound(all, command.name, {}, &Command::name), command);
}

const std::vector<Command>& commands() { return registered(); }

bool asks_for_help(const std::vector<std::string>& words) {
    return std::ranges::any_of(words, [](const auto& word) { return word == "--help" || word == "-h"; });
}

}  // namespace thaum::game::inline command_line
