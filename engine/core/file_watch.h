// core/file_watch.h: reports which of a few files have changed on disk. It polls their size and time.
//
//     FileWatch watch({"a.toml", "b.toml"});
//     for (;; sleep(0.2)) if (auto changed = watch.look(); !changed.empty()) read_again(changed);
//
// Editors write in several steps, or write another file and rename it. A change is therefore reported only
// when every file is the same as in the previous poll. Several changes between two polls count as one.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace thaum {

/// Watches some files, and reports those that have changed.
class FileWatch {
public:
    /// A file that is missing is watched too, since it may appear later.
    explicit FileWatch(std::vector<std::filesystem::path> files);

    /// Returns the files that have changed since this function last returned them, or since the start.
    /// Returns none while any file is still changing. A removed file counts as changed.
    std::vector<std::filesystem::path> look();

private:
    /// Metadata that distinguishes one content of a file from the next without reading it.
    struct Stamp {
        /// Device, inode, type with permissions, and size; all 0 if the file does not exist.
        std::uint64_t device{}, number{}, mode{}, size{};
        std::int64_t written_s{}, written_ns{};
        bool operator==(const Stamp&) const = default;
    };
    struct Watched {
        std::filesystem::path path;
        Stamp told, seen;
    };
    static Stamp stamp_of(const std::filesystem::path& path);

    std::vector<Watched> files_;
};

}  // namespace thaum
