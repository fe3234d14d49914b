#include "game/match/replay_index.h"

#include <zstd.h>

#include <algorithm>

namespace thaum::game::inline match {
namespace {

/// Compression level of zstd. Higher levels take longer and save little, because most bytes of a state are
/// the random bits of fluid samples.
constexpr int packing_level = 1;

Bytes packed(std::span<const std::byte> state) {
    Bytes out(ZSTD_compressBound(state.size()));
    const auto size = ZSTD_compress(out.data(), out.size(), state.data(), state.size(), packing_level);
    THAUM_ASSERT(ZSTD_isError(size) == 0, "zstd cannot pack a state that fits its buffer");
    return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

Bytes unpacked(const Bytes& packed) {
    Bytes out(ZSTD_getFrameContentSize(packed.data(), packed.size()));
    const auto size = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
    THAUM_ASSERT(size == out.size(), "a state that this program has packed does not unpack");
    return out;
}

}  // namespace

// Filling ---------------------------------------------------------------------------------------------------

ReplayIndex::ReplayIndex(const Playback& at_start, std::size_t max_bytes) : max_bytes_(max_bytes) {
    THAUM_ASSERT(at_start.match().now() == 0, "an index begins at the first tick");
    add_state(at_start.match());
}

void ReplayIndex::add_state(const Simulation& match) {
    const auto at = match.now();
    // This needs no lock, because only this thread changes the distance between stored states.
    if (at % spacing_ != 0) return;
    Bytes state;
    match.save(state);
    auto kept = std::make_shared<const Bytes>(packed(state));
    const std::scoped_lock lock(mutex_);
    bytes_ += kept->size();
    keyframes_.push_back({at, std::move(kept)});
    while (bytes_ > max_bytes_ && keyframes_.size() > 1) {
        spacing_ *= 2;
        std::erase_if(keyframes_, [&](const Keyframe& k) {
            const bool drop = k.at % spacing_ != 0;
            if (drop) bytes_ -= k.packed->size();
            return drop;
        });
    }
}

/// Adds new kills to the index, and the first difference between replay and record.
void ReplayIndex::look(const Playback& playback, std::uint64_t& events_seen) {
    const auto now = playback.match().now();
    playback.match().events().each_new(events_seen, [&](const Event& event) {
        if (event.kind != EventKind::death) return;
        const std::scoped_lock lock(mutex_);
        kills_.push_back({now, event.subject, event.by});
    });
    if (playback.divergence() && !divergence_) {
        const std::scoped_lock lock(mutex_);
        divergence_ = playback.divergence();
    }
}

void ReplayIndex::fill(Playback playback, const std::atomic<bool>& stop) {
    std::uint64_t events_seen = 0;
    look(playback, events_seen);
    while (!stop && playback.step()) {
        const auto now = playback.match().now();
        if (now % keyframe_interval == 0) add_state(playback.match());
        look(playback, events_seen);
        reached_ = now;
    }
    complete_ = true;
}

// Reading ---------------------------------------------------------------------------------------------------

bool ReplayIndex::covers(Tick target) const {
    const std::scoped_lock lock(mutex_);
    return reached_ >= target - target % spacing_;
}

std::vector<Kill> ReplayIndex::kills() const {
    const std::scoped_lock lock(mutex_);
    return kills_;
}

std::optional<Divergence> ReplayIndex::divergence() const {
    const std::scoped_lock lock(mutex_);
    return divergence_;
}

std::size_t ReplayIndex::bytes() const {
    const std::scoped_lock lock(mutex_);
    return bytes_;
}

Tick ReplayIndex::spacing() const {
    const std::scoped_lock lock(mutex_);
    return spacing_;
}

ReplayIndex::Keyframe ReplayIndex::newest_before(Tick target) const {
    const std::scoped_lock lock(mutex_);
    const auto after = std::upper_bound(keyframes_.begin(), keyframes_.end(), target,
                                        [](Tick t, const Keyframe& k) { return t < k.at; });
    return *std::prev(after);
}

Expected<void> seek(Playback& playback, const ReplayIndex& index, Tick target,
                    const std::atomic<bool>& stop) {
    const auto keyframe = index.newest_before(target);
    const auto now = playback.match().now();
    if (now > target || now < keyframe.at) {
        if (auto restored = playback.restore(unpacked(*keyframe.packed), keyframe.at); !restored)
            return restored;
    }
    while (!stop && playback.match().now() < target && playback.step()) {}
    return {};
}

std::optional<Divergence> earlier(const std::optional<Divergence>& a, const std::optional<Divergence>& b) {
    if (!a || !b) return a ? a : b;
    return a->recorded.tick <= b->recorded.tick ? a : b;
}

}  // namespace thaum::game::inline match
