// audio/playback.h: keeps a sound device fed with mixed blocks. It has no thread and no clock
// (audio/speakers.h has both).
//
//     simulation thread --frames--> queue --+
//     main thread ------voices----> queue --+--> step(): mix, write --> device
//     main thread ------settings--> newest -+
//
// A device plays by its own clock, so frames come too early or too late. Frames that wait together are
// merged: all their beginning voices begin, and the newest frame gives the lasting voices. While no frame
// waits, the mixer continues with the voices that it has.
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

/// Counts of blocks and frames since the start.
struct PlaybackReport {
    MixReport mix;
    std::uint64_t blocks_written{};
    std::uint64_t frames_merged{};  ///< frames that were merged into a newer one
    std::uint64_t times_opened{};
    std::uint64_t times_lost{};
};

/// Plays frames on a sound device. The thread that feeds the device calls `step`.
class Playback {
public:
    static constexpr double retry_s = 2;  ///< time between two tries to open a device (s)
    /// A device that takes no block for this long is given up (s).
    static constexpr double patience_s = 1;
    /// Time without frames after which lasting voices fade out (s).
    static constexpr double late_after_s = 0.2;

    Playback(Mixer mixer, std::unique_ptr<SoundDevice> device);

    /// Queues a frame; called by the simulation thread. Returns false if the queue is full, which happens
    /// while the thread that feeds the device takes no frames.
    bool hear(const AudioFrame& frame) { return frames_.push(frame); }

    /// Queues a voice that begins, such as a sound of the menu; called by the main thread. Returns false if
    /// the queue is full.
    bool hear(const Voice& voice) { return voices_.push(voice); }
    /// Changes the faders and the way two listeners share the speakers from the next step on; called by the
    /// main thread.
    void set(const MixSettings& settings);

    /// Whether a device plays; if not, frames need not be made. Any thread may ask.
    bool plays() const { return plays_; }
    /// One line: that sound plays, or why none does; empty until the first try to open a device. A report
    /// that is read after the status is at least as recent as the status.
    std::string status() const;
    /// Counts of blocks and frames since the start. Any thread may ask.
    PlaybackReport report() const;
    /// Lets `step` return as soon as a blocking call of the device returns, without calling the device again.
    void abandon() { abandoned_ = true; }

    /// Does what is due at the time `now_s` and returns the time until the next step (s). Called by
    /// the thread that feeds the device.
    double step(double now_s);
    /// Closes the device. The thread that feeds the device must call it last.
    void close();

private:
    /// Largest number of blocks that are written in one step.
    static constexpr std::size_t max_at_once = 24;

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
    mutable std::mutex told_;  ///< guards the members that other threads set or read
    std::string status_{};
    PlaybackReport published_;

    std::atomic<bool> abandoned_{};
    Mixer mixer_;
    std::unique_ptr<SoundDevice> device_;
    PlaybackReport report_;
    /// A frame without voices, with the listeners of the newest frame; played when frames stay away, so that
    /// lasting voices fade out.
    AudioFrame quiet_;
    bool open_{};
    double next_try_s_{};
    double last_step_s_{};
    double waited_s_{};  ///< time for which the device took no block
    double credit_{};    ///< number of blocks that real time still allows the device to take
    std::size_t blocks_without_frame_{};
};

}  // namespace thaum::audio
