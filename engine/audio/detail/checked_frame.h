// audio/detail/checked_frame.h: replaces wrong values of an audio frame (listeners and voices of 8 ms), so
// that the mixer can use every value.
#pragma once
#include <span>
#include <vector>

#include "audio/frame.h"
#include "audio/mixer.h"

namespace thaum::audio::detail {

/// Properties of a sound, without its samples, that the mixer needs.
struct SoundFacts {
    SoundGroup group{};
    bool loops{};
    double near_m{};
    double reach_m{};
    std::uint32_t samples{};  ///< length of the sound (samples); 0: it cannot be played
};

/// Returns the facts of all sounds. Impossible distances are replaced by the defaults and counted in
/// `bad_values`.
std::vector<SoundFacts> facts_of(const SoundBank& bank, std::uint64_t& bad_values);

/// Clips the values of a voice and counts those that were wrong. Returns false if the voice must be left out:
/// its sound does not exist, the sound loops although the voice plays only once, the sound does not loop
/// although the voice lasts, or the voice's position is NaN.
bool check_voice(Voice& voice, bool lasting, std::span<const SoundFacts> sounds, std::uint64_t& bad_values);

/// Makes the axes of a listener (forward and up) orthogonal unit vectors. Instead of a listener with invalid
/// values, returns `before`, the same listener in the last frame.
Listener checked_listener(const Listener& listener, const Listener& before, std::uint64_t& bad_values);

/// Clips the settings to what the mixer can use.
MixSettings checked_settings(const MixSettings& settings, std::uint64_t& bad_values);

}  // namespace thaum::audio::detail
