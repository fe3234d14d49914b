// core/file_writer.h: writes a file of any length piece by piece.
//
// The bytes go to a temporary file beside the target, which is renamed over the target at the end. The target
// is always either the old or the new file, complete. A writer destroyed without `close` leaves no file. One
// place decides for all writers which files they may replace: write_rule.h.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

/// Writes a file under a temporary name beside its target; `close` renames it to the target.
class FileWriter {
public:
    /// Starts a file. The error names the path: it cannot be created, or an existing file must not be
    /// replaced.
    static Expected<FileWriter> create(std::filesystem::path path);
    /// Starts a file under a name that does not exist yet, and reserves the name at once with an empty file
    /// until `close`. The error names the path.
    static Expected<FileWriter> create_new(const std::filesystem::path& path);
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    ~FileWriter();

    /// Appends bytes. After a failure (a full disk) writes nothing more; `close` reports the failure.
    void write(std::span<const std::byte> bytes);
    /// Appends the characters of a text as `write` appends bytes.
    void write(std::string_view text);
    /// Replaces the first bytes of what was written, such as a header with a
    /// length that is known only at the end.
    void replace_start(std::span<const std::byte> bytes);
    /// Hands all bytes that were written so far to the operating system.
    void flush();
    /// Whether all writes so far succeeded. Bytes that were not flushed may still fail.
    bool is_whole() const { return fault_ == 0; }
    /// Flushes the bytes to the disk, still under the temporary name. Several files that belong
    /// together are all finished first and then closed, so that a full disk replaces none of
    /// them. The error names the path.
    Expected<void> finish();
    /// Finishes the file and renames it to its target. The error names the path.
    Expected<void> close();

private:
    FileWriter(std::filesystem::path name, std::filesystem::path target, std::string part, int fd);
    Error give_up(std::string_view doing, int why);
    void give_name_back();

    std::filesystem::path name_;    ///< path as given by the caller, for messages
    std::filesystem::path target_;  ///< path of the file to replace, with symbolic links resolved
    std::string part_;           ///< path of the temporary file, in the target's folder; empty: there is none
    bool claimed_ = false;       ///< true: an empty file of our own reserves the target's name
    int fd_;                     ///< file descriptor; -1 once `finish` was called
    int fault_ = 0;              ///< errno of the first write that failed
    std::uint64_t written_ = 0;  ///< bytes that `write` was given
    Bytes buffer_;
};

}  // namespace thaum
