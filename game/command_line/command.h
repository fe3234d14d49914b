// game/command_line/command.h: a command of a program, `thaum WORD ...`.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/registry.h"
#include "game/command_line/exit_code.h"

namespace thaum::game::inline command_line {

struct Command {
    std::string_view name;
    /// Text of `thaum WORD --help`, which fits a screen. Empty if `run` prints the help.
    std::string_view help;
    int (*run)(const std::vector<std::string>& words);
    /// Line about the command in the list of all commands; empty if the list has its own words for it
    /// (game/app/dispatch.cpp).
    std::string_view summary{};
};

/// Registers a command when the program starts.
using CommandRegistration = Registration<Command>;

/// All commands of this program, sorted by name.
inline const std::vector<Command>& commands() { return registry_of<Command>().all(); }

/// Whether the words contain --help or -h.
bool asks_for_help(const std::vector<std::string>& words);

}  // namespace thaum::game::inline command_line
