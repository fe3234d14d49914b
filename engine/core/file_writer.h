// core/file_writer.h: a file of any length, written piece by piece. It is written beside the target and renamed over it
// at the end, so that the target is the old or the new file, whole, and a writer that is given up leaves nothing.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

class FileWriter {
public:
    /// The error names the path: it cannot be created, or something is there that is no ordinary file.
    static Expected<FileWriter> create(std::filesystem::path path);
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter();

    /// After a failure (a full disk) nothing more is written; `close` tells it.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    /// Puts the file in its place. The error names the path.
    Expected<void> close();

private:
    FileWriter(std::filesystem::path path, std::string part, int fd);
    void flush();

    std::filesystem::path path_;
    std::string part_;  ///< where it is written
    int fd_;
    int fault_ = 0;  ///< errno of the first write that failed
    Bytes buffer_;
};

}  // namespace thaum
