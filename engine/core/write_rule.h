// core/write_rule.h: decides which files this program may write.
//
// Every writer in core checks here, so no output destroys an input. A file that the command reads is never
// replaced, under whatever name. A recorded match is never replaced either.
#pragma once
#include <filesystem>
#include <string_view>

#include "core/error.h"

namespace thaum {

/// First bytes of every recorded match (.thaumlog).
inline constexpr std::string_view recording_magic = "THAUMLOG";

bool begins_like_recording(const std::filesystem::path& path);

/// Declares a file that this run of the program reads, or a folder of such files. From now on no writer
/// replaces it. Two names mean the same file if device and inode agree.
void protect_input(const std::filesystem::path& path);

/// Returns true if both paths lead to the same file, whether or not the file exists yet.
bool same_target(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns the path at which a writer of `target` puts its file, with symbolic links resolved. The error is
/// one line with the path. It says that the target is an input, a recording, not an ordinary file, or not
/// writable.
Expected<std::filesystem::path> writable_target(const std::filesystem::path& target);

}  // namespace thaum
