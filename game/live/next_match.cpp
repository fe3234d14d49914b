#include "game/live/next_match.h"

namespace thaum::game::inline live {

Expected<void> NextMatch::choose(const std::string& match, const std::string& arena,
                                 std::vector<std::string> mutators) {
    auto choice = data_->choice;
    choice.match = match;
    choice.arena = arena;
    choice.mutators = std::move(mutators);
    auto data = load_match_data(assets_, choice);
    if (!data) return data.error();
    data_ = std::make_shared<const MatchData>(std::move(*data));
    return {};
}

Expected<void> NextMatch::open_range(const DataChoice& choice) {
    auto files = RangeFiles::open(assets_, choice);
    if (!files) return files.error();
    range_ = std::move(*files);
    return {};
}

Expected<void> NextMatch::open_range() {
    auto choice = data_->choice;
    choice.mutators.clear();  // they change duels; on the range a lesson could become impossible
    return open_range(choice);
}

Expected<void> NextMatch::open_apprentice() {
    auto lessons = load_lessons(assets_);
    if (!lessons) return lessons.error();
    auto choice = data_->choice;
    choice.arena = lessons->arena;
    choice.mutators.clear();
    if (auto opened = open_range(choice); !opened) return opened;
    lessons_ = std::move(*lessons);
    return {};
}

}  // namespace thaum::game::inline live
