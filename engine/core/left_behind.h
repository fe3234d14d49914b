// core/left_behind.h: recognises files that systems and editors leave in folders and that are no data of the
// program.
#pragma once
#include <string_view>

namespace thaum {

/// Whether a file or folder of this name is to be ignored when a folder of data is read: hidden files, copies
/// of editors (bolt.toml~, bolt.toml.bak), files that desktops write (desktop.ini, Thumbs.db), and files that
/// explain a folder's data (README.md).
bool is_left_behind(std::string_view file_name);

}  // namespace thaum
