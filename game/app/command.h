// game/app/command.h: the commands of the program, `thaum WORD ...`. Each command is one
// source, which registers itself (command_line/command.h): in commands/ for the program thaum,
// in tool_commands/ for thaum-tools.
//
// The program thaum has only the commands of players, so that building it for a first start compiles no
// others. The program thaum-tools has all commands and lies beside thaum. For a command that thaum lacks,
// thaum replaces itself by thaum-tools (exec).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "game/command_line/command.h"

namespace thaum::game::inline app {

/// Runs the command that the first word names, with the other words. If there is no first word or it is an
/// option, runs the command play. A command of Thaum that this program does not have is left to the program
/// `others` in the same folder; if `others` is empty, there is no such command. `help` and --version are
/// answered here. Returns the exit code.
int dispatch(std::vector<std::string> words, std::string_view others);

/// Replaces this process by another program of Thaum in the same folder, such as thaum-bench (exec). Returns
/// only if it cannot be started: the exit code, after one line that says why.
int become(std::string_view program, const std::vector<std::string>& words);

}  // namespace thaum::game::inline app
