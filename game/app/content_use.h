// game/app/content_use.h: data that can be read and yet not be used: costs that nobody can pay, potions that no arena lets
// brew, names that two things have.
#pragma once
#include <span>
#include <vector>

#include "game/data/match_data.h"

namespace thaum::app {

/// Findings, each with the key that it is about.
struct UseFindings {
    std::vector<game::MissingName> faults;  ///< the game cannot use this
    std::vector<game::MissingName> notes;   ///< the game plays without it, but it is probably not meant
};

/// Compares the data of matches, one with each arena at least, that were read without a fault.
UseFindings find_unusable(std::span<const game::MatchData> readings);

}  // namespace thaum::app
