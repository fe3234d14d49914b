// audio/speakers.h: plays audio frames on the system's sound device, in a thread of its own.
//
// The delay of an event's sound is at most 8 ms until its frame is full, 8 ms until the device wants the next
// block, 2 ms until this thread looks, 8 ms while the block before is played, and 2 ms in the limiter: 28 ms,
// plus the delay of the device itself. A device that had gaps gets one block more, which makes 36 ms.
//
// Without a device nothing is heard, and the thread tries again every two seconds. A device may block its
// caller for ever, so the destructor waits for the thread for `max_wait_s` only (core/step_thread.h). A
// thread that is abandoned does not call OpenAL again, because the program may be ending.
#pragma once
#include <memory>
#include <string>

#include "audio/playback.h"
#include "core/step_thread.h"

namespace thaum::audio {

/// A sound device with the thread that plays on it.
class Speakers {
public:
    static constexpr double max_wait_s = 1.5;

    /// Starts the thread, which opens the device and feeds it.
    explicit Speakers(Mixer mixer, std::unique_ptr<SoundDevice> device = openal_device(),
                      double wait_s = max_wait_s);

    /// Queues a frame; the simulation thread calls it every 8 ms. Never waits.
    bool hear(const AudioFrame& frame);
    /// Queues a voice that begins; the main thread calls it. Never waits.
    bool hear(const Voice& voice);
    /// Changes the faders and the way two listeners share the speakers; the main thread calls it. Never
    /// waits.
    void set(const MixSettings& settings);
    /// Whether a device plays; if not, frames need not be made. Any thread may ask.
    bool plays() const;
    /// One line: that sound plays, or why not; empty until the first try to
    /// open a device. Any thread may ask.
    std::string status() const;
    /// Counts of blocks and frames since the start. Any thread may ask.
    PlaybackReport report() const;

private:
    StepThread<Playback> thread_;
};

}  // namespace thaum::audio
