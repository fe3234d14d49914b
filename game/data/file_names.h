// game/data/file_names.h: data files by their names, and the names by which an arena, a bot or a mutator is
// chosen.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/error.h"

namespace thaum::game::inline data {

/// Whether a data file may have the name: 1 to 64 of a-z, 0-9 and _.
bool plain_name(std::string_view name);

/// Names of the data files in a folder, without .toml, sorted; none if the folder cannot be read. Files whose
/// names are not plain are left out.
std::vector<std::string> stems_in(const std::filesystem::path& folder);

/// Reads and parses a data file. `name`: its path below the assets. Messages call the file by shown_path.
Expected<Config> read_data_file(const std::filesystem::path& assets, std::string_view name);

/// Refuses a name that is not among the known ones. `what`: a noun for it, such as "arena".
Expected<void> check_name(const std::vector<std::string>& known, std::string_view name,
                          std::string_view what);

}  // namespace thaum::game::inline data
