#include "core/file_writer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/assert.h"
#include "core/file.h"
#include "core/text.h"
#include "core/write_rule.h"

namespace thaum {
namespace {

constexpr std::size_t buffer_size = 1U << 16U;
constexpr std::size_t longest_name = 255;  ///< longest file name (bytes)

Error fault(const std::filesystem::path& path, std::string_view doing, int why) {
    return fail(text(path.string(), ": cannot ", doing, ": ", std::strerror(why)));
}

/// Creates a new file beside the target. It never opens an existing file, because its name could be a link to
/// another user's file. A killed program may have left a file with the same name, so several names are tried.
/// Returns -1 with errno set on failure.
int create_part(const std::filesystem::path& target, std::string& part) {
    constexpr int max_tries = 100;
    for (int i = 0; i < max_tries; ++i) {
        const auto ending = text(".", ::getpid(), "-", i, ".part");
        // The target's name may already have the greatest length, so it is shortened.
        const auto name = target.filename().string().substr(0, longest_name - ending.size());
        part = (target.parent_path() / (name + ending)).string();
        const int fd = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
    return -1;
}

/// Gives the new file the permissions of the file that it replaces. File systems without permissions ignore
/// this.
void take_rights_of(const std::filesystem::path& target, int fd) {
    struct stat info {};
    if (::stat(target.c_str(), &info) == 0 && ::fchmod(fd, info.st_mode & 0777U) != 0) errno = 0;
}

}  // namespace

FileWriter::FileWriter(std::filesystem::path name, std::filesystem::path target, std::string part, int fd)
    : name_(std::move(name)), target_(std::move(target)), part_(std::move(part)), fd_(fd) {
    buffer_.reserve(buffer_size);
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      part_(std::exchange(other.part_, {})),
      claimed_(std::exchange(other.claimed_, false)),
      fd_(std::exchange(other.fd_, -1)),
      fault_(other.fault_),
      written_(other.written_),
      buffer_(std::move(other.buffer_)) {}

FileWriter::~FileWriter() {
    if (fd_ >= 0) ::close(fd_);
    if (!part_.empty()) ::unlink(part_.c_str());
    give_name_back();
}

Expected<FileWriter> FileWriter::create(std::filesystem::path path) {
    auto target = writable_target(path);
    if (!target) return target.error();
    std::string part;
    const int fd = create_part(*target, part);
    if (fd < 0) return fault(path, "create", errno);
    take_rights_of(*target, fd);
    return FileWriter(std::move(path), std::move(*target), std::move(part), fd);
}

Expected<FileWriter> FileWriter::create_new(const std::filesystem::path& path) {
    // The target's name is taken at once by an empty file, so that two programs never choose the same name.
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) return fault(path, "create", errno);
    ::close(fd);
    auto made = create(path);
    if (made)
        made->claimed_ = true;
    else
        ::unlink(path.c_str());
    return made;
}

/// Removes the empty file that reserved the name.
void FileWriter::give_name_back() {
    if (std::exchange(claimed_, false)) ::unlink(target_.c_str());
}

void FileWriter::write(std::span<const std::byte> bytes) {
    written_ += bytes.size();
    if (buffer_.size() + bytes.size() > buffer_size) flush();
    if (bytes.size() < buffer_size) {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    } else if (fault_ == 0 && !write_all(fd_, bytes)) {
        fault_ = errno;
    }
}

void FileWriter::write(std::string_view text) { write(std::as_bytes(std::span(text.data(), text.size()))); }

void FileWriter::replace_start(std::span<const std::byte> bytes) {
    THAUM_ASSERT(bytes.size() <= written_, "replaces more bytes than were written");
    flush();
    if (fault_ != 0) return;
    if (::lseek(fd_, 0, SEEK_SET) != 0 || !write_all(fd_, bytes) || ::lseek(fd_, 0, SEEK_END) < 0)
        fault_ = errno;
}

void FileWriter::flush() {
    if (fault_ == 0 && !write_all(fd_, buffer_)) fault_ = errno;
    buffer_.clear();
}

Error FileWriter::give_up(std::string_view doing, int why) {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
    ::unlink(std::exchange(part_, {}).c_str());
    give_name_back();
    return fault(name_, doing, why);
}

Expected<void> FileWriter::finish() {
    if (fd_ < 0) return {};
    flush();
    if (fault_ != 0) return give_up("write", fault_);
    // Some disks report only at this point that they are full, so the file may still fail here.
    if (!flush_to_disk(fd_)) return give_up("write", errno);
    if (::close(std::exchange(fd_, -1)) != 0) return give_up("write", errno);
    return {};
}

Expected<void> FileWriter::close() {
    if (auto finished = finish(); !finished) return finished;
    // The target may have become an input or a recording since the file was started, so it is checked again.
    const auto still = writable_target(target_);
    if (!still) {
        ::unlink(std::exchange(part_, {}).c_str());
        give_name_back();
        return still.error();
    }
    if (::rename(part_.c_str(), target_.c_str()) != 0) return give_up("replace", errno);
    part_.clear();
    claimed_ = false;
    declare_written(target_);
    return {};
}

}  // namespace thaum
