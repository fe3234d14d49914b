#include "game/range/range_files.h"

#include <algorithm>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline range {
namespace {

std::vector<std::filesystem::path> paths_of(const std::filesystem::path& assets, const MatchData& data) {
    std::vector<std::filesystem::path> paths;
    for (const auto& file : data.files) paths.push_back(assets / file.name);
    paths.push_back(assets / "events.toml");  // not among data.files, because it changes only what is shown
    return paths;
}

std::string joined(const std::vector<std::string>& names) {
    std::string words;
    for (const auto& name : names) words += text(words.empty() ? "" : ", ", name);
    return words;
}

}  // namespace

RangeFiles::RangeFiles(std::filesystem::path assets, DataChoice choice, RangeData data)
    : assets_(std::move(assets)),
      choice_(std::move(choice)),
      data_(std::move(data)),
      watch_(paths_of(assets_, *data_.match)) {}

Expected<RangeFiles> RangeFiles::open(const std::filesystem::path& assets, const DataChoice& choice) {
    auto data = load_range(assets, choice);
    if (!data) return data.error();
    return RangeFiles(assets, choice, std::move(*data));
}

std::optional<Reload> RangeFiles::look() {
    const auto changed = watch_.look();
    if (changed.empty()) return {};
    for (const auto& path : changed) {
        const auto name = path.lexically_relative(assets_).generic_string();
        if (std::find(unread_.begin(), unread_.end(), name) == unread_.end()) unread_.push_back(name);
    }
    auto data = load_range(assets_, choice_);
    if (!data) return Reload{nullptr, text(in_one_line(data.error().message), " (the old data stays)")};
    const auto names = joined(std::exchange(unread_, {}));
    return Reload{std::make_shared<const RangeData>(std::move(*data)), text("read ", names)};
}

}  // namespace thaum::game::inline range
