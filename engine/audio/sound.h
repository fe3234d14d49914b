// audio/sound.h: sounds as samples in memory, found by name.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace thaum::audio {

/// Sample rate of all sounds and of the mix (Hz).
inline constexpr std::uint32_t sample_rate = 48'000;

/// Group to which a sound belongs. Each group has a fader of its own.
enum class SoundGroup : std::uint8_t { effects, music, interface };
inline constexpr std::size_t sound_groups = 3;

/// One sound. Its samples are mono, with values from -1 to 1.
struct Sound {
    std::string name;
    std::string description;  ///< plain description for a table of all sounds
    std::string caption{};    ///< words on the screen for people who do not hear the sound; empty: none
    bool important{};         ///< true: the caption is shown even to players who want few captions
    SoundGroup group{};
    bool loops{};  ///< true: the sound repeats without end; its last sample leads to its first without a step
    double near_m{1.5};  ///< distance up to which the sound has its full loudness (m)
    double reach_m{40};  ///< distance beyond which the sound is silent and costs no time (m)
    std::vector<float> samples;
};

/// All sounds of a program, sorted by name. Voices name a sound by its number, which is its index here.
struct SoundBank {
    std::vector<Sound> sounds;
    /// Recipes (descriptions of sounds in data files) that were left out because of their faults, sorted by
    /// name.
    std::vector<LeftOut> faulty{};

    /// Returns the number of the sound with this name; std::nullopt: there is none.
    std::optional<std::uint32_t> find(std::string_view name) const;
};

}  // namespace thaum::audio
