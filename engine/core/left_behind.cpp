#include "core/left_behind.h"

#include <algorithm>

#include "core/letters.h"

namespace thaum {

bool is_left_behind(std::string_view name) {
    constexpr std::string_view names[] = {
        "desktop.ini", "thumbs.db", "ehthumbs.db", "icon\r",      "__macosx", "readme",     "readme.md",
        "readme.txt",  "license",   "license.md",  "license.txt", "copying",  "lost+found", "$recycle.bin"};
    constexpr std::string_view endings[] = {"~",    ".bak", ".backup", ".old", ".orig",
                                            ".rej", ".swp", ".swo",    ".tmp", ".part"};
    const auto ends_name = [&](std::string_view ending) {
        return name.size() > ending.size() && same_word(name.substr(name.size() - ending.size()), ending);
    };
    const bool is_unsaved = name.size() > 2 && name.starts_with('#') && name.ends_with('#');
    return name.starts_with('.') || is_unsaved ||
           std::ranges::any_of(names, [&](std::string_view known) { return same_word(name, known); }) ||
           std::ranges::any_of(endings, ends_name);
}

}  // namespace thaum
