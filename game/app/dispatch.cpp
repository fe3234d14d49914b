#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/near_name.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/program.h"

namespace thaum::game::inline app {
namespace {

struct Summary {
    std::string_view name, summary;
};

/// The game's commands in the order in which they are listed, with those that only thaum-tools has.
constexpr Summary overview[] = {
    {"play", "a match: the start screen, or --vs, --solo BOT, --demo"},
    {"range", "practice on a dummy; data files that change are read while it runs"},
    {"replay", "play a recorded match again, or check it"},
    {"shots", "make the README's pictures from a replay"},
    {"diff", "find the first difference of two states or two replays"},
    {"scenario", "play gameplay scenarios and check what they find"},
    {"league", "bots of all levels against each other: who wins, how long it takes"},
    {"lab", "a volume to feel, read and carve, or the cauldron's brew alone"},
    {"bench", "measure time against error"},
    {"plot", "draw a benchmark's report"},
    {"sounds", "list the sounds; write them as files and pictures"},
    {"gesture", "measure, record and check gestures and how they are recognised"},
    {"check", "read all data files and list every fault in them"},
    {"doctor", "check this machine and report what is missing"},
};

void print_line(std::string_view name, std::string_view summary) {
    std::printf("  %-9s %s\n", std::string(name).c_str(), std::string(summary).c_str());
}

void print_overview() {
    std::printf("Thaum %s: a duel of two wizards on one machine\n\nusage: thaum [COMMAND] [OPTIONS]\n\n",
                THAUM_VERSION);
    for (const auto& [name, summary] : overview) print_line(name, summary);
    // Commands that are not in `overview`, such as those of a program outside of this project.
    for (const auto& command : commands())
        if (std::ranges::find(overview, command.name, &Summary::name) == std::end(overview))
            print_line(command.name, command.summary);
    std::printf(
        "\n`thaum help COMMAND` or `thaum COMMAND --help` explains a command. Without a command: play.\n");
}

}  // namespace

int dispatch(std::vector<std::string> words, std::string_view others) {
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
    if (!others.empty() && std::ranges::find(overview, name, &Summary::name) != std::end(overview)) {
        words.insert(words.begin(), name);
        return become(others, words);
    }
    const auto near = did_you_mean(name, overview, &Summary::name);
    return refuse(
        {text("unknown command '", name, "'", near.empty() ? "; `thaum --help` lists them" : near)});
}

}  // namespace thaum::game::inline app
