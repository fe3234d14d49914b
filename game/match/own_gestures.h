// game/match/own_gestures.h: gestures that players recorded themselves. In a match a player's own gesture
// replaces the shipped one of the same name, with its strokes and its options.
//
// The setup of a match, the log and the player's profile hold the same bytes: the text of a gesture's file
// (gesture/gesture_file.h). So a replay does not need the profile.
#pragma once
#include "game/data/match_data.h"
#include "game/match/simulation.h"

namespace thaum::game::inline match {

/// Value of input::ProfileData::kind for gestures.
inline constexpr std::string_view gesture_kind = "gesture";

/// One gesture of a player in the form in which the log and the player's profile store it.
input::ProfileData profile_of(const gesture::Gesture& gesture, std::uint32_t player);

/// Gives the match in `setup` the players' own gestures. `profile` has them in the order of a log's profile
/// data. The error says which gesture of which player is wrong and why: invalid text, a name that differs, no
/// shipped gesture of this name, or too many points.
Expected<void> use_profile(const MatchData& data, std::vector<input::ProfileData> profile, MatchSetup& setup);

}  // namespace thaum::game::inline match
