// audio/sound_device.h: what plays the samples: a sound card, or a fake in tests.
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "core/error.h"

namespace thaum::audio {

/// A device that takes stereo blocks of 384 samples at 48 kHz. One thread calls all functions. `open` and `close` may
/// take long; the others must not.
class SoundDevice {
public:
    virtual ~SoundDevice() = default;
    /// Opens the device, or opens it again. The error is one line.
    virtual Expected<void> open() = 0;
    /// Number of blocks that the device takes now. A block that it has taken begins to sound after one more block,
    /// unless the device plays in longer periods or had gaps.
    virtual std::size_t wanted() = 0;
    /// Queues one block: block_values values (audio/mixer.h), left and right in turn.
    virtual void write(std::span<const float> block) = 0;
    /// False once the device is gone, such as headphones that were pulled out.
    virtual bool is_connected() = 0;
    virtual void close() = 0;
};

/// The system's usual device, by OpenAL. It plays at any rate; OpenAL resamples.
std::unique_ptr<SoundDevice> openal_device();

}  // namespace thaum::audio
