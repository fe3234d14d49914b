// game/app/command.h: the commands of the program, `thaum WORD ...`. Each command is one .cpp file of this folder or of a
// folder in it.
//
// The program thaum has the commands of players (thaum_main.cpp), so that a first start compiles no others. The program
// thaum-tools has all commands (tools_main.cpp). It stands beside thaum, which becomes thaum-tools for the others.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "game/command_line/command.h"

namespace thaum::app {

Command play_command();
Command range_command();
Command check_command();
Command doctor_command();
Command replay_command();
Command diff_command();
Command shots_command();
Command scenario_command();
Command league_command();
Command plot_command();
Command lab_command();
Command sounds_command();
Command gesture_command();
Command bench_command();

/// Runs the command whose name is the first word with the other words, or play if the first word is an option or
/// missing. A command of Thaum that is not among `commands` is left to the program `others` in the same folder; if that
/// is empty, there is no such command. `help` and --version are answered here. Returns the exit code.
int dispatch(const std::vector<Command>& commands, std::vector<std::string> words, std::string_view others);

/// Runs a program of ours that stands in the same folder, such as thaum-bench, instead of this one. Returns only if it
/// cannot be started: the exit code, after one line that says why.
int become(std::string_view program, const std::vector<std::string>& words);

}  // namespace thaum::app
