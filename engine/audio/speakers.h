// audio/speakers.h: plays audio frames on the system's sound device, in a thread of its own.
//
// From an event to its sound pass at most 8 ms until its frame is full, 8 ms until the device wants the next block,
// 2 ms until this thread looks, 8 ms while the block before is played, and 2 ms in the limiter: 28 ms, and what the
// device itself delays. A device that had gaps gets one block more, so 36 ms.
//
// Without a device nothing is heard, and the thread tries again every two seconds. A device may block its caller for
// ever. Only this thread calls it, and the destructor waits for the thread for `most_wait_s` only. A thread that has
// not ended by then is left behind with all that it uses: it calls nothing more, and its memory stays until the program
// ends.
#pragma once
#include <memory>
#include <string>
#include <thread>

#include "audio/playback.h"

namespace thaum::audio {

class Speakers {
public:
    static constexpr double most_wait_s = 1.5;

    /// Starts the thread. Create the mixer before, so that OpenAL is prepared while one thread runs.
    explicit Speakers(Mixer mixer, std::unique_ptr<SoundDevice> device = openal_device(),
                      double wait_s = most_wait_s);
    ~Speakers();
    Speakers(const Speakers&) = delete;
    Speakers& operator=(const Speakers&) = delete;

    /// Queues a frame; the simulation thread calls it every 8 ms. Never waits.
    bool hear(const AudioFrame& frame);
    /// Queues a voice that begins; the main thread calls it. Never waits.
    bool hear(const Voice& voice);
    /// Changes faders and ears; the main thread calls it. Never waits.
    void set(const MixSettings& settings);
    /// Whether a device plays. Frames for no device need not be made. Any thread may ask.
    bool plays() const;
    /// One line: that sound plays, or why not; empty until the first try to open a device. Any thread may ask.
    std::string status() const;
    PlaybackReport report() const;

private:
    struct State;
    std::shared_ptr<State> state_;
    double wait_s_;
    std::jthread thread_;
};

}  // namespace thaum::audio
