// core/write_rule.h: decides which files this program may write.
//
// Every reader in core and input declares here what it opens, and every writer checks here. So no output
// destroys an input: a file that this run has read is never replaced, under whatever name. Exceptions are
// files that the program owns (read_own_text_file) and files that this run has written itself. A recorded
// match is never replaced either.
#pragma once
#include <filesystem>
#include <string_view>

#include "core/error.h"

namespace thaum {

/// First bytes of every recorded match (.thaumlog).
inline constexpr std::string_view recording_magic = "THAUMLOG";

/// Whether the file exists and begins with `recording_magic`.
bool begins_like_recording(const std::filesystem::path& path);

/// Declares a file that a reader has opened. From now on no writer replaces it, unless this run had written
/// it. Two names mean the same file if device and inode agree.
void declare_read(const std::filesystem::path& path);

/// Declares a file that a writer of this run has completed, so that this run may replace it again.
void declare_written(const std::filesystem::path& target);

/// Declares a file, or a folder of files, that no writer may replace, whoever wrote them. A command calls it
/// for files that it may read only after it has begun to write others.
void protect_input(const std::filesystem::path& path);

/// Returns true if both paths lead to the same file, whether or not the file exists yet.
bool same_target(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns the path at which a writer of `target` puts its file, with symbolic links resolved. The error is
/// one line with the path. The error says that the target is an input, a recording, not an ordinary file, or
/// not writable.
Expected<std::filesystem::path> writable_target(const std::filesystem::path& target);

}  // namespace thaum
