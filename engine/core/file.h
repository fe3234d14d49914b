// core/file.h: reads and writes whole files. Reading rejects anything but an ordinary file; writing never
// leaves half a file.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

/// Reads a whole file. From then on this run of the program refuses to overwrite the file, so that no output
/// destroys an input. The error names the path and the fault: missing, not an ordinary file (directory, fifo,
/// device), larger than `limit` bytes, or not readable.
Expected<Bytes> read_file(const std::filesystem::path& path, std::size_t limit);

/// Reads the first bytes of a file, at most `most`. The file may have any length; the other errors are those
/// of `read_file`.
Expected<Bytes> read_start(const std::filesystem::path& path, std::size_t most);

/// Reads a whole file, as `read_file` does, and returns it as text.
Expected<std::string> read_text_file(const std::filesystem::path& path, std::size_t limit);

/// Reads a file that the program owns and may overwrite later, such as its settings. tests/structure lists
/// the callers that may use this.
Expected<std::string> read_own_text_file(const std::filesystem::path& path, std::size_t limit);

/// Files of a folder whose names end with `ending`, such as ".toml", sorted. The error names a folder that
/// cannot be read.
Expected<std::vector<std::filesystem::path>> files_in(const std::filesystem::path& folder,
                                                      std::string_view ending);

/// Words for a message, such as "; did you mean 'blast'?", if the folder has a file of a similar name; else
/// empty. Names are without extension.
std::string near_file(std::string_view name, const std::filesystem::path& folder, std::string_view ending);

/// Writes all bytes to an open descriptor. On failure returns false with errno set; some bytes may already be
/// written.
bool write_all(int fd, std::span<const std::byte> bytes);

/// Waits until the bytes of an open file are on the disk. On failure returns false with errno set. An
/// interruption by a signal is no failure, nor is a file that does not support flushing.
bool flush_to_disk(int fd);

/// Opens a placeholder for each of standard input, output and error that is closed. Without it, a file that
/// is opened later would get the number of the closed stream, and printed text would be written into the
/// file. Printing to a closed stream fails as before.
void occupy_closed_streams();

/// Creates the folder and any missing parent folders. The error names the folder that cannot be created or is
/// not writable.
Expected<void> make_folder(const std::filesystem::path& folder);

/// A new empty folder in the system's temporary directory. The destructor removes it with all its contents.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    /// Path of the folder; empty if none could be created.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Checks before long work whether a file can be written at `path`. An existing file that is an input or a
/// recording must not be replaced. Leaves no file behind.
Expected<void> check_output(const std::filesystem::path& path);

/// Writes a temporary file beside the target, then renames it over the target. The target is always either
/// the old or the new file, complete. Inputs and recordings are never replaced (write_rule.h).
Expected<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
/// Writes a text as `write_file` writes bytes.
Expected<void> write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace thaum
