// core/file.h: whole files in and out. Reading refuses what is no ordinary file; writing never leaves half a file.
#pragma once
#include <filesystem>
#include <span>
#include <string_view>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

/// The whole file. The error names the path: missing, not an ordinary file (directory, fifo, device), larger
/// than `limit` bytes, not readable.
Expected<Bytes> read_file(const std::filesystem::path& path, std::size_t limit);

/// As read_file, as text.
Expected<std::string> read_text_file(const std::filesystem::path& path, std::size_t limit);

/// All bytes to an open descriptor; false with errno set, and then part of them may have been written.
bool write_all(int fd, std::span<const std::byte> bytes);

/// Makes the folder and those above it, where they are missing. The error names it: it cannot be made, or nothing can
/// be written in it.
Expected<void> make_folder(const std::filesystem::path& folder);

/// Tells before long work whether a file can be written there, by the rule of write_rule.h. Leaves nothing.
Expected<void> check_output(const std::filesystem::path& path);

/// Writes beside the target and renames over it, so that the target is the old or the new file, whole. An input and a
/// recording are never replaced (write_rule.h).
Expected<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
Expected<void> write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace thaum
