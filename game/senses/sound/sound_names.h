// game/senses/sound/sound_names.h: the sounds that events and wands name in their data files, looked up in
// the bank once.
#pragma once
#include <array>
#include <vector>

#include "game/components/power_up.h"
#include "game/data/presentation.h"
#include "game/senses/sound/cues.h"

namespace thaum::game::inline senses {

struct WandSoundNumbers {
    SoundNumber fire, burst, take, ready, hold;
};

/// Numbers of all sounds of a match among the loaded sounds (the bank).
struct MatchSounds {
    CueSounds cues{};
    /// Sounds of events, indexed by EventKind; not those of power-ups and spells.
    std::vector<SoundNumber> events;
    std::array<SoundNumber, power_up_names.size()> power_ups{};
    std::vector<SoundNumber> spells;      ///< sounds of spells, indexed by the spell's number
    std::vector<WandSoundNumbers> wands;  ///< sounds of wands, in the order of Presentation::wands
    /// Sounds that are missing among the loaded ones (the bank). Sounds with a fault are not listed: the bank
    /// reports those.
    std::vector<MissingName> missing{};
};

/// Looks up all sounds. A missing or faulty sound is silent, and does not affect the others.
MatchSounds match_sounds(const audio::SoundBank& bank, const Presentation& shown);

}  // namespace thaum::game::inline senses
