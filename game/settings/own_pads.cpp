#include "game/settings/own_pads.h"

#include <algorithm>
#include <string_view>

#include "core/file.h"
#include "core/letters.h"
#include "core/text.h"
#include "core/utf8.h"
#include "input/pad_mapping.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::size_t max_mappings_file = std::size_t{1} << 20U;
constexpr std::size_t max_faults_told = 5;
constexpr std::string_view head =
    "# Mappings of pads that were set up in Thaum, as in SDL's gamecontrollerdb.txt. Lines may be added by "
    "hand.\n";

/// Calls f with each line, without a byte order mark.
template <class F>
void each_line(std::string_view words, F&& f) {
    words = without_byte_order_mark(words);
    while (!words.empty()) {
        const auto end = std::min(words.find('\n'), words.size());
        f(words.substr(0, end));
        words.remove_prefix(std::min(end + 1, words.size()));
    }
}

/// Whether a line has more than blanks and a comment.
bool has_content(std::string_view line) {
    const auto first = line.find_first_not_of(" \t\r");
    return first != std::string_view::npos && line[first] != '#';
}

Expected<std::string> content_of(const std::filesystem::path& file) {
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error)) return std::string();
    return read_own_text_file(file, max_mappings_file);
}

/// Rewrites the file without the mappings of one model, and with the line `last` at its end.
Expected<void> replace(const std::filesystem::path& file, std::string_view model, std::string_view last) {
    if (file.empty()) return fail("there is no home folder to save it in");
    const auto content = content_of(file);
    if (!content) return content.error();
    std::string words(content->empty() ? head : std::string_view());
    each_line(*content, [&](std::string_view line) {
        const auto mapping = input::read_pad_mapping(line);
        const bool replaced = mapping && mapping->for_linux && same_word(mapping->model, model);
        if (!replaced) words += text(line, "\n");
    });
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    return write_text_file(file, text(words, last));
}

}  // namespace

std::filesystem::path own_pads_file(const std::filesystem::path& settings_file) {
    return settings_file.empty() ? std::filesystem::path() : settings_file.parent_path() / "pads.txt";
}

OwnPads load_own_pads(const std::filesystem::path& file) {
    OwnPads own;
    const auto content = content_of(file);
    if (!content) {
        own.faults.push_back(content.error().message);
        return own;
    }
    std::vector<input::PadMapping> mappings;
    std::size_t number = 0, faulty = 0;
    each_line(*content, [&](std::string_view line) {
        ++number;
        if (!has_content(line)) return;
        auto mapping = input::read_pad_mapping(line);
        if (!mapping) {
            if (++faulty <= max_faults_told)
                own.faults.push_back(text(file.string(), ":", number, ": ", mapping.error().message));
            return;
        }
        if (!mapping->for_linux) return;
        std::erase_if(mappings, [&](const auto& older) { return older.model == mapping->model; });
        mappings.push_back(std::move(*mapping));
    });
    const auto more = faulty - std::min(faulty, max_faults_told);
    if (more > 0)
        own.faults.push_back(
            text(file.string(), ": ", more, more == 1 ? " more line is faulty" : " more lines are faulty"));
    for (auto& mapping : mappings) own.mappings.push_back(std::move(mapping.words));
    return own;
}

Expected<void> save_own_pad(const std::filesystem::path& file, const std::string& mapping) {
    return replace(file, input::model_of_mapping(mapping), text(mapping, "\n"));
}

Expected<void> forget_own_pad(const std::filesystem::path& file, const std::string& model) {
    return replace(file, model, {});
}

}  // namespace thaum::game::inline settings
