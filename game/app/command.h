// game/app/command.h: the commands of the program, `thaum WORD ...`. Each command is one .cpp file of this folder or of a
// folder in it.
#pragma once
#include <string>
#include <vector>

#include "game/command_line/exit_code.h"

namespace thaum::app {

struct Command {
    std::string_view name;
    std::string_view summary;  ///< one line for the list of commands
    /// Text of `thaum WORD --help`; fits a screen. Empty if `run` prints it.
    std::string_view help;
    int (*run)(const std::vector<std::string>& words);
};

Command play_command();
Command range_command();
Command replay_command();
Command diff_command();
Command shots_command();
Command scenario_command();
Command league_command();
Command bench_command();
Command doctor_command();
Command plot_command();
Command lab_command();
Command sounds_command();
Command gesture_command();

/// Tests whether a desktop is there to open a window on.
bool display_there();

}  // namespace thaum::app
