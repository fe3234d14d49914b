#include "game/app/program.h"

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/file.h"
#include "core/memory.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "game/app/command.h"
#include "game/data/match_data.h"
#include "game/settings/settings.h"
#include "input/open_arm.h"

namespace thaum::game::inline app {
namespace {

/// Runs a command. An exception that nothing else has handled is reported in one line.
int dispatch_guarded(Dispatch dispatch, std::vector<std::string> words) {
    try {
        return dispatch(std::move(words));
    } catch (...) {
        return refuse({words_of_exception()});
    }
}

/// Returns `code`, or another exit code if not all printed text was written: a disk may be full, or a pipe
/// closed. Without this test the command would report success.
int with_output_checked(int code) {
    const bool failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) == 0 && !failed) return code;
    return refuse({text("cannot write to standard output: ", std::strerror(errno))});
}

}  // namespace

int run_program(int argc, char** argv, Dispatch dispatch) {
    // Resets the rounding mode, which a parent process may have changed and on which results would depend.
    // Threads inherit the mode.
    std::fesetenv(FE_DFL_ENV);
    // With SIGXFSZ ignored, a file beyond the shell's limit on file size is a failed write, as on a full
    // disk, and does not kill the program.
    std::signal(SIGXFSZ, SIG_IGN);
    occupy_closed_streams();
    tell_unhandled_exceptions();
    keep_freed_memory();
    const int code = with_output_checked(dispatch_guarded(dispatch, {argv + 1, argv + argc}));
    if (!input::arms_hang()) return code;
    // The process ends without the clean-up of a normal exit, because a library that hangs would hang there,
    // too.
    std::fflush(nullptr);
    std::_Exit(code);
}

namespace {

void protect_files_in(const std::filesystem::path& folder) {
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
        protect_input(entry.path());
}

}  // namespace

void protect_inputs(std::string_view command) {
    std::error_code unreadable;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    protect_input("/proc/self/exe");
    for (const auto* program : {"thaum", "thaum-tools", "thaum-bench"})
        protect_input(self.parent_path() / program);
    const bool has_menu = command == "play" || command == "range" || command == "replay";
    if (const auto settings = settings_file(); !has_menu && !settings.empty()) protect_input(settings);
    for (const auto& entry : std::filesystem::directory_iterator(find_assets(), unreadable)) {
        const auto name = entry.path().filename();
        if (name == "gestures" && command == "gesture")
            // `gesture record` may add a new file to this folder, so only its present files are protected.
            protect_files_in(entry.path());
        else if (name != "pictures")
            protect_input(entry.path());
    }
}

}  // namespace thaum::game::inline app
