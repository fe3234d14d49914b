// game/app/command.h: the commands of the program, `thaum WORD ...`. Each command is one .cpp file of this folder or of a
// folder in it.
//
// What players need stands in the program thaum (thaum_main.cpp). The other commands stand in thaum-tools
// (tools_main.cpp), which has all commands; thaum starts it in its own place for them. So a first start compiles no tools.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "game/command_line/exit_code.h"

namespace thaum::app {

struct Command {
    std::string_view name;
    std::string_view summary;  ///< one line for the list of commands
    /// Text of `thaum WORD --help`; fits a screen. Empty if `run` prints it.
    std::string_view help;
    int (*run)(const std::vector<std::string>& words);  ///< null: thaum-tools runs it
};

Command play_command();
Command range_command();
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

/// Summaries of the commands of thaum-tools, which thaum lists, too.
namespace summaries {
inline constexpr std::string_view replay = "play a recorded match again, or check it";
inline constexpr std::string_view shots = "make the README's pictures from a replay";
inline constexpr std::string_view diff = "find the first difference of two states or two replays";
inline constexpr std::string_view scenario = "play gameplay scenarios and check what they find";
inline constexpr std::string_view league =
    "bots of all levels against each other: who wins, how long it takes";
inline constexpr std::string_view lab = "a volume to feel, read and carve, or the cauldron's brew alone";
inline constexpr std::string_view plot = "draw a benchmark's report";
inline constexpr std::string_view sounds = "list the sounds; write them as files and pictures";
inline constexpr std::string_view gesture = "measure, train and check the recognisers of gestures";
}  // namespace summaries

/// Runs the command whose name is the first word with the other words, or play if the first word is an option or
/// missing. `help` and --version are answered here. Returns the exit code.
int dispatch(const std::vector<Command>& commands, std::vector<std::string> words);

/// Runs a program of ours that stands in the same folder, such as thaum-bench, instead of this one. Returns only if it
/// cannot be started: the exit code, after one line that says why.
int become(std::string_view program, const std::vector<std::string>& words);

/// Tests whether a desktop is there to open a window on.
bool display_there();

}  // namespace thaum::app
