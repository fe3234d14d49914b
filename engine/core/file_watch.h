// core/file_watch.h: which of a few files have changed on disk, by asking for their size and time now and then.
//
//     FileWatch watch({"a.toml", "b.toml"});
//     for (;; sleep(0.2)) if (auto changed = watch.look(); !changed.empty()) read_again(changed);
//
// Editors write in several steps, or write another file and rename it. So a change is told only once every file is as it
// was at the look before, and two changes between two looks are one.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace thaum {

class FileWatch {
public:
    /// Files that are missing are watched as well: they may come.
    explicit FileWatch(std::vector<std::filesystem::path> files);

    /// The files that are not what they were when last told of, or at the beginning; none while one is still being
    /// written. A file that is gone has changed, too.
    std::vector<std::filesystem::path> look();

private:
    /// What tells one content of a file from the next without reading it.
    struct Stamp {
        std::uint64_t device{}, number{}, mode{}, size{};  ///< all 0: there is nothing
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
