// game/senses/sound/sound_names.h: the sounds that events and wands name in their data files, found in the bank once.
#pragma once
#include <array>
#include <vector>

#include "game/components/power_up.h"
#include "game/data/presentation.h"
#include "game/senses/sound/cues.h"

namespace thaum::game {

struct WandSoundNumbers {
    SoundNumber fire, burst, take, ready, hold;
};

/// Numbers of all sounds of a match.
struct MatchSounds {
    CueSounds cues{};
    std::vector<SoundNumber> events;  ///< by EventKind; without those of power-ups and spells
    std::array<SoundNumber, power_up_names.size()> power_ups{};
    std::vector<SoundNumber> spells;      ///< by number of the spell
    std::vector<WandSoundNumbers> wands;  ///< in the order of Presentation::wands
    /// Sounds that the bank lacks. Faulty sounds are not among them: the bank says why.
    std::vector<MissingName> missing{};
};

/// A missing or faulty sound is silence, and costs no other one.
MatchSounds match_sounds(const audio::SoundBank& bank, const Presentation& shown);

}  // namespace thaum::game
