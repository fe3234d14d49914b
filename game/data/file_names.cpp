#include "game/data/file_names.h"

#include <algorithm>

#include "core/file.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/data/match_data.h"

namespace thaum::game::inline data {
namespace {

constexpr std::size_t max_data_file = 1U << 20U;  ///< largest data file that is read (bytes)

}  // namespace

bool plain_name(std::string_view name) {
    return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

std::vector<std::string> stems_in(const std::filesystem::path& folder) {
    std::vector<std::string> stems;
    for (const auto& file : files_in(folder, ".toml").value_or({}))
        if (const auto stem = file.stem().string(); plain_name(stem)) stems.push_back(stem);
    return stems;
}

Expected<Config> read_data_file(const std::filesystem::path& assets, std::string_view name) {
    const auto source = read_text_file(assets / name, max_data_file);
    if (!source) return source.error();
    return Config::parse(*source, shown_path(assets, name), 1);
}

Expected<void> check_name(const std::vector<std::string>& known, std::string_view name,
                          std::string_view what) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    std::string all;
    for (const auto& one : known) all += text(all.empty() ? "" : ", ", one);
    return fail(text("there is no ", what, " '", printable(name, 64),
                     "'; there are: ", all.empty() ? "none" : all, did_you_mean(name, known)));
}

}  // namespace thaum::game::inline data
