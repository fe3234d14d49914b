#include "game/app/next_match.h"

namespace thaum::app {

Expected<void> NextMatch::choose(const std::string& match, const std::string& arena) {
    auto choice = data_->choice;
    choice.match = match;
    choice.arena = arena;
    auto data = game::load_match_data(assets_, choice);
    if (!data) return tl::unexpected(data.error());
    data_ = std::make_shared<const game::MatchData>(std::move(*data));
    return {};
}

Expected<void> NextMatch::open_range() {
    auto files = game::RangeFiles::open(assets_, data_->choice);
    if (!files) return tl::unexpected(files.error());
    range_ = std::move(*files);
    return {};
}

}  // namespace thaum::app
