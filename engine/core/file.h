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

/// Writes beside the target and renames over it, so that the target is the old or the new file, whole.
Expected<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
Expected<void> write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace thaum
