// game/sound/sound_names.h: the sounds that events and wands name in their data files, found in the bank once.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "game/components/power_up.h"
#include "game/data/presentation.h"
#include "game/sound/cues.h"

namespace thaum::game {

/// Number of a sound in the bank; std::nullopt: silence.
using SoundNumber = std::optional<std::uint32_t>;

struct WandSoundNumbers {
    SoundNumber fire, burst, take, ready, hold;
};

/// Numbers of all sounds of a match.
struct MatchSounds {
    CueSounds cues{};
    std::vector<SoundNumber> events;  ///< by EventKind; without those of power-ups
    std::array<SoundNumber, power_up_names.size()> power_ups{};
    std::vector<WandSoundNumbers> wands;  ///< in the order of Presentation::wands
};

/// The error names the sound that is missing, and who names it.
Expected<MatchSounds> match_sounds(const audio::SoundBank& bank, const Presentation& shown);

}  // namespace thaum::game
