// game/settings/own_gestures.h: gestures that players recorded themselves, one file for each gesture and
// player, in the folder `gestures` beside the settings file:
//
//     gestures/PLAYER/GESTURE.toml     PLAYER is the player's name, or player-1 and player-2
//
// A match uses the text of these files unchanged, and its log stores that text (game/match/own_gestures.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "game/match/own_gestures.h"
#include "game/settings/settings.h"

namespace thaum::game::inline settings {

/// Result of the check of a gesture that the player has recorded on the practice range.
enum class Verdict : std::uint8_t {
    none,    ///< nothing was recorded
    kept,    ///< accepted, and used from now on
    refused  ///< not accepted; the player may draw it again
};

/// Recorded gestures with which the practice range continues, and a message for its player.
struct OwnGestures {
    std::vector<input::ProfileData> profile{};
    std::vector<std::string> words{};
    Verdict verdict{};
};

/// Folder of a player's recorded gestures; empty if there is no settings file.
std::filesystem::path own_gestures_folder(const std::filesystem::path& settings_file,
                                          const Settings& settings, std::size_t player);

/// Recorded gestures of a player that suit the match's data and one another. Others are left out; `faults`
/// receives a line for each.
std::vector<input::ProfileData> load_own_gestures(const std::filesystem::path& folder, const MatchData& data,
                                                  std::uint32_t player, std::vector<std::string>& faults);

/// Writes a gesture, replacing one of the same name.
Expected<void> save_own_gesture(const std::filesystem::path& folder, const gesture::Gesture& gesture);
/// Deletes a player's recorded gesture, so that the shipped one is used again. Returns whether there was one.
bool forget_own_gesture(const std::filesystem::path& folder, const std::string& name);

/// The recorded gestures of all players, with this gesture of one player added or in place of an older one of
/// the same name.
std::vector<input::ProfileData> with_own_gesture(std::vector<input::ProfileData> profile,
                                                 const gesture::Gesture& gesture, std::uint32_t player);

/// Refuses a gesture that cannot be used together with the player's other gestures. Also refuses one that is
/// so similar to another that strokes would be mistaken (gesture/collisions.h). The error names that other
/// one: "it is too like V: 12 % of such strokes are taken for it". `profile`: recorded gestures so far.
Expected<void> check_own_gesture(const gesture::Gesture& gesture, const MatchData& data,
                                 const std::vector<input::ProfileData>& profile, std::uint32_t player);

}  // namespace thaum::game::inline settings
