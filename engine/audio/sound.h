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

/// Each group has a fader of its own.
enum class SoundGroup : std::uint8_t { effects, music, interface };
inline constexpr std::size_t sound_groups = 3;

/// One sound. Its samples are mono and lie within -1 to 1.
struct Sound {
    std::string name;
    std::string description;  ///< plain words for a table of what is heard
    std::string caption{};    ///< words on the screen for people who do not hear the sound; empty: none
    bool important{};         ///< true: the caption is shown even to those who want few
    SoundGroup group{};
    bool loops{};  ///< true for a sound without an end; its last sample leads to its first without a step
    double near_m{1.5};  ///< distance within which the sound is not louder (m)
    double reach_m{40};  ///< distance beyond which the sound is not heard and costs nothing (m)
    std::vector<float> samples;
};

/// All sounds of a program, sorted by name. A sound's number is its index.
struct SoundBank {
    std::vector<Sound> sounds;
    std::vector<LeftOut> faulty{};  ///< sounds that are left out, sorted by name

    /// Returns the number of the sound of this name, or nothing.
    std::optional<std::uint32_t> find(std::string_view name) const;
};

}  // namespace thaum::audio
