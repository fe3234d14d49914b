// game/app/content_names.h: which files the folder of data files may contain.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::game::inline app {

/// The files of the folder, and a line on each file that nothing reads because of its name, ending or folder.
struct KnownFiles {
    std::size_t files{};  ///< number of files that something may read
    std::vector<std::string> faults;
    std::vector<std::string> read{};  ///< TOML files with an allowed name: "wands/bolt.toml", sorted
};

KnownFiles check_file_names(const std::filesystem::path& assets);

}  // namespace thaum::game::inline app
