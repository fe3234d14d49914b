#include "core/file_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/text.h"
#include "core/write_rule.h"

namespace thaum {
namespace {

Error reading_fault(const std::filesystem::path& path, std::string_view doing) {
    return fail(text(path.string(), ": cannot ", doing, ": ", std::strerror(errno)));
}

}  // namespace

FileReader::FileReader(std::filesystem::path path, int fd, std::size_t size)
    : path_(std::move(path)), fd_(fd), size_(size) {}

FileReader::FileReader(FileReader&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      size_(other.size_),
      position_(other.position_) {}

FileReader::~FileReader() {
    if (fd_ >= 0) ::close(fd_);
}

Expected<FileReader> FileReader::open(const std::filesystem::path& path, std::size_t limit, Owner owner) {
    // O_NONBLOCK: opening a fifo without a writer must not hang.
    FileReader file(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK), 0);
    if (file.fd_ < 0) return reading_fault(path, "open");
    struct stat info {};
    if (::fstat(file.fd_, &info) != 0) return reading_fault(path, "read");
    if (!S_ISREG(info.st_mode)) return fail(text(path.string(), ": not an ordinary file"));
    if (owner == Owner::user) declare_read(path);
    file.size_ = static_cast<std::size_t>(info.st_size);
    if (file.size_ > limit)
        return fail(text(path.string(), ": ", file.size_, " bytes, more than the limit of ", limit));
    return file;
}

Expected<std::size_t> FileReader::read(std::span<std::byte> out) {
    std::size_t done = 0;
    while (done < out.size()) {
        const auto n = ::pread(fd_, out.data() + done, out.size() - done, static_cast<off_t>(position_));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return reading_fault(path_, "read");
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
        position_ += static_cast<std::size_t>(n);
    }
    return done;
}

}  // namespace thaum
