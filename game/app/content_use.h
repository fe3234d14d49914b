// game/app/content_use.h: finds data that can be read but not used: costs that no player can pay, potions
// that cannot be brewed in any arena, names that two things share.
#pragma once
#include <span>
#include <vector>

#include "game/data/match_data.h"

namespace thaum::game::inline app {

/// Findings about data that cannot be used. Each entry has the key that it is about.
struct UseFindings {
    std::vector<MissingName> faults;  ///< faults that the game cannot work with
    std::vector<MissingName> notes;   ///< probable mistakes with which the game can be played all the same
};

/// Checks the data of matches, which must be free of reading errors. Every arena must appear at least once.
UseFindings find_unusable(std::span<const MatchData> readings);

}  // namespace thaum::game::inline app
