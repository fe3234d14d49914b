#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/text.h"
#include "game/app/command.h"

namespace thaum::game::inline app {
int become(std::string_view program, const std::vector<std::string>& words) {
    std::error_code unreadable;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    const std::string path = (self.parent_path() / program).string();
    std::vector<std::string> arguments{path};
    arguments.insert(arguments.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(path.c_str(), pointers.data());
    return refuse({text("cannot start ", path, ": ", std::strerror(errno),
                        "; build it (./thaum does, given the command) or install it beside this program")});
}

}  // namespace thaum::game::inline app
