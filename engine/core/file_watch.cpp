#include "core/file_watch.h"

#include <sys/stat.h>

namespace thaum {

FileWatch::FileWatch(std::vector<std::filesystem::path> files) {
    for (auto& file : files) {
        const auto stamp = stamp_of(file);
        files_.push_back({std::move(file), stamp, stamp});
    }
}

FileWatch::Stamp FileWatch::stamp_of(const std::filesystem::path& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) return {};
    return {.device = info.st_dev,
            .number = info.st_ino,
            .mode = info.st_mode,
            .size = static_cast<std::uint64_t>(info.st_size),
            .written_s = info.st_mtim.tv_sec,
            .written_ns = info.st_mtim.tv_nsec};
}

std::vector<std::filesystem::path> FileWatch::look() {
    std::vector<std::filesystem::path> changed;
    bool still = true;
    for (auto& file : files_) {
        const auto now = stamp_of(file.path);
        still = still && now == file.seen;
        file.seen = now;
        if (!(now == file.told)) changed.push_back(file.path);
    }
    if (!still) return {};
    for (auto& file : files_) file.told = file.seen;
    return changed;
}

}  // namespace thaum
