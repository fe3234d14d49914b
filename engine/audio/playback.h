// audio/playback.h: keeps a sound device fed with mixed blocks. It has no thread and no clock (audio/speakers.h has).
//
//     simulation thread --frames--> queue --+
//     main thread ------voices----> queue --+--> step(): mix, write --> device
//     main thread ------settings--> newest -+
//
// A device plays by its own clock, so frames come too early or too late. Several that wait become one: all their
// beginning voices begin, and the newest says what lasts. Where none waits, the mixer goes on with what it has.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "audio/mixer.h"
#include "audio/sound_device.h"
#include "core/spsc_queue.h"
#include "core/triple_buffer.h"

namespace thaum::audio {

/// Counts since the start.
struct PlaybackReport {
    MixReport mix;
    std::uint64_t blocks_written{};
    std::uint64_t frames_merged{};  ///< frames whose beginning voices were given to a newer frame
    std::uint64_t times_opened{};
    std::uint64_t times_lost{};
};

class Playback {
public:
    static constexpr double retry_s = 2;         ///< time between two tries to open a device
    static constexpr double patience_s = 1;      ///< a device that takes no block for so long is given up
    static constexpr double late_after_s = 0.2;  ///< without frames for so long, lasting voices fade out

    Playback(Mixer mixer, std::unique_ptr<SoundDevice> device);

    // The simulation thread.
    /// Queues a frame. Returns false if the queue is full: the device is not fed at the moment.
    bool hear(const AudioFrame& frame) { return frames_.push(frame); }

    // The main thread.
    /// Queues a voice that begins, such as a sound of the menu. Returns false if the queue is full.
    bool hear(const Voice& voice) { return voices_.push(voice); }
    void set(const MixSettings& settings);

    // Any thread.
    /// Whether a device plays. Frames for no device need not be made.
    bool plays() const { return plays_; }
    /// One line: what plays, or why nothing does; empty until the first try to open a device. A report that is asked for
    /// after it is not older.
    std::string status() const;
    PlaybackReport report() const;
    /// Lets `step` return as soon as a blocking call of the device does, without any further call.
    void abandon() { abandoned_ = true; }

    // The thread that feeds the device.
    /// Does what is due at the time `now_s` and returns the time until the next step (s).
    double step(double now_s);
    void close();

private:
    /// Blocks that are ready to be written at once.
    static constexpr std::size_t most_at_once = 24;

    void try_open(double now_s);
    void lose(double now_s, std::string_view why);
    void drop_waiting();
    std::size_t allowed(std::size_t wanted, double now_s);
    void feed(std::size_t blocks);
    void mix_block(std::size_t blocks_left, std::span<float> block);
    void say(std::string status);
    void publish_report();

    SpscQueue<AudioFrame, 64> frames_;
    SpscQueue<Voice, 64> voices_;
    TripleBuffer<MixSettings> settings_{MixSettings{}};

    std::atomic<bool> plays_{};
    mutable std::mutex told_;  ///< guards what other threads ask for
    std::string status_{};
    PlaybackReport published_;

    std::atomic<bool> abandoned_{};
    Mixer mixer_;
    std::unique_ptr<SoundDevice> device_;
    PlaybackReport report_;
    AudioFrame quiet_;  ///< the newest listeners without voices
    bool open_{};
    double next_try_s_{};
    double last_step_s_{};
    double waited_s_{};  ///< time for which the device took no block
    double credit_{};    ///< blocks that the device may still take
    std::size_t blocks_without_frame_{};
};

}  // namespace thaum::audio
