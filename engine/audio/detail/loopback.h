// audio/detail/loopback.h: one loopback device of OpenAL with the sounds of a
// bank and a fixed pool of sources.
//
// OpenAL allocates when a source gets a new buffer. So there are four sources for each voice that may be
// heard. Each keeps its buffer, and a sound takes a free source that already has its buffer, if there is one.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "audio/detail/openal.h"
#include "audio/sound.h"
#include "core/maths.h"

namespace thaum::audio::detail {

class Loopback {
public:
    static constexpr std::uint32_t pool_size = 256;
    /// Greatest number of sources that play at a time.
    static constexpr std::uint32_t max_at_once = 192;

    /// Opens a device with the sounds of the bank. The error is one line.
    static Expected<std::unique_ptr<Loopback>> open(const SoundBank& bank, bool hrtf);
    ~Loopback();
    Loopback(const Loopback&) = delete;
    Loopback& operator=(const Loopback&) = delete;

    /// True if HRTF is on.
    bool hrtf() const { return hrtf_; }
    /// Turns HRTF on or off; hrtf() tells whether it succeeded. Sources keep playing; the sound may jump.
    void set_hrtf(bool wanted);
    /// Renders frame_samples samples (8 ms) for two channels.
    void render(std::span<float> stereo);

    // In the functions below, `source` is an index into the pool. Each call must be made while a scope
    // returned by `enter` exists, which makes the OpenAL context current.
    ContextScope enter() const { return {al_, context_}; }
    /// Returns a free source, with the buffer of the sound attached.
    std::uint32_t take(std::uint32_t sound);
    /// Stops a source and frees it.
    void give_back(std::uint32_t source);
    bool has_ended(std::uint32_t source) const;
    void set_gain(std::uint32_t source, double gain) const;
    void set_pitch(std::uint32_t source, double pitch) const;
    /// Sets the position of a source relative to the listener: right, up and backwards (m).
    void set_place(std::uint32_t source, fvec3 place) const;
    /// Sets the damping of high tones of a source, from 0 (none) to 1 (as behind walls).
    void set_muffled(std::uint32_t source, double muffled) const;
    /// Sets the sample at which a source starts. If it is not the first sample, the source fades in within
    /// the first block.
    void set_start(std::uint32_t source, std::uint32_t sample) const;
    void start(std::span<const std::uint32_t> sources) const;
    /// Changes made between `begin_changes` and `end_changes` take effect together.
    void begin_changes() const { defer_(); }
    void end_changes() const { process_(); }

private:
    struct Source {
        ALuint name{};
        std::uint32_t sound{};
        bool has_sound{};
        bool busy{};
        std::uint64_t freed{};  ///< counter value at which the source became free, to reuse the oldest first
    };

    explicit Loopback(const OpenAl& al) : al_(al) {}
    Expected<void> make_context(bool hrtf);
    Expected<void> upload(const SoundBank& bank);
    Expected<void> make_sources();
    void attach(Source& source, std::uint32_t sound);
    /// Plays as many sources as will ever play at once, silently, so that OpenAL allocates its memory now and
    /// not during play.
    void warm_up();
    void read_hrtf();
    std::vector<ALCint> attributes(bool hrtf) const;

    OpenAl al_;
    ALCdevice* device_{};
    ALCcontext* context_{};
    LPALDEFERUPDATESSOFT defer_{};
    LPALPROCESSUPDATESSOFT process_{};
    LPALFILTERF set_filter_{};
    ALuint filter_{};
    bool hrtf_{};
    std::uint64_t moment_{};
    std::vector<ALuint> buffers_;
    std::vector<bool> loops_;
    std::array<Source, pool_size> pool_{};
};

}  // namespace thaum::audio::detail
