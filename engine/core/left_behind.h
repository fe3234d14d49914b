// core/left_behind.h: files that systems and editors leave in folders, and that are nobody's data.
#pragma once
#include <string_view>

namespace thaum {

/// Whether a file or folder of this name is passed over: hidden files, copies of editors (bolt.toml~, bolt.toml.bak), what
/// desktops write (desktop.ini, Thumbs.db), and what a person may put beside data to explain it (README.md).
bool is_left_behind(std::string_view file_name);

}  // namespace thaum
