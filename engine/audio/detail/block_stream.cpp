#include "audio/detail/block_stream.h"

#include <algorithm>
#include <cmath>

namespace thaum::audio::detail {

std::size_t blocks_to_queue(double period) {
    if (!(period > 0)) return BlockStream::min_queued;
    const double blocks = std::min(period / frame_samples, 1e3);
    // While a device plays the blocks of one period (the samples that it takes at a time), one more block is
    // being mixed. A period that is no multiple of a block ends within yet another block.
    const double needed = blocks == std::floor(blocks) ? blocks + 1 : std::floor(blocks) + 2;
    return std::clamp(static_cast<std::size_t>(needed), BlockStream::min_queued, BlockStream::max_queued);
}

BlockStream::BlockStream(std::size_t queued, std::size_t channels)
    : queued_(queued), format_(channels == 2 ? AL_FORMAT_STEREO_FLOAT32 : AL_FORMAT_71CHN32) {
    alGenSources(1, &source_);
    alGenBuffers(static_cast<ALsizei>(free_.size()), free_.data());
    // The block is mixed already, so each channel is played at its own speaker as it is.
    alSourcei(source_, AL_DIRECT_CHANNELS_SOFT, AL_TRUE);
}

void BlockStream::destroy() {
    alSourceStop(source_);
    take_back_played();
    alDeleteSources(1, &source_);
    alDeleteBuffers(static_cast<ALsizei>(free_count_), free_.data());
}

void BlockStream::take_back_played() {
    ALint played = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &played);
    const auto count = std::min(static_cast<std::size_t>(std::max(0, played)), waiting());
    if (count == 0) return;
    alSourceUnqueueBuffers(source_, static_cast<ALsizei>(count), free_.data() + free_count_);
    free_count_ += count;
}

std::size_t BlockStream::wanted() {
    take_back_played();
    ALint state = 0;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (playing_ && state != AL_PLAYING) {
        playing_ = false;
        alSourceRewind(source_);  // without this, blocks that are queued from here on would count as played
        queued_ = std::min(queued_ + 1, max_queued);
    }
    return queued_ - std::min(queued_, waiting());
}

void BlockStream::write(std::span<const float> block) {
    if (free_count_ == 0) return;
    const ALuint buffer = free_[--free_count_];
    alBufferData(buffer, format_, block.data(), static_cast<ALsizei>(block.size_bytes()),
                 static_cast<ALsizei>(sample_rate));
    alSourceQueueBuffers(source_, 1, &buffer);
    if (playing_ || waiting() < queued_) return;
    alSourcePlay(source_);
    playing_ = true;
}

}  // namespace thaum::audio::detail
