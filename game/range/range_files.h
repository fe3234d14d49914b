// game/range/range_files.h: reads the practice range's data files again when they change on disk. Only a
// range may do so: a recorded match must keep the data that its log's header names.
#pragma once
#include "core/file_watch.h"
#include "game/range/range.h"

namespace thaum::game::inline range {

/// Result of reading changed data files.
struct Reload {
    std::shared_ptr<const RangeData> data;  ///< new data; null: the old data stays in use
    std::string line;                       ///< names of the files read, or the error with file, line and key
};

/// Watches the data files of a practice range.
class RangeFiles {
public:
    static Expected<RangeFiles> open(const std::filesystem::path& assets, const DataChoice& choice);

    /// Data read when the object was created.
    const RangeData& data() const { return data_; }
    /// Reads files that have changed. Call this a few times a second, from a thread that may wait for the
    /// disk. A change is read at the second call after it, when the file no longer changes.
    std::optional<Reload> look();

private:
    RangeFiles(std::filesystem::path assets, DataChoice choice, RangeData data);

    std::filesystem::path assets_;
    DataChoice choice_;
    RangeData data_;
    FileWatch watch_;
    std::vector<std::string> unread_{};  ///< changed files that have not been read successfully yet
};

}  // namespace thaum::game::inline range
