// game/command_line/exit_code.h: how a command ends.
#pragma once
#include "core/error.h"

namespace thaum::game::inline command_line {

/// Exit codes of every command.
inline constexpr int done = 0;
inline constexpr int does_not_hold = 1;  ///< the command's check has failed
inline constexpr int wrong_use = 2;      ///< wrong usage of the command, or wrong input

/// Prints "thaum: message" to standard error and returns wrong_use.
int refuse(const Error& error);
/// Exit code of work that may have failed. Prints the error if it has.
inline int exit_code_of(const Expected<void>& work) { return work ? done : refuse(work.error()); }

}  // namespace thaum::game::inline command_line
