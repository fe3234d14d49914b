#include "game/match/playback.h"

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game {

Expected<Playback> Playback::open(const std::filesystem::path& log, const std::filesystem::path& assets) {
    auto reader = input::LogReader::open(log);
    if (!reader) return tl::unexpected(reader.error());
    auto match = match_of_log(reader->header(), assets);
    if (!match) return fail(text(log.string(), ": ", in_one_line(match.error().message)));
    Playback playback;
    playback.log_ = std::make_unique<input::LogReader>(std::move(*reader));
    playback.match_ = std::move(*match);
    return playback;
}

bool Playback::step() {
    if (!log_->next(frame_)) return false;
    match_->tick(frame_);
    return true;
}

bool Playback::play_to(Tick tick) {
    while (match_->now() < tick) {
        if (!step()) return false;
    }
    return true;
}

std::optional<input::HashRecord> Playback::mismatch() const {
    const auto recorded = log_->hash_at(match_->now());
    if (!recorded) return std::nullopt;
    const bool same = recorded->state == match_->state_hash() && recorded->force == match_->force_hash();
    return same ? std::nullopt : recorded;
}

}  // namespace thaum::game
