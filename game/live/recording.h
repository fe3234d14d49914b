// game/live/recording.h: the record of a live match, and where the logs of a session's matches lie.
#pragma once
#include <filesystem>
#include <variant>

#include "game/range/range_files.h"
#include "input/log.h"

namespace thaum::game::inline live {

/// Record of a live match: nothing, the writer of its log or, on the practice range, its data files. A match
/// on the range has no log, because its data may change, and a log's header must name the data of all ticks.
using Recording = std::variant<std::monostate, input::LogWriter, RangeFiles>;

/// Place of the logs of one session.
struct LogPlace {
    std::filesystem::path named{};   ///< log that the user named; empty: logs go into `folder`
    std::filesystem::path folder{};  ///< folder for one log per match; empty: matches are not recorded
    int kept = 1;                    ///< number of logs that stay in the folder; older ones are deleted
};

/// Opens the log of the session's match `number` (1: the first). If the user has named a log, that of the
/// first match must get exactly this name, or the result is an error. Later logs lie beside it, with the next
/// free number.
Expected<Recording> record_match(const LogPlace& place, std::uint64_t number, const input::LogHeader& header);

}  // namespace thaum::game::inline live
