#include "game/settings/own_pads.h"

#include <string_view>

#include "core/file.h"
#include "core/text.h"

namespace thaum::app {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 20U;
constexpr std::string_view head =
    "# Mappings of pads that were set up in Thaum, as in SDL's gamecontrollerdb.txt. Lines may be added by "
    "hand.\n";

/// Calls f with each line.
template <class F>
void each_line(std::string_view words, F&& f) {
    while (!words.empty()) {
        const auto end = std::min(words.find('\n'), words.size());
        auto line = words.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        f(line);
        words.remove_prefix(std::min(end + 1, words.size()));
    }
}

bool is_mapping(std::string_view line) { return !line.empty() && !line.starts_with('#'); }

/// The words before the first comma: the model of the pads that a mapping is for.
std::string_view model_of(std::string_view mapping) { return mapping.substr(0, mapping.find(',')); }

Expected<std::string> content_of(const std::filesystem::path& file) {
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error)) return std::string();
    return read_own_text_file(file, largest_file);
}

}  // namespace

std::filesystem::path own_pads_file(const std::filesystem::path& settings_file) {
    return settings_file.empty() ? std::filesystem::path() : settings_file.parent_path() / "pads.txt";
}

Expected<std::vector<std::string>> load_own_pads(const std::filesystem::path& file) {
    const auto content = content_of(file);
    if (!content) return content.error();
    std::vector<std::string> mappings;
    each_line(*content, [&](std::string_view line) {
        if (is_mapping(line)) mappings.emplace_back(line);
    });
    return mappings;
}

Expected<void> save_own_pad(const std::filesystem::path& file, const std::string& mapping) {
    if (file.empty()) return fail("there is no home folder to save it in");
    const auto content = content_of(file);
    if (!content) return content.error();
    std::string words(content->empty() ? head : std::string_view());
    each_line(*content, [&](std::string_view line) {
        if (!is_mapping(line) || model_of(line) != model_of(mapping)) words += text(line, "\n");
    });
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    return write_text_file(file, text(words, mapping, "\n"));
}

}  // namespace thaum::app
