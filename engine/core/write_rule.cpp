#include "core/write_rule.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>

#include "core/text.h"

namespace thaum {
namespace {

namespace fs = std::filesystem;

struct KnownFiles {
    std::mutex mutex;
    std::set<fs::path> inputs, read;
    std::set<fs::path> written;  ///< files that this run has written (canonical paths)
};

KnownFiles& known_files() {
    static KnownFiles all;
    return all;
}

bool same_file(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool is_file(const fs::path& path, const struct stat& info) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 && same_file(found, info);
}

/// Returns true if a file below `folder` has this inode. Only files with several hard links need this search.
bool has_other_name_in(const fs::path& folder, const struct stat& info) {
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        if (is_file(it->path(), info)) return true;
    }
    return false;
}

/// Returns true if `path` is inside `folder`. `path` must be absolute and free of symbolic links.
bool lies_below(const fs::path& folder, const fs::path& path) {
    struct stat info {};
    if (::stat(folder.c_str(), &info) != 0 || !S_ISDIR(info.st_mode)) return false;
    for (auto parent = path.parent_path(); parent != parent.parent_path(); parent = parent.parent_path()) {
        if (is_file(parent, info)) return true;
    }
    return false;
}

/// Returns true if `path` is a file or folder that was declared as an input, so that no writer may replace
/// it. `info` is null if no file exists at the path yet.
bool is_input(const fs::path& path, const struct stat* info) {
    auto& known = known_files();
    const std::lock_guard lock(known.mutex);
    const auto is_it = [&](const fs::path& input) { return info != nullptr && is_file(input, *info); };
    const auto holds_it = [&](const fs::path& input) {
        return lies_below(input, path) ||
               (info != nullptr && info->st_nlink > 1 && has_other_name_in(input, *info));
    };
    if (std::ranges::any_of(known.inputs, [&](const auto& i) { return is_it(i) || holds_it(i); }))
        return true;
    return !known.written.contains(path) && std::ranges::any_of(known.read, is_it);
}

bool is_standard_stream(const struct stat& info) {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        struct stat stream {};
        if (::fstat(fd, &stream) == 0 && same_file(stream, info)) return true;
    }
    return false;
}

/// Returns why the existing file must not be replaced; empty if it may be.
std::string why_kept(const fs::path& path, const struct stat& info) {
    if (!S_ISREG(info.st_mode)) return "not an ordinary file";
    if (is_standard_stream(info)) return "it is this program's own standard input or output";
    if (begins_like_recording(path)) return "it is a recording, which nothing replaces; give another name";
    if (::access(path.c_str(), W_OK) != 0) return std::strerror(errno);
    return {};
}

}  // namespace

bool begins_like_recording(const fs::path& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return false;
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return false;
    std::array<char, recording_magic.size()> first{};
    const auto got = ::read(fd, first.data(), first.size());
    ::close(fd);
    return got == static_cast<ssize_t>(first.size()) &&
           std::string_view(first.data(), first.size()) == recording_magic;
}

void declare_read(const fs::path& path) {
    auto& known = known_files();
    const std::lock_guard lock(known.mutex);
    known.read.insert(path);
}

void protect_input(const fs::path& path) {
    auto& known = known_files();
    const std::lock_guard lock(known.mutex);
    known.inputs.insert(path);
}

void declare_written(const fs::path& target) {
    std::error_code error;
    auto real = fs::canonical(target, error);
    auto& known = known_files();
    const std::lock_guard lock(known.mutex);
    if (!error) known.written.insert(std::move(real));
}

bool same_target(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    const auto whole = [&](const fs::path& path) {
        return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    };
    return whole(a) == whole(b) || fs::equivalent(a, b, ignored);
}

Expected<fs::path> writable_target(const fs::path& target) {
    const auto refused = [&](std::string_view why) {
        return fail(text(target.string(), ": cannot write: ", why));
    };
    struct stat info {};
    struct stat link {};
    const bool there = ::stat(target.c_str(), &info) == 0;
    if (!there && ::lstat(target.c_str(), &link) == 0) return refused("a link that leads nowhere");
    std::error_code error;
    auto real = there ? fs::canonical(target, error)
                      : fs::canonical(target.has_parent_path() ? target.parent_path() : ".", error) /
                            target.filename();
    if (error) return fail(text(target.string(), ": cannot create: ", error.message()));
    if (is_input(real, there ? &info : nullptr))
        return refused("it is read by this command; give another name");
    if (!there) return real;
    if (const auto why = why_kept(real, info); !why.empty()) return refused(why);
    return real;
}

}  // namespace thaum
