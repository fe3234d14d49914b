#include "core/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/file_reader.h"
#include "core/file_writer.h"
#include "core/left_behind.h"
#include "core/near_name.h"
#include "core/text.h"

namespace thaum {
namespace {

Error system_error(const std::filesystem::path& path, std::string_view doing) {
    return fail(text(path.string(), ": cannot ", doing, ": ", std::strerror(errno)));
}

/// Reads at most the first `most` bytes of a file. A file of more than `limit` bytes is refused.
Expected<Bytes> read_bytes(const std::filesystem::path& path, std::size_t limit, std::size_t most,
                           FileReader::Owner owner = FileReader::Owner::user) {
    auto file = FileReader::open(path, limit, owner);
    if (!file) return file.error();
    Bytes bytes(std::min(file->size(), most));
    const auto count = file->read(bytes);
    if (!count) return count.error();
    bytes.resize(*count);
    return bytes;
}

}  // namespace

Expected<std::vector<std::filesystem::path>> files_in(const std::filesystem::path& folder,
                                                      std::string_view ending) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    std::filesystem::directory_iterator it(folder, error);
    for (const std::filesystem::directory_iterator end; !error && it != end; it.increment(error)) {
        const auto& path = it->path();
        if (path.extension() == ending && !is_left_behind(path.filename().string())) files.push_back(path);
    }
    if (error) return fail(text(folder.string(), ": the folder cannot be read: ", error.message()));
    std::sort(files.begin(), files.end());
    return files;
}

std::string near_file(std::string_view name, const std::filesystem::path& folder, std::string_view ending) {
    const auto files = files_in(folder, ending);
    if (!files) return "";
    std::vector<std::string> stems;
    for (const auto& file : *files) stems.push_back(file.stem().string());
    return did_you_mean(name, stems);
}

bool write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto n = ::write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
}

bool flush_to_disk(int fd) {
    int failed = 0;
    do {
        failed = ::fdatasync(fd);
    } while (failed != 0 && errno == EINTR);
    return failed == 0 || errno == EINVAL;
}

void occupy_closed_streams() {
    // `open` returns the lowest free descriptor, so it gives 0, 1 and 2, the standard streams, if they are
    // closed.
    int fd = 0;
    do {
        fd = ::open("/dev/null", O_RDONLY);
    } while (fd >= STDIN_FILENO && fd <= STDERR_FILENO);
    if (fd >= 0) ::close(fd);
}

Expected<Bytes> read_file(const std::filesystem::path& path, std::size_t limit) {
    return read_bytes(path, limit, limit);
}

Expected<Bytes> read_start(const std::filesystem::path& path, std::size_t most) {
    return read_bytes(path, FileReader::any_size, most);
}

namespace {

Expected<std::string> as_text(const Expected<Bytes>& bytes) {
    if (!bytes) return bytes.error();
    return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

}  // namespace

Expected<std::string> read_text_file(const std::filesystem::path& path, std::size_t limit) {
    return as_text(read_file(path, limit));
}

Expected<std::string> read_own_text_file(const std::filesystem::path& path, std::size_t limit) {
    return as_text(read_bytes(path, limit, limit, FileReader::Owner::program));
}

Expected<void> make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return fail(text(folder.string(), ": cannot create: ", failed.message()));
    if (!std::filesystem::is_directory(folder, failed))
        return fail(text(folder.string(), ": cannot create: not a folder"));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) return system_error(folder, "write");
    return {};
}

TemporaryFolder::TemporaryFolder() {
    std::error_code failed;
    auto name = (std::filesystem::temp_directory_path(failed) / "thaum-XXXXXX").string();
    if (!failed && ::mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

Expected<void> check_output(const std::filesystem::path& path) {
    const auto file = FileWriter::create(path);
    if (!file) return file.error();
    return {};
}

Expected<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    auto file = FileWriter::create(path);
    if (!file) return file.error();
    file->write(bytes);
    return file->close();
}

Expected<void> write_text_file(const std::filesystem::path& path, std::string_view text) {
    return write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace thaum
