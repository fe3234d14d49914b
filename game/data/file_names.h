// game/data/file_names.h: names of data files by which something is chosen: an arena, a bot, a mutator.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace thaum::game::inline data {

/// Largest data file that is read (bytes).
inline constexpr std::size_t max_data_file = 1U << 20U;

/// Whether a data file may have the name: 1 to 64 of a-z, 0-9 and _.
bool plain_name(std::string_view name);

/// Names of the data files in a folder, without .toml, sorted; none if the folder cannot be read. Files whose
/// names are not plain are left out.
std::vector<std::string> stems_in(const std::filesystem::path& folder);

/// Refuses a name that is not among the known ones. `what`: a noun for it, such as "arena".
Expected<void> check_name(const std::vector<std::string>& known, std::string_view name,
                          std::string_view what);

}  // namespace thaum::game::inline data
