// core/file_writer.h: a file of any length, written piece by piece. It is written beside the target and renamed over it
// at the end, so that the target is the old or the new file, whole, and a writer that is given up leaves nothing. What
// may be replaced is decided in one place for all writers: write_rule.h.
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
    /// The error names the path: it cannot be created, or what lies there must stay.
    static Expected<FileWriter> create(std::filesystem::path path);
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter();

    /// After a failure (a full disk) nothing more is written; `close` tells it.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    /// Forces the bytes onto the disk and puts the file in its place. The error names the path.
    Expected<void> close();

private:
    FileWriter(std::filesystem::path name, std::filesystem::path target, std::string part, int fd);
    void flush();
    tl::unexpected<Error> give_up(std::string_view doing, int why);

    std::filesystem::path name_;    ///< as the caller gave it, for messages
    std::filesystem::path target_;  ///< the file that is replaced: symbolic links followed
    std::string part_;              ///< temporary name, in the target's folder
    int fd_;
    int fault_ = 0;  ///< errno of the first write that failed
    Bytes buffer_;
};

}  // namespace thaum
