#include "field/detail/sample_file.h"

#include <algorithm>
#include <optional>

#include "core/letters.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::field {
namespace {

using Path = std::filesystem::path;

bool is_there(const Path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

Path as_named(const Path& header, std::string_view name) { return header.parent_path() / Path(name); }

/// The entry of a folder that is called `name`, or else the only one whose name differs in capitals alone.
std::optional<Path> entry_like(const Path& folder, std::string_view name) {
    if (is_there(folder / name)) return folder / name;
    std::optional<Path> found;
    std::error_code error;
    const Path listed = folder.empty() ? Path(".") : folder;
    for (std::filesystem::directory_iterator at(listed, error), end; !error && at != end;
         at.increment(error)) {
        const auto entry = at->path().filename();
        if (!same_word(entry.string(), name)) continue;
        if (found) return {};
        found = folder / entry;
    }
    return found;
}

/// The entry that a relative path leads to, where each part of the path may differ in capitals.
std::optional<Path> entry_at(Path folder, const Path& relative) {
    if (relative.is_absolute()) return {};
    for (const auto& part : relative) {
        if (part == "." || part.empty()) continue;
        const auto next = part == ".." ? folder / ".." : entry_like(folder, part.string());
        if (!next) return {};
        folder = *next;
    }
    return folder;
}

}  // namespace

Path sample_file(const Path& header, std::string_view name) {
    Path named = as_named(header, name);
    if (is_there(named)) return named;
    // Some programs put the name in quotes.
    if (name.size() > 2 && name.starts_with('"') && name.ends_with('"'))
        name = name.substr(1, name.size() - 2);
    std::string with_slashes(name);
    std::ranges::replace(with_slashes, '\\', '/');
    const Path folder = header.parent_path(), path = with_slashes;
    auto found = entry_at(folder, path);
    if (!found && path.has_filename()) found = entry_like(folder, path.filename().string());
    return found ? *found : named;
}

std::string note_on_place(const Path& header, std::string_view name, const Path& found) {
    const auto place = found.lexically_normal().string();
    if (found != as_named(header, name))
        return in_one_line(
            text("there is no file '", printable(name, 200), "'; the samples are read from ", place));
    const auto relative = Path(name).lexically_normal();
    if (Path(name).is_absolute() || *relative.begin() == "..")
        return in_one_line(text("the samples are read from ", place));
    return {};
}

}  // namespace thaum::field
