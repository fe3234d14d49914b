// core/file_reader.h: reads a file of any length piece by piece.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>

#include "core/error.h"

namespace thaum {

/// An open file. Its position is where the next bytes are read.
class FileReader {
public:
    /// Owner of the file that is read. Once a file of the user was opened, this run of the program refuses to
    /// overwrite it. The program's own files, such as its settings, may be overwritten.
    enum class Owner : std::uint8_t { user, program };

    /// A limit that no file exceeds.
    static constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

    /// Opens a file. The error names the path and the fault: missing, not an ordinary file (directory, fifo,
    /// device), larger than `limit` bytes, or not readable.
    static Expected<FileReader> open(const std::filesystem::path& path, std::size_t limit = any_size,
                                     Owner owner = Owner::user);
    FileReader(FileReader&& other) noexcept;
    FileReader& operator=(FileReader&&) = delete;
    ~FileReader();

    /// Length of the file when it was opened (bytes).
    std::size_t size() const { return size_; }
    /// Position of the next byte.
    std::size_t position() const { return position_; }
    void go_to(std::size_t position) { position_ = position; }  ///< sets the position of the next byte
    /// Reads the next bytes and returns their number. It is less than `out` has room for only at the end of
    /// the file. The error names the path.
    Expected<std::size_t> read(std::span<std::byte> out);

private:
    FileReader(std::filesystem::path path, int fd, std::size_t size);

    std::filesystem::path path_;
    int fd_;
    std::size_t size_, position_ = 0;
};

}  // namespace thaum
