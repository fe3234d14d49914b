// game/jackets/makers/audio.h: speakers or shakers that are worn on the body, on the channels of a sound
// device. Each actuator of the layout is one channel. It plays a sine wave with the amplitude and the
// frequency that the present frame (the values of all actuators) has for the actuator (audio/channels.h).
//
// The device is fed in blocks of 8 ms. A wave ends within a block after its frame's time to live, even if no
// further frame comes. If the thread that feeds the device stops, the device plays on for at most 0.2 s.
#pragma once
#include <memory>
#include <string>

#include "audio/sound_device.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// Output on a sound device, which must have `channels` channels: 2, or 8 in the order of
/// audio::surround_channels. `name`: name of the output in messages.
std::unique_ptr<input::TactileOutput> audio_jacket(std::string name, std::size_t channels,
                                                   std::unique_ptr<audio::SoundDevice> device);

}  // namespace thaum::game::inline jackets
