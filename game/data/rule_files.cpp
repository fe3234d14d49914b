#include "game/data/rule_files.h"

#include "core/config.h"
#include "core/text.h"
#include "game/data/file_names.h"

namespace thaum::game::inline data {
namespace {

Expected<Config> read_rule_file(const std::filesystem::path& assets, const std::string& name) {
    return read_data_file(assets, text("rules/", name, ".toml"));
}

/// Whether a file of assets/rules is about the length of a match. One that cannot be read counts as such, so
/// that the menu shows its fault.
bool is_match_length(const std::filesystem::path& assets, const std::string& name) {
    const auto file = read_rule_file(assets, name);
    return !file || file->root().has("kills") || file->root().has("seconds");
}

std::vector<std::string> rule_files(const std::filesystem::path& assets, bool lengths) {
    auto names = stems_in(assets / "rules");
    std::erase_if(names, [&](const auto& name) { return is_match_length(assets, name) != lengths; });
    return names;
}

}  // namespace

std::vector<std::string> rule_sets(const std::filesystem::path& assets) { return rule_files(assets, false); }

std::vector<std::string> match_lengths(const std::filesystem::path& assets) {
    return rule_files(assets, true);
}

bool is_unreadable_rule_file(const std::filesystem::path& assets, const std::string& name) {
    std::error_code unknown;
    return plain_name(name) && std::filesystem::exists(assets / text("rules/", name, ".toml"), unknown) &&
           !read_rule_file(assets, name);
}

}  // namespace thaum::game::inline data
