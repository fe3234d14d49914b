// core/write_rule.h: which files this program may write. Every writer of core asks here, so that no output destroys an
// input: a file that the command reads is never replaced, under whatever name, and neither is a recorded match.
#pragma once
#include <filesystem>
#include <string_view>

#include "core/error.h"

namespace thaum {

/// First bytes of every recorded match (.thaumlog).
inline constexpr std::string_view recording_magic = "THAUMLOG";

bool begins_like_recording(const std::filesystem::path& path);

/// Declares a file that this run of the program reads, or a folder of such files: from now on no writer replaces it.
/// Two names mean the same file where device and inode agree.
void protect_input(const std::filesystem::path& path);

/// Do both lead to one file, whether it is there already or not?
bool same_target(const std::filesystem::path& a, const std::filesystem::path& b);

/// The path at which a writer of `target` puts its file: symbolic links are followed. The error is one line with the
/// path: the target is an input, a recording, no ordinary file, or may not be written.
Expected<std::filesystem::path> writable_target(const std::filesystem::path& target);

}  // namespace thaum
