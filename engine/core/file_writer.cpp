#include "core/file_writer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/file.h"
#include "core/text.h"

namespace thaum {
namespace {

constexpr std::size_t buffer_size = 1U << 16U;

tl::unexpected<Error> fault(const std::filesystem::path& path, std::string_view doing, int why) {
    return fail(text(path.string(), ": cannot ", doing, ": ", std::strerror(why)));
}

}  // namespace

FileWriter::FileWriter(std::filesystem::path path, std::string part, int fd)
    : path_(std::move(path)), part_(std::move(part)), fd_(fd) {
    buffer_.reserve(buffer_size);
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : path_(std::move(other.path_)),
      part_(std::move(other.part_)),
      fd_(std::exchange(other.fd_, -1)),
      fault_(other.fault_),
      buffer_(std::move(other.buffer_)) {}

FileWriter::~FileWriter() {
    if (fd_ < 0) return;
    ::close(fd_);
    ::unlink(part_.c_str());
}

Expected<FileWriter> FileWriter::create(std::filesystem::path path) {
    // Renaming over a device would replace it: as root, /dev/null would become a file.
    struct stat info {};
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
        return fail(text(path.string(), ": cannot write: not an ordinary file"));
    auto part = text(path.string(), ".", ::getpid(), ".part");
    const int fd = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) return fault(path, "create", errno);
    return FileWriter(std::move(path), std::move(part), fd);
}

void FileWriter::write(std::span<const std::byte> bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) flush();
    if (bytes.size() < buffer_size) {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    } else if (fault_ == 0 && !write_all(fd_, bytes)) {
        fault_ = errno;
    }
}

void FileWriter::write(std::string_view text) { write(std::as_bytes(std::span(text.data(), text.size()))); }

void FileWriter::flush() {
    if (fault_ == 0 && !write_all(fd_, buffer_)) fault_ = errno;
    buffer_.clear();
}

Expected<void> FileWriter::close() {
    flush();
    if (fault_ != 0) return fault(path_, "write", fault_);
    ::close(std::exchange(fd_, -1));
    if (::rename(part_.c_str(), path_.c_str()) == 0) return {};
    auto error = fault(path_, "replace", errno);
    ::unlink(part_.c_str());
    return error;
}

}  // namespace thaum
