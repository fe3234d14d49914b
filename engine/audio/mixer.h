// audio/mixer.h: turns audio frames into stereo samples, for one or two listeners.
//
//     Mixer mixer = *Mixer::create(bank, settings);
//     mixer.play(frame, block);     // every 8 ms: 384 samples for each of two channels, interleaved
//
// Each listener has a loopback device of OpenAL, which renders into memory: OpenAL has one listener for each
// context. OpenAL pans, resamples and filters. This class decides which voices are heard and how loud, adds
// the listeners, and limits the sum. No clock and no thread is involved, so equal calls give equal samples.
//
// Gain of a voice with a place: gain * fader * distance_gain. A sound straight to one side is played with
// this gain on that side, and a sound in front with 0.6 of this gain on both sides. A voice at the ear is
// played with 0.71 of this gain on both sides.
#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "audio/frame.h"
#include "audio/sound.h"
#include "core/error.h"

namespace thaum::audio {

/// Voices that one listener can hear at a time. If there are more, the quietest are left out.
inline constexpr std::size_t max_heard = 64;
/// Voices that may begin in one block, including those of its frame.
inline constexpr std::size_t max_begins = 256;
inline constexpr std::size_t block_values = 2 * frame_samples;

/// How two listeners share the two speakers.
enum class Ears : std::uint8_t {
    shared,      ///< both speakers play both listeners, each 3 dB quieter
    left_right,  ///< the left speaker plays the first listener, the right speaker the second
};

/// Faders from 0 to 1. The gain is the fader's square, so that a fader at one half sounds about half as loud.
struct MixSettings {
    double master{1};
    double effects{1};
    double music{1};
    double interface { 1 };
    bool headphones{};  ///< true: places sounds around the head (HRTF) while one player listens
    Ears ears{};
};

/// Counts since the mixer was made, except where noted.
struct MixReport {
    std::uint64_t blocks{};
    /// Blocks that were mixed by `run_on`, because no new frame had come.
    std::uint64_t blocks_without_frame{};
    std::uint32_t voices{};  ///< voices heard in the last block, by all listeners together
    std::uint64_t begun{};   ///< voices that got a source of OpenAL, which plays them
    std::uint64_t stolen{};  ///< voices that lost their source of OpenAL to louder voices
    /// Audible voices without a source, summed over blocks, and voices for which a frame or max_begins had
    /// no room.
    std::uint64_t left_out{};
    std::uint64_t limited_blocks{};  ///< blocks in which the limiter made the sum quieter
    std::uint64_t bad_values{};      ///< invalid values that were replaced
    bool hrtf{};                     ///< true while the first listener is heard through HRTF
};

/// Share of a sound's loudness that is left at a distance: 1 up to near_m, 0 from reach_m on, between them
/// the inverse law shifted so that it ends at 0.
double distance_gain(double distance_m, double near_m, double reach_m);

/// Gain of a fader; values outside 0 to 1 are clipped.
double fader_gain(double fader);

/// Sets OpenAL's environment variables, once for the process. The first mixer calls it, too. A program whose
/// other threads run before that must call it earlier, while one thread runs, because changing the
/// environment is not safe beside other threads.
void prepare_openal();

/// Mixes the frame's voices into blocks of samples.
class Mixer {
public:
    /// Copies the samples of the bank. The error is one line: OpenAL is missing or lacks loopback devices.
    static Expected<Mixer> create(const SoundBank& bank, const MixSettings& settings);
    Mixer(Mixer&& other) noexcept;
    Mixer& operator=(Mixer&& other) noexcept;
    ~Mixer();

    /// Adds a voice that begins with the next block. The voice is dropped if max_begins voices are already
    /// waiting.
    void begin(const Voice& voice);
    /// Mixes the next block: begins the frame's voices, updates the lasting ones and ends those that are
    /// missing from the frame. `stereo` has block_values values, left and right in turn; none is outside -1
    /// to 1.
    void play(const AudioFrame& frame, std::span<float> stereo);
    /// Mixes the next block without a new frame: all voices continue.
    void run_on(std::span<float> stereo);
    /// Changes the settings within the next block, without a click.
    void set(const MixSettings& settings);
    /// Ends all voices at once. Call it before playing again after a pause in which nobody heard the mixer.
    void silence();

    /// Counts of what was mixed so far, and of faulty input.
    const MixReport& report() const;

private:
    struct State;
    explicit Mixer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace thaum::audio
