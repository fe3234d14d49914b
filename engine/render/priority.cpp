#include "render/priority.h"

#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace thaum::render {
namespace {

// Niceness with which a thread gets a third of the time that a usual thread gets when both want to run.
constexpr int niceness = 5;
constexpr std::string_view rasteriser = "llvmpipe";

void step_back(id_t thread) { static_cast<void>(setpriority(PRIO_PROCESS, thread, niceness)); }

bool draws(const std::filesystem::path& task) {
    std::string name;
    std::getline(std::ifstream(task / "comm"), name);
    return name.starts_with(rasteriser);
}

}  // namespace

void work_behind_others() { step_back(static_cast<id_t>(gettid())); }

void draw_behind_others() {
    work_behind_others();
    std::error_code ignored;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
        const auto word = task.path().filename().string();
        id_t thread = 0;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), thread);
        if (read.ec == std::errc{} && draws(task.path())) step_back(thread);
    }
}

}  // namespace thaum::render
