// audio/detail/block_stream.h: blocks of samples queued at a source of OpenAL.
#pragma once
#include <array>
#include <span>

#include "audio/detail/openal.h"
#include "audio/mixer.h"

namespace thaum::audio::detail {

/// Number of blocks to keep queued so that a device which takes `period` samples (at 48 kHz) at a time never
/// runs out.
std::size_t blocks_to_queue(double period);

/// Blocks of samples queued at one source. All functions act on the current context of OpenAL.
class BlockStream {
public:
    static constexpr std::size_t min_queued = 2, max_queued = 24;

    /// Makes the source. Up to `queued` blocks wait in it, and one more after each gap in playing, so that
    /// gaps become rare. `channels`: 2, or 8 in the order of surround_channels (audio/channels.h).
    explicit BlockStream(std::size_t queued, std::size_t channels = 2);
    void destroy();

    std::size_t wanted();
    /// Queues a block. Playing begins, and begins again after a gap in which no block was left, as soon as
    /// the queue is full.
    void write(std::span<const float> block);
    std::size_t queued() const { return queued_; }

private:
    void take_back_played();
    std::size_t waiting() const { return max_queued - free_count_; }

    std::size_t queued_;
    ALenum format_;
    bool playing_{};
    ALuint source_{};
    std::array<ALuint, max_queued> free_{};  ///< buffers that are not in the queue
    std::size_t free_count_{max_queued};
};

}  // namespace thaum::audio::detail
