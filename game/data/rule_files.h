// game/data/rule_files.h: the files of assets/rules: rule sets, and lengths of a match.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::game::inline data {

/// Names that a rule set may have: those of the files in assets/rules that are no lengths of a match, sorted.
std::vector<std::string> rule_sets(const std::filesystem::path& assets);
/// Names that the length of a match may have, sorted: those of the files in assets/rules that say how long a
/// round lasts (`kills` or `seconds`), and of the files there that cannot be read.
std::vector<std::string> match_lengths(const std::filesystem::path& assets);

/// Whether assets/rules has a file of this name that cannot be read, so that nobody can tell which of the
/// two it is. Reading it tells its fault.
bool is_unreadable_rule_file(const std::filesystem::path& assets, const std::string& name);

}  // namespace thaum::game::inline data
