// thaum: the program. The first word names the command; without one it is `play`.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "core/memory.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "game/app/command.h"
#include "game/match/data.h"
#include "input/drivers/openhaptics.h"

namespace thaum::app {
namespace {

std::vector<Command> commands() {
    return {play_command(),  range_command(),    replay_command(), shots_command(),
            diff_command(),  scenario_command(), league_command(), lab_command(),
            bench_command(), plot_command(),     doctor_command()};
}

void print_overview() {
    std::printf("Thaum %s: a duel of two wizards on one machine\n\nusage: thaum [COMMAND] [OPTIONS]\n\n",
                THAUM_VERSION);
    for (const auto& command : commands()) {
        std::printf("  %-9s %s\n", std::string(command.name).c_str(), std::string(command.summary).c_str());
    }
    std::printf("\n`thaum COMMAND --help` tells the rest. Without a command: play.\n");
}

bool asks_for_help(const std::vector<std::string>& words) {
    for (const auto& word : words) {
        if (word == "--help" || word == "-h") return true;
    }
    return false;
}

/// No command replaces the data that matches are made of. The pictures beside it are this program's own output.
void protect_data_files() {
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(game::find_assets(), unreadable))
        if (entry.path().filename() != "pictures") protect_input(entry.path());
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
    std::string name = "play";
    if (!words.empty() && !words[0].starts_with("-")) {
        name = words[0];
        words.erase(words.begin());
    }
    for (const auto& command : commands()) {
        if (command.name != name) continue;
        if (asks_for_help(words)) {
            std::printf("%s", std::string(command.help).c_str());
            return done;
        }
        protect_data_files();
        return command.run(words);
    }
    return refuse({text("unknown command '", name, "'; `thaum --help` lists them")});
}

/// What nothing nearer could deal with ends here, in a line.
int dispatch_guarded(std::vector<std::string> words) {
    try {
        return dispatch(std::move(words));
    } catch (const std::system_error& refused) {
        return refuse({text("the system refused what the program needs: ", refused.what())});
    } catch (const std::bad_alloc&) {
        return refuse({"out of memory"});
    }
}

/// What was printed may not have arrived: a full disk, a closed pipe. A command that said nothing cannot say so.
int with_output_checked(int code) {
    const bool failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) == 0 && !failed) return code;
    return refuse({text("cannot write to standard output: ", std::strerror(errno))});
}

}  // namespace

}  // namespace thaum::app

int main(int argc, char** argv) {
    thaum::keep_freed_memory();
    const int code = thaum::app::with_output_checked(thaum::app::dispatch_guarded({argv + 1, argv + argc}));
    if (!thaum::input::OpenHaptics::hangs()) return code;
    // The clearing up of a library that hangs would hang, too.
    std::fflush(nullptr);
    std::_Exit(code);
}
