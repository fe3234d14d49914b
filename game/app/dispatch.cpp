#include <cstdio>
#include <string>
#include <vector>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::app {
namespace {

void print_overview(const std::vector<Command>& commands) {
    std::printf("Thaum %s: a duel of two wizards on one machine\n\nusage: thaum [COMMAND] [OPTIONS]\n\n",
                THAUM_VERSION);
    for (const auto& command : commands) {
        std::printf("  %-9s %s\n", std::string(command.name).c_str(), std::string(command.summary).c_str());
    }
    std::printf(
        "\n`thaum help COMMAND` or `thaum COMMAND --help` explains a command. Without a command: play.\n");
}

}  // namespace

int dispatch(const std::vector<Command>& commands, std::vector<std::string> words) {
    if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h" || words[0] == "help")) {
        print_overview(commands);
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
    for (const auto& command : commands) {
        if (command.name != name) continue;
        if (command.run == nullptr) {
            words.insert(words.begin(), name);
            return become("thaum-tools", words);
        }
        if (asks_for_help(words) && !command.help.empty()) {
            std::printf("%s", std::string(command.help).c_str());
            return done;
        }
        protect_inputs(name);
        return command.run(words);
    }
    return refuse({text("unknown command '", name, "'; `thaum --help` lists them")});
}

}  // namespace thaum::app
