// audio/frame.h: what is heard, as plain data. One frame covers eight ticks (8 ms) of a match.
//
//     simulation -> AudioFrame every 8 ms -> Mixer -> samples -> Speakers, or a WAV file
//
// A frame lists the sounds that begin in it and those that last. A frame holds no samples and no pointers, so
// it can be passed between threads, and equal frames give equal samples.
#pragma once
#include <array>
#include <cstdint>

#include "audio/sound.h"
#include "core/maths.h"
#include "core/units.h"

namespace thaum::audio {

inline constexpr Tick frame_ticks = 8;
/// Samples of one frame (8 ms) for each channel.
inline constexpr std::size_t frame_samples = sample_rate * frame_ticks / ticks_per_second;
static_assert(frame_samples == 384);

inline constexpr std::size_t max_listeners = 2;

/// Ears of one player. `forward` and `up` are orthogonal unit vectors.
struct Listener {
    vec3 position{};  ///< position of the ears (m, world)
    vec3 forward{0, 0, -1};
    vec3 up{0, 1, 0};
};

/// One sound at one place.
struct Voice {
    std::uint32_t sound{};  ///< number in the SoundBank
    /// Identifies a lasting voice from frame to frame; not used by voices that play once.
    std::uint32_t key{};
    std::uint32_t heard_by{3};  ///< bit i: listener i hears the voice
    bool at_ear{};              ///< true: the voice has no place, and is equally loud everywhere
    /// True: played at the ear, but the caption names the side on which `position` lies.
    bool sided{};
    vec3 position{};  ///< position of the sound (m, world)
    double gain{1};   ///< gain of the voice, 0 to 1
    double pitch{1};  ///< speed of playing, 0.25 to 4
    /// Damping of high tones by walls for each listener, 0 to 1.
    std::array<double, max_listeners> muffled{};
};

/// A list of fixed capacity. It counts the voices that do not fit.
template <std::size_t N>
struct VoiceList {
    std::array<Voice, N> voices{};
    std::uint32_t count{};
    std::uint32_t left_out{};

    /// Adds a voice; counts it in `left_out` if there is no room.
    void add(const Voice& voice) {
        if (count < N)
            voices[count++] = voice;
        else
            ++left_out;
    }
    const Voice* begin() const { return voices.data(); }
    const Voice* end() const { return voices.data() + count; }
};

/// Listeners and voices of one frame of 8 ms.
struct AudioFrame {
    std::uint32_t listener_count{1};  ///< number of listeners, 1 or 2
    std::array<Listener, max_listeners> listeners{};
    VoiceList<32> begins;  ///< voices that begin in this frame and play to the end of their sound
    /// Voices of looping sounds. A voice that is missing from a later frame fades out within that frame.
    VoiceList<32> lasts;
};

}  // namespace thaum::audio
