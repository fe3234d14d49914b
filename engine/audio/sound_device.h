// audio/sound_device.h: the device that plays the samples: a sound card, or a fake one in tests.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::audio {

/// A device that takes blocks of 384 samples for each channel at 48 kHz; stereo unless stated otherwise. One
/// thread calls all functions. `open` and `close` may take long; the others must not.
class SoundDevice {
public:
    virtual ~SoundDevice() = default;
    /// Opens the device, or opens it again. The error is one line.
    virtual Expected<void> open() = 0;
    /// Number of blocks that the device takes now. A block that it has taken is heard after one more block,
    /// unless the device plays in longer periods or had gaps.
    virtual std::size_t wanted() = 0;
    /// Queues one block: a value for each channel in turn, so block_values values (audio/mixer.h) for stereo.
    virtual void write(std::span<const float> block) = 0;
    /// False once the device is gone, such as headphones that were pulled out.
    virtual bool is_connected() = 0;
    /// Stops and closes the device.
    virtual void close() = 0;
};

/// The system's default device, through OpenAL. It may have any sample rate; OpenAL resamples.
std::unique_ptr<SoundDevice> openal_device();

/// A device by OpenAL whose channels each play to their own speaker, with nothing mixed or placed. `name`:
/// one of sound_device_names, or empty for the default device. `channels`: 2, or 8 in the order of
/// surround_channels (audio/channels.h).
std::unique_ptr<SoundDevice> openal_channels(std::string name, std::size_t channels);

/// Names of the devices that OpenAL finds.
std::vector<std::string> sound_device_names();

}  // namespace thaum::audio
