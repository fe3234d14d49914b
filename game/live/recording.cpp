#include "game/live/recording.h"

#include "core/text.h"
#include "game/settings/settings.h"

namespace thaum::game::inline live {
namespace {

/// Path with a number before the extension: "match.thaumlog" -> "match-2.thaumlog".
std::filesystem::path numbered(const std::filesystem::path& path, std::uint64_t number) {
    auto next = path;
    return next.replace_filename(text(path.stem().string(), "-", number, path.extension().string()));
}

/// Creates the log under `path` or, if that name is taken, with the next free number. Only an attempt to
/// create the file shows whether its name is free, because another program may take a name at the same time.
Expected<input::LogWriter> create_beside(const std::filesystem::path& path, const input::LogHeader& header) {
    constexpr std::uint64_t last_try = 1000;
    auto log = input::LogWriter::create(path, header);
    auto taken = path;
    std::error_code error;
    for (std::uint64_t number = 2; !log && number < last_try && std::filesystem::exists(taken, error);
         ++number) {
        taken = numbered(path, number);
        log = input::LogWriter::create(taken, header);
    }
    return log;
}

/// Path of a match's log; empty: the match is not recorded.
Expected<std::filesystem::path> log_path(const LogPlace& place) {
    if (!place.named.empty()) return place.named;
    if (place.folder.empty()) return std::filesystem::path();
    return new_match_log(place.folder, place.kept);
}

}  // namespace

Expected<Recording> record_match(const LogPlace& place, std::uint64_t number,
                                 const input::LogHeader& header) {
    const auto path = log_path(place);
    if (!path) return path.error();
    if (path->empty()) return Recording();
    const bool exact = !place.named.empty() && number == 1;
    auto log = exact ? input::LogWriter::create(*path, header) : create_beside(*path, header);
    if (!log) return log.error();
    return Recording(std::move(*log));
}

}  // namespace thaum::game::inline live
