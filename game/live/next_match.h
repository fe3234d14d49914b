// game/live/next_match.h: data of the next match of a live session: a duel by the menu's choices, or practice
// on the range.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "game/range/apprentice.h"
#include "game/range/range_files.h"

namespace thaum::game::inline live {

class NextMatch {
public:
    NextMatch(std::filesystem::path assets, std::shared_ptr<const MatchData> data)
        : assets_(std::move(assets)), data_(std::move(data)) {}

    const std::shared_ptr<const MatchData>& data() const { return data_; }
    /// Whether the next match is practice on the range.
    bool is_practice() const { return range_.has_value(); }

    /// Reads the data of a match again for each match, because the practice range lets players edit the
    /// files. `match`: the rules, a file of assets/rules. `arena`: a file of assets/arenas. After an error,
    /// which names file, line and key, the old data stays.
    Expected<void> choose(const std::string& match, const std::string& arena,
                          std::vector<std::string> mutators = {});
    /// Makes the next match practice on the range. The error names file, line and key.
    Expected<void> open_range();
    /// Makes the next match the Apprentice, a tutorial on the practice range in an arena of its own. The
    /// error names file, line and key.
    Expected<void> open_apprentice();
    /// Hands over the lessons of the Apprentice (the tutorial on the practice range), for one match;
    /// std::nullopt: the next match has none.
    std::optional<Lessons> take_lessons() { return std::exchange(lessons_, std::nullopt); }
    /// Whether the next match has the lessons of the practice range (the Apprentice).
    bool is_apprentice() const { return lessons_.has_value(); }
    /// Hands over the data files of the practice range, for one match; std::nullopt: the next match is not on
    /// the range.
    std::optional<RangeFiles> take_range() { return std::exchange(range_, std::nullopt); }

private:
    std::filesystem::path assets_;
    std::shared_ptr<const MatchData> data_;
    Expected<void> open_range(const DataChoice& choice);

    std::optional<RangeFiles> range_{};
    std::optional<Lessons> lessons_{};
};

}  // namespace thaum::game::inline live
