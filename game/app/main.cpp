// thaum: the program. The first word names the command; without a command word it is `play`.
#include <cerrno>
#include <cfenv>
#include <csignal>
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
#include "game/app/settings.h"
#include "game/data/match_data.h"
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
    std::printf("\n`thaum COMMAND --help` explains a command. Without a command: play.\n");
}

bool asks_for_help(const std::vector<std::string>& words) {
    for (const auto& word : words) {
        if (word == "--help" || word == "-h") return true;
    }
    return false;
}

/// Protects the data files of matches and the program from being overwritten by any command. The pictures beside
/// the data stay writable, because this program makes them. The settings are protected from commands without a
/// menu, which is where they are changed.
void protect_inputs(std::string_view command) {
    protect_input("/proc/self/exe");
    const bool has_menu = command == "play" || command == "range" || command == "replay";
    if (const auto settings = settings_file(); !has_menu && !settings.empty()) protect_input(settings);
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
        protect_inputs(name);
        return command.run(words);
    }
    return refuse({text("unknown command '", name, "'; `thaum --help` lists them")});
}

/// Runs a command. Reports an exception that no other code handled in one line.
int dispatch_guarded(std::vector<std::string> words) {
    try {
        return dispatch(std::move(words));
    } catch (const std::system_error& refused) {
        return refuse({text("the system refused a resource that the program needs: ", refused.what())});
    } catch (const std::bad_alloc&) {
        return refuse({"out of memory"});
    }
}

/// Tests whether all printed text was written: a disk may be full, or a pipe closed. Without that a command
/// would succeed silently.
int with_output_checked(int code) {
    const bool failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) == 0 && !failed) return code;
    return refuse({text("cannot write to standard output: ", std::strerror(errno))});
}

}  // namespace

}  // namespace thaum::app

int main(int argc, char** argv) {
    // Resets the rounding mode, which a parent process may have changed; no result may depend on it. Threads
    // inherit the mode.
    std::fesetenv(FE_DFL_ENV);
    // Without this signal a file beyond the shell's size limit is a failed write, as on a full disk, and does
    // not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    thaum::keep_freed_memory();
    const int code = thaum::app::with_output_checked(thaum::app::dispatch_guarded({argv + 1, argv + argc}));
    if (!thaum::input::OpenHaptics::hangs()) return code;
    // Skips all clean-up at exit, because a library that hangs would hang there too.
    std::fflush(nullptr);
    std::_Exit(code);
}
