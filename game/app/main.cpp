// thaum: the program. The first word names the command; without a command word it is `play`.
#include <cstdio>
#include <string>
#include <vector>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::app {
namespace {

std::vector<Command> commands() {
    return {play_command(),     range_command(),   replay_command(), shots_command(), diff_command(),
            scenario_command(), league_command(),  lab_command(),    bench_command(), plot_command(),
            sounds_command(),   gesture_command(), doctor_command()};
}

void print_overview() {
    std::printf("Thaum %s: a duel of two wizards on one machine\n\nusage: thaum [COMMAND] [OPTIONS]\n\n",
                THAUM_VERSION);
    for (const auto& command : commands()) {
        std::printf("  %-9s %s\n", std::string(command.name).c_str(), std::string(command.summary).c_str());
    }
    std::printf(
        "\n`thaum help COMMAND` or `thaum COMMAND --help` explains a command. Without a command: play.\n");
}

int dispatch(std::vector<std::string> words) {
    if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h" || words[0] == "help")) {
        print_overview();
        return done;
    }
    if (words.size() == 1 && words[0] == "--version") {
        std::printf("thaum %s\n", THAUM_VERSION);
        return done;
    }
    if (words.size() > 1 && words[0] == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    std::string name = "play";
    if (!words.empty() && !words[0].starts_with("-")) {
        name = words[0];
        words.erase(words.begin());
    }
    for (const auto& command : commands()) {
        if (command.name != name) continue;
        if (asks_for_help(words) && !command.help.empty()) {
            std::printf("%s", std::string(command.help).c_str());
            return done;
        }
        protect_inputs(name);
        return command.run(words);
    }
    return refuse({text("unknown command '", name, "'; `thaum --help` lists them")});
}

}  // namespace

}  // namespace thaum::app

int main(int argc, char** argv) { return thaum::app::run_program(argc, argv, thaum::app::dispatch); }
