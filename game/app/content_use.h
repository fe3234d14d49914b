// game/app/content_use.h: finds data that can be read but not used: costs that no player can pay, potions
// that cannot be brewed in any arena, names that two things share.
#pragma once
#include <span>
#include <vector>

#include "game/data/match_data.h"

namespace thaum::game::inline app {

/// What was found, each entry with the key that it is about.
struct UseFindings {
    std::vector<MissingName> faults;  ///< faults that the game cannot work with
    std::vector<MissingName> notes;   ///< the game plays without it, but it is probably not meant
};

/// Checks the data of matches, which must be free of reading errors. Every arena must appear at least once.
UseFindings find_unusable(std::span<const MatchData> readings);

}  // namespace thaum::game::inline app
