// game/bots/range_files.h: the range's data files, read again when they change on disk. Only who runs a range has one of
// these: a match that is recorded must be what its log's header says.
#pragma once
#include "core/file_watch.h"
#include "game/bots/range.h"

namespace thaum::game {

struct Reload {
    std::shared_ptr<const RangeData> data;  ///< null: what was in force stays so
    std::string line;                       ///< which files were read, or what is wrong: file, line and key
};

class RangeFiles {
public:
    static Expected<RangeFiles> open(const std::filesystem::path& assets, const DataChoice& choice);

    /// As the files were when opened.
    const RangeData& data() const { return data_; }
    /// To be called a few times a second, by a thread that may wait for the disk. A change is read at the second look after it.
    std::optional<Reload> look();

private:
    RangeFiles(std::filesystem::path assets, DataChoice choice, RangeData data);

    std::filesystem::path assets_;
    DataChoice choice_;
    RangeData data_;
    FileWatch watch_;
    std::vector<std::string> unread_{};  ///< files that changed and that no good reading has followed
};

}  // namespace thaum::game
