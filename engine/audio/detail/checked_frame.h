// audio/detail/checked_frame.h: a frame whose every value the mixer can use, made of one that may be wrong.
#pragma once
#include <span>
#include <vector>

#include "audio/frame.h"
#include "audio/mixer.h"

namespace thaum::audio::detail {

/// A sound without its samples.
struct SoundFacts {
    SoundGroup group{};
    bool loops{};
    double near_m{};
    double reach_m{};
    std::uint32_t samples{};  ///< 0: the sound cannot be played
};

/// Facts of all sounds. Distances that make no sense become the usual ones and are counted.
std::vector<SoundFacts> facts_of(const SoundBank& bank, std::uint64_t& bad_values);

/// Clips the values of a voice and counts those that were wrong. Returns false if the voice must be left out: its sound
/// does not exist, loops when it should not or the other way, or its position is not a number.
bool check_voice(Voice& voice, bool lasting, std::span<const SoundFacts> sounds, std::uint64_t& bad_values);

/// Makes the axes orthogonal unit vectors. A listener that is not a number stays where it was.
Listener checked_listener(const Listener& listener, const Listener& before, std::uint64_t& bad_values);

/// Clips the settings to what the mixer can use.
MixSettings checked_settings(const MixSettings& settings, std::uint64_t& bad_values);

}  // namespace thaum::audio::detail
