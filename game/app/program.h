// game/app/program.h: what each program of Thaum does before and after its work.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace thaum::game::inline app {

/// Work of a program: takes the words of its command line and returns an exit code.
using Dispatch = int (*)(std::vector<std::string> words);

/// Runs a program: sets the floating-point mode that results depend on, turns exceptions into one line of
/// text, and tests whether all output was written. Returns the exit code, or ends the process if a library
/// hangs.
int run_program(int argc, char** argv, Dispatch dispatch);

/// Protects Thaum's programs and the data files of matches from being overwritten by any command. The
/// pictures in the folder of data files stay writable, because this program makes them. The command `gesture`
/// may add gesture files. The settings file is protected, too, unless the command has a menu in which
/// settings are changed.
void protect_inputs(std::string_view command);

}  // namespace thaum::game::inline app
