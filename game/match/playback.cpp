#include "game/match/playback.h"

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline match {

Expected<Playback> Playback::open(const std::filesystem::path& log, const std::filesystem::path& assets) {
    auto reader = input::LogReader::open(log);
    if (!reader) return reader.error();
    if (reader->format() > 1 && reader->header().kinds.empty())
        return fail(
            text(log.string(), ": the header names no kinds, so the numbers of the log mean nothing"));
    auto match = match_of_log(reader->header(), assets);
    if (!match) return fail(text(log.string(), ": ", in_one_line(match.error().message)));
    Playback playback;
    playback.path_ = log;
    playback.assets_ = assets;
    playback.log_ = std::make_unique<input::LogReader>(std::move(*reader));
    playback.match_ = std::move(*match);
    playback.divergence_ = playback.mismatch();
    return playback;
}

Expected<Playback> Playback::open_again() const {
    auto again = open(path_, assets_);
    if (!again) return again;
    const bool same = again->log().header() == log_->header() && again->log().ticks() == log_->ticks() &&
                      again->log().hashes() == log_->hashes();
    if (!same) return fail(text(path_.string(), ": changed while it was shown"));
    return again;
}

bool Playback::step() {
    if (!log_->next(frame_)) return false;
    match_->tick(frame_);
    if (!divergence_) divergence_ = mismatch();
    return true;
}

bool Playback::play_to(Tick tick) {
    while (match_->now() < tick) {
        if (!step()) return false;
    }
    return true;
}

Expected<void> Playback::restore(std::span<const std::byte> snapshot, Tick at) {
    if (auto restored = match_->restore(snapshot, at); !restored) return restored;
    log_->seek(at);
    return {};
}

std::optional<Divergence> Playback::mismatch() const {
    const auto recorded = log_->hash_at(match_->now());
    if (!recorded) return std::nullopt;
    const Divergence found{*recorded, match_->state_hash(), match_->force_hash()};
    if (recorded->state == found.state && recorded->force == found.force) return std::nullopt;
    return found;
}

std::string described(const Divergence& d) {
    const bool state = d.recorded.state != d.state;
    return text("tick ", d.recorded.tick, ": ", state ? "state differs" : "forces differ", ": the log has ",
                hex(state ? d.recorded.state : d.recorded.force), ", here it is ",
                hex(state ? d.state : d.force));
}

std::string Playback::missing_hashes() const {
    const auto last = log_->ticks();
    for (Tick tick = hash_interval; tick <= last; tick += hash_interval) {
        if (!log_->hash_at(tick)) return text("tick ", tick, ": the log has no hash of this state");
    }
    if (log_->hashes().empty()) return text("the log has no hashes: nothing was compared");
    // Only a log that was closed properly has the hash of its last tick. The hashes of a log that was cut off
    // are valid up to its end.
    if (log_->ended_cleanly() && !log_->hash_at(last))
        return text("tick ", last, ": the log has no hash of its last state");
    return {};
}

std::string Playback::wrong_result() const {
    if (!log_->ended_cleanly() || log_->result() == result_line(*match_)) return {};
    return text("the result differs: the log has \"", in_one_line(log_->result()), "\", here it is \"",
                result_line(*match_), "\"");
}

}  // namespace thaum::game::inline match
