// thaum bench: starts thaum-bench, which stands beside this program. The benchmarks are a program of their own,
// because they count allocations by replacing malloc.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/text.h"
#include "game/app/command.h"

namespace thaum::app {
namespace {

int run_bench(const std::vector<std::string>& words) {
    std::error_code unreadable;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    const std::string program = (self.parent_path() / "thaum-bench").string();
    std::vector<std::string> arguments{program};
    arguments.insert(arguments.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    return refuse({text("cannot start ", program, ": ", std::strerror(errno),
                        "; build it (./thaum bench does) or install it beside this program")});
}

}  // namespace

Command bench_command() { return {"bench", "measure time against error", "", run_bench}; }

}  // namespace thaum::app
